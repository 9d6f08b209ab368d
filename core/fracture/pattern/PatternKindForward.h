#pragma once

#include "core/base/Result.h"

#include <cstdint>

namespace rubble {

// The types that the headers of all kinds of layers name, see PatternKind.h. Keeps Pattern.h, which includes them,
// light.
struct CutSet;
struct LayerContext;
struct PatternKind;
struct SeedSet;

}  // namespace rubble
