#pragma once

#include "core/asset/bake/Bake.h"
#include "core/asset/project/Project.h"
#include "core/base/Hash.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/pack/PackBonding.h"

namespace rubble {

/// Writes how an asset breaks along bonds as the member "bonding"; nothing if it breaks whole. The bonds are those of
/// playStructure(), in its order.
void writePackBonding(JsonWriter& json, const Bake& bake, const Asset& asset, const Material& material);

/// Reads what writePackBonding() wrote.
PackBonding readPackBonding(const JsonValue& value);

/// Adds all inputs of writePackBonding() but those of the bake to a hash; nothing if the asset breaks whole.
void addPackBonding(Hasher& hasher, const Asset& asset, const Material& material);

}  // namespace rubble
