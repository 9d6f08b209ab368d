#pragma once

#include "core/io/JsonReading.h"

#include <cstdint>
#include <string_view>

namespace rubble {

/// A kind of file of ours, and the newest version of it that this program knows.
struct FileFormat {
    std::string_view name;  // "rubble-project", as its key `format` says
    std::string_view noun;  // "project", as sentences say
    std::uint32_t version = 1;
};

/// The version of a document, from 1 to the newest, by its keys `format` and `version`.
///
/// Errors: BadInput where these are missing or of another format; Unsupported where the version is newer.
Result<std::uint32_t> versionOf(JsonDocument& document, const FileFormat& format);

}  // namespace rubble
