#include "core/physics/KernelsByWidth.h"
#include "core/physics/WideKernels.h"

namespace rubble {

const SolverKernels& scalarKernels() { return WideKernels<1>::kTable; }

}  // namespace rubble
