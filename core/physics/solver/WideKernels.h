#pragma once

#include "core/physics/solver/EnergyKernels.h"
#include "core/physics/solver/IntegrationKernels.h"
#include "core/physics/solver/PrepareKernels.h"
#include "core/physics/solver/RestitutionKernels.h"
#include "core/physics/solver/SoftContactKernels.h"

namespace rubble {

/// The solver's passes for W lanes. Each width is instantiated in a file of its own, compiled for machines that support
/// it.
template <int W>
inline constexpr SolverKernels kWideKernels{
    &PrepareKernels<W>::staleLanes,
    &PrepareKernels<W>::prepare,
    &SoftContactKernels<W>::warmStart,
    &SoftContactKernels<W>::solve,
    &SoftContactKernels<W>::relax,
    &RestitutionKernels<W>::restitute,
    &IntegrationKernels<W>::integrateVelocities,
    &IntegrationKernels<W>::integratePositions,
    &EnergyKernels<W>::findLosses,
};

}  // namespace rubble
