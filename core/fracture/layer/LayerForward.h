#pragma once

#include "core/base/Result.h"

#include <cstdint>

namespace rubble {

// The types that the headers of all kinds of layers name. Keeps Pattern.h, which includes them, light.
struct Box2;
struct CutSet;
struct LayerContext;
struct LayerKind;
struct Polygon;
struct SeedSet;

}  // namespace rubble
