#pragma once

#include "core/io/exchange/PackBody.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/pack/PackFile.h"

#include <string_view>

namespace rubble {

/// Writes a body as an object.
void writePackBody(JsonWriter& json, std::string_view key, const PackBody& body, PackTopology topology);

/// The estimated size of a body's JSON in bytes.
std::size_t packBodySize(const PackBody& body);

}  // namespace rubble
