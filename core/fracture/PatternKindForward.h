#pragma once

#include "core/base/Result.h"

#include <cstdint>

namespace rubble {

/// What the struct of every kind of layer names, see PatternKind.h: so that Pattern.h, which holds all of them, stays light.
struct CutSet;
struct LayerContext;
struct PatternKind;
struct SeedSet;

}  // namespace rubble
