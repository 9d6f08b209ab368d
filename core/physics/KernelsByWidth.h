#pragma once

#include "core/physics/SolverKernels.h"

namespace rubble {

/// The passes by one lane, four and eight, each compiled for machines that have these lanes: to be called on such only.
/// kernelsOf() chooses.
const SolverKernels& scalarKernels();
const SolverKernels& fourLaneKernels();
const SolverKernels& eightLaneKernels();

}  // namespace rubble
