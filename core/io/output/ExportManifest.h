#pragma once

#include "core/base/Result.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The name of the manifest in every export folder.
inline constexpr const char* kManifestName = "manifest.json";

/// A file of an export, as it was written.
struct ManifestEntry {
    std::string name;        // without a path
    std::uint64_t size = 0;  // bytes
    std::string hash;        // of the bytes, in hexadecimal digits
    bool operator==(const ManifestEntry&) const = default;
};

/// What an export folder was written from, and its files.
struct Manifest {
    std::string source;  // its content hash, in hexadecimal digits
    std::vector<ManifestEntry> files;
};

std::string manifestJson(const Manifest& manifest);

/// The manifest of a folder; nothing if there is none that this version can read, or if it names a file elsewhere.
std::optional<Manifest> readManifest(const std::filesystem::path& folder);

/// Write and read a list of files as the member "files".
void writeEntries(JsonWriter& json, std::span<const ManifestEntry> files);
std::vector<ManifestEntry> readEntries(const JsonValue& root);

ManifestEntry manifestEntry(const std::string& name, std::string_view bytes);
/// The entry of a file as it is now. Errors: NotFound, Io; a link is not followed.
Result<ManifestEntry> manifestEntryOfFile(const std::filesystem::path& folder, const std::string& name);

}  // namespace rubble
