#include "core/physics/solver/KernelsByWidth.h"
#include "core/physics/solver/WideKernels.h"

namespace rubble {

const SolverKernels& eightLaneKernels() { return kWideKernels<8>; }

}  // namespace rubble
