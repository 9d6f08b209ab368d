#pragma once

#include "core/geometry/prism/AxisView.h"

#include <string>

namespace rubble {

/// Why a solid mesh is not a prism along an axis: one sentence with the measured value.
std::string prismRejection(const AxisView& view, const TriangleMesh& mesh, double tolerance);

}  // namespace rubble
