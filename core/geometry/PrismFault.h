#pragma once

#include "core/geometry/AxisView.h"

#include <string>

namespace rubble {

/// Why a solid mesh, seen along an axis along which it is no prism, is none: one sentence with the measured value.
std::string prismFault(const AxisView& view, const TriangleMesh& mesh, double tolerance);

}  // namespace rubble
