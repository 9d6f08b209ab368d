#include "core/physics/SolverKernels.h"

#include "core/physics/KernelsByWidth.h"

namespace rubble {

const SolverKernels& kernelsOf(LaneWidth width) {
    switch (width) {
        case LaneWidth::Eight: return eightLaneKernels();
        case LaneWidth::Four: return fourLaneKernels();
        case LaneWidth::Scalar: break;
    }
    return scalarKernels();
}

}  // namespace rubble
