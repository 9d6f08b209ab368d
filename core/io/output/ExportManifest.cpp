#include "core/io/output/ExportManifest.h"

#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/system/AtomicFile.h"

#include <algorithm>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifestFormat = "rubble-manifest";
constexpr std::uint32_t kManifestVersion = 1;

}  // namespace

std::string manifestJson(const Manifest& manifest) {
    JsonWriter json;
    json.openObject();
    json.text("format", kManifestFormat);
    json.wholeNumber("version", std::uint64_t{kManifestVersion});
    json.text("source", manifest.source);
    writeEntries(json, manifest.files);
    json.close();
    return std::move(json).finished();
}

std::optional<Manifest> readManifest(const fs::path& folder) {
    const Result<std::string> text = readFile(folder / kManifestName, Links::Refused);
    if (!text) return std::nullopt;
    Result<JsonDocument> document = JsonDocument::parse(*text);
    if (!document) return std::nullopt;
    const JsonValue root = document->root();
    root.requireObject({"format", "version", "source", "files"});
    if (root["format"].text() != kManifestFormat || root["version"].index() != kManifestVersion) return std::nullopt;
    Manifest manifest;
    manifest.source = root["source"].text();
    manifest.files = readEntries(root);
    if (document->firstError()) return std::nullopt;
    const auto isInFolder = [](const ManifestEntry& file) {
        const fs::path name = file.name;
        return name == name.filename() && file.name != "." && file.name != "..";
    };
    if (!std::ranges::all_of(manifest.files, isInFolder)) return std::nullopt;
    return manifest;
}

void writeEntries(JsonWriter& json, std::span<const ManifestEntry> files) {
    json.openArray("files");
    for (const ManifestEntry& file : files) {
        json.openObject({}, JsonLayout::Inline);
        json.text("name", file.name);
        json.wholeNumber("size", file.size);
        json.text("hash", file.hash);
        json.close();
    }
    json.close();
}

std::vector<ManifestEntry> readEntries(const JsonValue& root) {
    return root["files"].list([](const JsonValue& file) {
        file.requireObject({"name", "size", "hash"});
        return ManifestEntry{file["name"].text(), file["size"].wholeNumber(), file["hash"].text()};
    });
}

ManifestEntry manifestEntry(const std::string& name, std::string_view bytes) {
    return {name, bytes.size(), contentHash(bytes).hex()};
}

Result<ManifestEntry> manifestEntryOfFile(const fs::path& folder, const std::string& name) {
    const Result<FileHash> file = hashOfFile(folder / name, Links::Refused);
    if (!file) return file.error();
    return ManifestEntry{name, file->size, file->hash.hex()};
}

}  // namespace rubble
