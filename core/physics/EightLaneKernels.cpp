#include "core/physics/KernelsByWidth.h"
#include "core/physics/WideKernels.h"

namespace rubble {

const SolverKernels& eightLaneKernels() { return WideKernels<8>::kTable; }

}  // namespace rubble
