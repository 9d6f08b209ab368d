#pragma once

#include "core/base/Result.h"

#include <cstdint>

namespace rubble {

// What the struct of every kind of layer names. See PatternKind.h.
struct CutSet;
struct LayerContext;
struct PatternKind;
struct SeedSet;

}  // namespace rubble
