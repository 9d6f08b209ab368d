#include "core/io/project/MaterialPresetFile.h"

#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/io/json/FormatVersion.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/project/ColourJson.h"
#include "core/io/project/PatternJson.h"
#include "core/io/project/ShapingJson.h"
#include "core/io/project/StrengthRequirementJson.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/FileName.h"
#include "material_preset.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr FileFormat kPresetFormat{.name = "rubble-material", .noun = "material", .version = 1};

void writeProperty(JsonWriter& json, std::string_view key, const PresetFigure& figure) {
    json.openObject(key);
    json.number("value", figure.value);
    if (figure.range) json.numbers("range", {figure.range->first, figure.range->second});
    if (!figure.source.empty()) json.text("source", figure.source);
    json.close();
}

void writeProperty(JsonWriter& json, std::string_view key, const std::optional<PresetFigure>& figure) {
    if (figure) writeProperty(json, key, *figure);
}

std::pair<double, double> readRange(const JsonValue& value) {
    const auto [low, high] = value.numbers<2>();
    return {low, high};
}

PresetFigure readProperty(const JsonValue& value) {
    value.requireObject({"value"}, {"range", "source"});
    PresetFigure figure{.value = value["value"].number()};
    if (value["range"].isPresent()) figure.range = readRange(value["range"]);
    if (value["source"].isPresent()) figure.source = value["source"].text();
    return figure;
}

std::optional<PresetFigure> readOptionalProperty(const JsonValue& value) {
    return value.isPresent() ? std::optional(readProperty(value)) : std::nullopt;
}

/// Writes the members of a preset into an open object.
void writePreset(JsonWriter& json, const MaterialPreset& preset) {
    json.text("name", preset.name);
    if (!preset.note.empty()) json.text("note", preset.note);
    writeProperty(json, "density", preset.density);
    writeProperty(json, "friction", preset.friction);
    writeProperty(json, "restitution", preset.restitution);
    writeProperty(json, "tensileStrength", preset.tensileStrength);
    writeProperty(json, "fractureToughness", preset.fractureToughness);
    writeProperty(json, "youngsModulus", preset.youngsModulus);
    writeColour(json, "outside", preset.outside);
    writeColour(json, "inside", preset.inside);
    writeOpacity(json, preset.opacity);
    writeFinish(json, preset.finish);
    if (!preset.pattern.layers.empty()) writePattern(json, preset.pattern);
    if (preset.roughness.amplitude > 0.0) writeRoughness(json, preset.roughness);
    if (preset.cutAtImpact) writeCutAtImpact(json, preset.cutAtImpact);
}

void writeLibraryMaterial(JsonWriter& json, const LibraryMaterial& material) {
    json.openObject();
    if (material.file.empty()) {
        json.null("file");
    } else {
        json.text("file", material.file.string());
    }
    writePreset(json, material.preset);
    json.close();
}

MaterialPreset readPreset(const JsonValue& root) {
    root.requireObject({"format", "version", "name", "density", "friction", "restitution", "outside", "inside"},
                       {"note", "tensileStrength", "fractureToughness", "youngsModulus", "opacity", "finish", "pattern",
                        "roughness", "cutAtImpact"});
    return {.name = root["name"].text(),
            .note = root["note"].isPresent() ? root["note"].text() : std::string(),
            .density = readProperty(root["density"]),
            .friction = readProperty(root["friction"]),
            .restitution = readProperty(root["restitution"]),
            .tensileStrength = readOptionalProperty(root["tensileStrength"]),
            .fractureToughness = readOptionalProperty(root["fractureToughness"]),
            .youngsModulus = readOptionalProperty(root["youngsModulus"]),
            .outside = readColour(root["outside"]),
            .inside = readColour(root["inside"]),
            .opacity = readOpacity(root),
            .finish = readFinish(root),
            .pattern = root["pattern"].isPresent() ? readPattern(root["pattern"]) : Pattern{},
            .roughness = root["roughness"].isPresent() ? readRoughness(root["roughness"]) : Roughness{},
            .cutAtImpact =
                root["cutAtImpact"].isPresent() ? std::optional(readCutAtImpact(root["cutAtImpact"])) : std::nullopt};
}

