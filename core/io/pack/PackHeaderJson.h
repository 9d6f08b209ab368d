#pragma once

#include "core/io/exchange/Pack.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

#include <string>

namespace rubble {

/// Writes the members of pack.json before its bodies.
void writePackHeader(JsonWriter& json, const Pack& pack);

/// Returns a document of these members, and the rule of the bonds without the bonds.
std::string packHeaderJson(const Pack& pack);

/// Reads what writePackHeader() wrote, of any version.
Pack readPackHeader(const JsonValue& root, std::uint32_t version);

}  // namespace rubble
