#pragma once

#include "core/base/Result.h"

#include <cstdint>

namespace rubble {

/// Forward declarations for the headers of the layer kinds, which keep Pattern.h cheap to include.
struct Box3;
struct CutSet;
class SolidDomain;
struct LayerContext;
struct LayerKind;
struct Polygon;
struct SeedSet;
struct SolidLayerContext;

}  // namespace rubble
