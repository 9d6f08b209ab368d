#include "core/physics/KernelsByWidth.h"
#include "core/physics/WideKernels.h"

namespace rubble {

const SolverKernels& fourLaneKernels() { return WideKernels<4>::kTable; }

}  // namespace rubble
