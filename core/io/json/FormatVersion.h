#pragma once

#include "core/io/json/JsonDocument.h"

#include <cstdint>
#include <string_view>

namespace rubble {

/// One of Rubble's file formats and the newest version that this program reads.
struct FileFormat {
    std::string_view name;  // the value of the key `format`: "rubble-project"
    std::string_view noun;  // for messages: "project"
    std::uint32_t version = 1;
};

/// Returns the version of a document from its keys `format` and `version`.
///
/// Errors: BadInput if a key is missing or the format is a different one; Unsupported if the version is newer.
Result<std::uint32_t> versionOf(JsonDocument& document, const FileFormat& format);

}  // namespace rubble
