#include "app/cli/MaterialOptions.h"
#include "app/cli/Verb.h"
#include "core/asset/Threshold.h"
#include "core/base/MessageText.h"
#include "core/fracture/PatternKind.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Without names all are listed, a line each. With names each is told with the range of its figures, where they are from, the depth
of cracks from which on toughness and not strength decides, and the pattern in which it usually breaks. A file in the folder that
cannot be used is told, the others are listed all the same, and the exit status is 1. One of your own with the name of one of the
program's takes its place.

Examples:
  rubble-cli materials
  rubble-cli materials glass ice
  rubble-cli materials --materials presets --json)";

constexpr double kPascalsOfMega = 1e6;
constexpr double kMillimetresOfMetre = 1e3;
constexpr int kDigits = 6;
constexpr int kDerivedDigits = 4;  // of what follows from figures

struct MaterialsOptions {
    std::vector<std::string> names;
    std::string folder;
    bool isJson = false;
};

/// A figure as people read it: its name, and by what it is divided for its unit.
struct Column {
    const char* name;
    const char* unit;
    double divisor;
    const PresetFigure* (*figure)(const MaterialPreset& preset);  // null: not told
};

constexpr Column kColumns[] = {
    {"density", "kg/m^3", 1.0, [](const MaterialPreset& preset) { return &preset.density; }},
    {"friction", "", 1.0, [](const MaterialPreset& preset) { return &preset.friction; }},
    {"restitution", "", 1.0, [](const MaterialPreset& preset) { return &preset.restitution; }},
    {"tensile strength", "MPa", kPascalsOfMega,
     [](const MaterialPreset& preset) { return preset.tensileStrength ? &*preset.tensileStrength : nullptr; }},
    {"fracture toughness", "MPa m^1/2", kPascalsOfMega,
     [](const MaterialPreset& preset) { return preset.fractureToughness ? &*preset.fractureToughness : nullptr; }},
};

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

std::string numberText(double value, const Column& column) { return roundedText(value / column.divisor, kDigits); }

std::string withUnit(const std::string& number, const Column& column) {
    return *column.unit != 0 ? number + " " + column.unit : number;
}

std::string cellText(const MaterialPreset& preset, const Column& column) {
    const PresetFigure* figure = column.figure(preset);
    return figure != nullptr ? withUnit(numberText(figure->value, column), column) : "-";
}

std::string listText(const std::vector<LibraryMaterial>& materials) {
    std::size_t width = 0;
    for (const LibraryMaterial& material : materials) width = std::max(width, material.preset.name.size());
    std::vector<std::size_t> widths;
    for (const Column& column : kColumns) {
        widths.push_back(std::string_view(column.name).size());
        for (const LibraryMaterial& material : materials) {
            widths.back() = std::max(widths.back(), cellText(material.preset, column).size());
        }
    }
    const auto line = [&](std::string text, auto cell) {
        for (std::size_t k = 0; k < widths.size(); ++k) text += "  " + padded(cell(kColumns[k]), widths[k]);
        text.erase(text.find_last_not_of(' ') + 1);
        return text + '\n';
    };
    std::string text = line(padded("", width), [](const Column& column) { return std::string(column.name); });
    for (const LibraryMaterial& material : materials) {
        text += line(padded(material.preset.name, width),
                     [&](const Column& column) { return cellText(material.preset, column); });
    }
    return text;
}

std::string figureText(const PresetFigure& figure, const Column& column) {
    std::string text = "  " + padded(std::string(column.name) + ":", 20) + numberText(figure.value, column);
    if (figure.range) {
        text +=
            " (" + numberText(figure.range->first, column) + " to " + numberText(figure.range->second, column) + ")";
    }
    text = withUnit(text, column) + '\n';
    return figure.source.empty() ? text : text + "    " + figure.source + '\n';
}

std::string crackText(const MaterialPreset& preset) {
    const std::optional<double> limit = crackLimit(materialOf(preset, 0));
    if (!limit) return "";
    return "  " + padded("crack limit:", 20) + roundedText(*limit * kMillimetresOfMetre, kDerivedDigits) + " mm\n";
}

std::string patternText(const Pattern& pattern) {
    std::string kinds;
    for (const PatternLayer& layer : pattern.layers) {
        kinds += (kinds.empty() ? "" : ", ") + std::string(kindOf(layer.parameters).caption);
    }
    return kinds.empty() ? "" : "  " + padded("pattern:", 20) + kinds + '\n';
}

std::string sheetText(const LibraryMaterial& material) {
    const MaterialPreset& preset = material.preset;
    std::string text = preset.name + (preset.note.empty() ? "" : ": " + preset.note) + '\n';
    for (const Column& column : kColumns) {
        if (const PresetFigure* figure = column.figure(preset)) text += figureText(*figure, column);
    }
    text += crackText(preset) + patternText(preset.pattern);
    return material.file.empty() ? text : text + "  " + padded("file:", 20) + material.file.string() + '\n';
}

Result<std::vector<LibraryMaterial>> named(const MaterialLibrary& library, const std::vector<std::string>& names) {
    if (names.empty()) return library.materials;
    std::vector<LibraryMaterial> materials;
    for (const std::string& name : names) {
        Result<LibraryMaterial> material = chosenMaterial(library, name);
        if (!material) return material.error();
        materials.push_back(std::move(*material));
    }
    return materials;
}

std::string textOf(const std::vector<LibraryMaterial>& materials, const MaterialsOptions& options) {
    if (options.isJson) return materialsJson(materials);
    if (options.names.empty()) return listText(materials);
    std::string text;
    for (const LibraryMaterial& material : materials) text += (text.empty() ? "" : "\n") + sheetText(material);
    return text;
}

Status tellMaterials(const MaterialsOptions& options, const CliContext& context) {
    const Result<MaterialLibrary> library = chosenLibrary(options.folder);
    if (!library) return library.error();
    const Result<std::vector<LibraryMaterial>> materials = named(*library, options.names);
    if (!materials) return materials.error();
    if (const Status written = writeOutput("-", textOf(*materials, options), context); !written) return written;
    std::string faults;
    for (const std::string& fault : library->faults) faults += (faults.empty() ? "" : "\n") + fault;
    if (!faults.empty()) return Error{ErrorCode::BadInput, faults};
    return success();
}

}  // namespace

Verb addMaterials(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("materials", "List the materials of the library, with figures and sources");
    const auto options = std::make_shared<MaterialsOptions>();
    command->footer(kFooter);
    command->add_option("NAME", options->names, "Only these, in full")->type_name("");
    addMaterialsOption(*command, options->folder);
    command->add_flag("--json", options->isJson, "For programs: JSON instead of text");
    return {command, [options](const CliContext& context) { return tellMaterials(*options, context); }};
}

}  // namespace rubble