std::vector<std::filesystem::path> jsonFilesIn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;  // a missing folder counts as empty
    std::filesystem::directory_iterator entry(folder, ignored);
    for (; !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
        if (entry->path().extension() == ".json") files.push_back(entry->path());
    }
    std::ranges::sort(files);
    return files;
}

void addBuiltIn(MaterialLibrary& library) {
    for (const std::string_view name : materialPresetNames()) {
        Result<MaterialPreset> preset = readMaterialPresetText(materialPreset(name));
        RUBBLE_ASSERT(preset.hasValue());
        library.materials.push_back({std::move(*preset), {}});
    }
}

/// Adds the preset of a user's file, or replaces the built-in one with its name.
void addFile(const std::filesystem::path& file, MaterialLibrary& library) {
    Result<MaterialPreset> preset = loadMaterialPreset(file);
    if (!preset) return library.errors.push_back(preset.error().message);
    const auto same = std::ranges::find(library.materials, preset->name,
                                        [](const LibraryMaterial& material) { return material.preset.name; });
    if (same == library.materials.end()) return library.materials.push_back({std::move(*preset), file});
    if (same->file.empty()) {
        *same = {std::move(*preset), file};
    } else {
        library.errors.push_back(quotedPath(file) + " is skipped: " + quotedPath(same->file) +
                                 " already defines the material " + quotedName(preset->name) + ".");
    }
}

char toLower(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter; }

bool isSameName(std::string_view first, std::string_view second) {
    return std::ranges::equal(first, second, {}, toLower, toLower);
}

}  // namespace

std::string materialPresetText(const MaterialPreset& preset) {
    JsonWriter json;
    json.openObject();
    json.text("format", kPresetFormat.name);
    json.wholeNumber("version", std::uint64_t{kPresetFormat.version});
    writePreset(json, preset);
    json.close();
    return std::move(json).finished();
}

Result<MaterialPreset> readMaterialPresetText(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    if (const Result<std::uint32_t> version = versionOf(*document, kPresetFormat); !version) return version.error();
    MaterialPreset preset = readPreset(document->root());
    if (document->firstError()) return *document->firstError();
    if (const std::optional<std::string> fault = verifyPreset(preset)) return Error{ErrorCode::BadInput, *fault};
    return preset;
}

Result<MaterialPreset> loadMaterialPreset(const std::filesystem::path& path) {
    const Result<std::string> text = readFile(path);
    if (!text) return text.error();
    Result<MaterialPreset> preset = readMaterialPresetText(*text);
    if (!preset) return withPath("Cannot read", path, preset.error());
    return preset;
}

Status saveMaterialPreset(const std::filesystem::path& path, const MaterialPreset& preset) {
    if (const std::optional<std::string> fault = verifyPreset(preset)) {
        return withPath("Cannot write", path, {ErrorCode::BadInput, *fault});
    }
    return writeFileAtomically(path, materialPresetText(preset));
}

std::filesystem::path materialPresetPath(const std::filesystem::path& folder, const std::string& name) {
    std::string file;
    for (const char letter : name) {
        const auto code = static_cast<unsigned char>(letter);
        const bool isPlain = (letter >= '0' && letter <= '9') || (toLower(letter) >= 'a' && toLower(letter) <= 'z') ||
                             letter == '_' || code >= 0x80;
        if (isPlain)
            file += toLower(letter);
        else if (!file.empty() && file.back() != '-')
            file += '-';
    }
    if (file.empty() || file == "-") file = "material";
    if (file.back() == '-') file.pop_back();
    return folder / fittingFileName("", safeFileName(file), ".json");
}

MaterialLibrary materialLibrary(const std::filesystem::path& folder) {
    MaterialLibrary library;
    addBuiltIn(library);
    if (!folder.empty()) {
        for (const std::filesystem::path& file : jsonFilesIn(folder)) addFile(file, library);
    }
    std::ranges::sort(library.materials, {}, [](const LibraryMaterial& material) { return material.preset.name; });
    return library;
}

const LibraryMaterial* findMaterial(const MaterialLibrary& library, std::string_view name) {
    const auto found = std::ranges::find_if(
        library.materials, [&](const LibraryMaterial& material) { return isSameName(material.preset.name, name); });
    return found != library.materials.end() ? &*found : nullptr;
}

std::string materialsJson(const std::vector<LibraryMaterial>& materials) {
    JsonWriter json;
    json.openObject();
    json.list("materials", materials, writeLibraryMaterial);
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
