#pragma once

#include "core/physics/SolverKernels.h"

namespace rubble {

// Each is compiled for machines that have these lanes.
const SolverKernels& scalarKernels();
const SolverKernels& fourLaneKernels();
const SolverKernels& eightLaneKernels();

}  // namespace rubble
