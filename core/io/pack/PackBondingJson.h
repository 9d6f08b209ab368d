#pragma once

#include "core/io/exchange/PackBonding.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// Writes how an asset breaks along bonds as the member "bonding".
void writePackBonding(JsonWriter& json, const PackBonding& bonding);

/// Reads what writePackBonding() wrote.
PackBonding readPackBonding(const JsonValue& value);

}  // namespace rubble
