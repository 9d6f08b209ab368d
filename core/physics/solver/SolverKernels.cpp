#include "core/physics/solver/SolverKernels.h"

#include "core/physics/solver/KernelsByWidth.h"

namespace rubble {

const SolverKernels& kernelsOf(SimdWidth width) {
    switch (width) {
        case SimdWidth::Eight: return eightLaneKernels();
        case SimdWidth::Four: return fourLaneKernels();
        case SimdWidth::Scalar: break;
    }
    return scalarKernels();
}

}  // namespace rubble
