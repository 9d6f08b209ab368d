#include "core/physics/solver/KernelsByWidth.h"
#include "core/physics/solver/WideKernels.h"

namespace rubble {

const SolverKernels& scalarKernels() { return kWideKernels<1>; }

}  // namespace rubble
