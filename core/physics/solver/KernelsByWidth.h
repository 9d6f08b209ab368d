#pragma once

#include "core/physics/solver/SolverKernels.h"

namespace rubble {

/// The passes for one, four and eight lanes. Each is compiled for machines that support the width and must be called on
/// such only; use kernelsOf().
const SolverKernels& scalarKernels();
const SolverKernels& fourLaneKernels();
const SolverKernels& eightLaneKernels();

}  // namespace rubble
