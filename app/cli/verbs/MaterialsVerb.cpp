#include "app/cli/console/InputOutput.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/MaterialOptions.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/fracture/pattern/PatternKind.h"

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kMaterialsFooter =
    R"(Without names, lists all materials, one per line. With names, prints each with the ranges and sources of its
properties, the crack length beyond which toughness decides instead of strength, and its typical pattern. Files in
the folder that cannot be read are reported, and the program exits with 1. Your own material replaces a built-in
one with the same name.

Examples:
  rubble-cli materials
  rubble-cli materials glass ice
  rubble-cli materials --materials presets --json)";

constexpr double kPascalsOfMega = 1e6;
constexpr double kPascalsOfGiga = 1e9;

struct MaterialsOptions {
    std::vector<std::string> names;
    std::string folder;
    bool isJson = false;
};

/// A property of a material as it is printed: its name, unit and the size of the unit.
struct Column {
    const char* name;
    const char* unit;
    double divisor;
    const PresetFigure* (*figure)(const MaterialPreset& preset);  // null: none
};

constexpr Column kColumns[] = {
    {"density", "kg/m³", 1.0, [](const MaterialPreset& preset) { return &preset.density; }},
    {"friction", "", 1.0, [](const MaterialPreset& preset) { return &preset.friction; }},
    {"restitution", "", 1.0, [](const MaterialPreset& preset) { return &preset.restitution; }},
    {"tensile strength", "MPa", kPascalsOfMega,
     [](const MaterialPreset& preset) { return preset.tensileStrength ? &*preset.tensileStrength : nullptr; }},
    {"fracture toughness", "MPa·√m", kPascalsOfMega,
     [](const MaterialPreset& preset) { return preset.fractureToughness ? &*preset.fractureToughness : nullptr; }},
    {"Young's modulus", "GPa", kPascalsOfGiga,
     [](const MaterialPreset& preset) { return preset.youngsModulus ? &*preset.youngsModulus : nullptr; }},
};

/// The number of characters of a UTF-8 text.
std::size_t widthOf(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char letter) { return (static_cast<unsigned char>(letter) & 0xc0) != 0x80; }));
}

std::string padded(std::string text, std::size_t width) {
    const std::size_t used = widthOf(text);
    return used < width ? text + std::string(width - used, ' ') : text;
}

std::string numberText(double value, const Column& column) { return roundedNumber(value / column.divisor); }

std::string withUnit(const std::string& number, const Column& column) {
    return *column.unit != 0 ? number + " " + column.unit : number;
}

std::string cellText(const MaterialPreset& preset, const Column& column) {
    const PresetFigure* figure = column.figure(preset);
    return figure != nullptr ? withUnit(numberText(figure->value, column), column) : "-";
}

std::string listText(const std::vector<LibraryMaterial>& materials) {
    std::size_t width = 0;
    for (const LibraryMaterial& material : materials) width = std::max(width, widthOf(shownName(material.preset.name)));
    std::vector<std::size_t> widths;
    for (const Column& column : kColumns) {
        widths.push_back(widthOf(column.name));
        for (const LibraryMaterial& material : materials) {
            widths.back() = std::max(widths.back(), widthOf(cellText(material.preset, column)));
        }
    }
    const auto line = [&](std::string text, auto cell) {
        for (std::size_t k = 0; k < widths.size(); ++k) text += "  " + padded(cell(kColumns[k]), widths[k]);
        text.erase(text.find_last_not_of(' ') + 1);
        return text + '\n';
    };
    std::string text = line(padded("", width), [](const Column& column) { return std::string(column.name); });
    for (const LibraryMaterial& material : materials) {
        text += line(padded(shownName(material.preset.name), width),
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
    const std::optional<double> limit = transitionCrackLength(materialOf(preset, 0));
    if (!limit) return "";
    return "  " + padded("critical crack:", 20) + quantityText(QuantityKind::Length, *limit) + "\n";
}

std::string patternText(const Pattern& pattern) {
    std::string kinds;
    for (const PatternLayer& layer : pattern.layers) {
        kinds += (kinds.empty() ? "" : ", ") + std::string(kindOf(layer.parameters).caption);
    }
    return kinds.empty() ? "" : "  " + padded("pattern:", 20) + kinds + '\n';
}

std::string roughnessText(const Roughness& roughness) {
    if (!(roughness.amplitude > 0.0)) return "";
    return "  " + padded("rough cuts:", 20) + quantityText(QuantityKind::Length, roughness.amplitude) + '\n';
}

std::string detailsText(const LibraryMaterial& material) {
    const MaterialPreset& preset = material.preset;
    std::string text = shownName(preset.name) + (preset.note.empty() ? "" : ": " + preset.note) + '\n';
    for (const Column& column : kColumns) {
        if (const PresetFigure* figure = column.figure(preset)) text += figureText(*figure, column);
    }
    text += crackText(preset) + patternText(preset.pattern) + roughnessText(preset.roughness);
    return material.file.empty() ? text : text + "  " + padded("file:", 20) + material.file.string() + '\n';
}

Result<std::vector<LibraryMaterial>> selectedMaterials(const MaterialLibrary& library,
                                                       const std::vector<std::string>& names) {
    if (names.empty()) return library.materials;
    std::vector<LibraryMaterial> materials;
    for (const std::string& name : names) {
        Result<LibraryMaterial> material = requireMaterial(library, name);
        if (!material) return material.error();
        materials.push_back(std::move(*material));
    }
    return materials;
}

std::string textOf(const std::vector<LibraryMaterial>& materials, const MaterialsOptions& options) {
    if (options.isJson) return materialsJson(materials);
    if (options.names.empty()) return listText(materials);
    std::string text;
    for (const LibraryMaterial& material : materials) text += (text.empty() ? "" : "\n") + detailsText(material);
    return text;
}

Status printMaterials(const MaterialsOptions& options, const CliContext& context) {
    const Result<MaterialLibrary> library = openMaterialLibrary(options.folder);
    if (!library) return library.error();
    const Result<std::vector<LibraryMaterial>> materials = selectedMaterials(*library, options.names);
    if (!materials) return materials.error();
    if (const Status written = printText(textOf(*materials, options), context); !written) return written;
    std::string errors;
    for (const std::string& error : library->errors) errors += (errors.empty() ? "" : "\n") + error;
    if (!errors.empty()) return Error{ErrorCode::BadInput, errors};
    return success();
}

}  // namespace

Verb addMaterials(CLI::App& program) {
    Command command(program, "materials", "List the materials of the library with their properties and sources",
                    kMaterialsFooter);
    const auto options = std::make_shared<MaterialsOptions>();
    command.argument("NAME", options->names, "Print these materials in detail");
    addMaterialsOption(command, options->folder);
    addJsonOption(command, options->isJson);
    return {command, [options](VerbReport&, const CliContext& context) { return printMaterials(*options, context); }};
}

}  // namespace rubble
