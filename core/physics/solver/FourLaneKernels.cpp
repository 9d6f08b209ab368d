#include "core/physics/solver/KernelsByWidth.h"
#include "core/physics/solver/WideKernels.h"

namespace rubble {

const SolverKernels& fourLaneKernels() { return kWideKernels<4>; }

}  // namespace rubble
