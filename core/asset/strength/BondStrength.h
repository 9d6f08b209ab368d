#pragma once

#include "core/asset/project/Project.h"

#include <optional>

namespace rubble {

/// The impulse per area that follows from the strength of a material, N·s/m², that of a stress for the contact time:
///
///     impulse per area = tensile strength * contact time        N·s/m² = Pa * s
///
/// with kDefaultContactTime where the asset has none. Nothing if the strength is unknown.
std::optional<double> derivedBondImpulse(const Asset& asset, const Material& material);

/// The impulse per area that breaks a bond of an asset whose strength no level, brush, height or picture multiplies:
/// as entered, otherwise derived, otherwise the default of ProjectNumber::BondImpulse.
double bondImpulseOf(const Asset& asset, const Material& material);

}  // namespace rubble
