#pragma once

#include "core/asset/Project.h"

#include <optional>

namespace rubble {

/// How long a blow presses where nothing else is told, s. Stones and steel of a few kilograms that meet at 10 m/s touch for a few
/// tenths of a millisecond, larger and softer bodies for several.
/// Source: Hertz's contact time 2.87 (m^2 / (R E*^2 v))^(1/5), in Johnson, Contact Mechanics, 1985, section 11.4.
inline constexpr double kUsualContactTime = 1e-3;

/// The smallest section that takes a prism apart, m^2: of the planes through its centre of mass, along z and across it. Each has
/// mass on both sides, so that what breaks there is in two.
double smallestSection(const Prism& prism);

/// The threshold that follows from the strength of a material: the impulse of a force that tears the smallest section,
///
///     J = tensile strength * smallest section * contact time        N s = Pa * m^2 * s
///
/// where the material's strength is told and the asset asks for it (Asset::contactTime); otherwise nothing. It is an upper bound for
/// slender solids: bent, a pane breaks earlier than pulled.
std::optional<double> derivedThreshold(const Asset& asset, const Material& material);

/// How deep a scratch may be, or half as long as a crack inside, before a material tears by its toughness and no longer by its
/// strength, m; nothing where it does not tell both:
///
///     a = (fracture toughness / tensile strength)^2 / pi
///
/// A crack n^2 times as deep leaves an n-th of the strength: from a on, derived thresholds are too high.
/// Source: "transition crack length" in Dowling, Mechanical Behavior of Materials, 4th edition, 2013, section 8.2.
std::optional<double> crackLimit(const Material& material);

/// The impulse in N s at or above which an asset breaks: derived where it is to be and can be, else as typed. All that plays, shows
/// or exports a threshold asks here.
double thresholdOf(const Asset& asset, const Material& material);
/// The same for an asset whose material is there.
double thresholdOf(const Project& project, const Asset& asset);

/// True where an asset asks for a derived threshold and its material does not tell its strength: the typed one is in force.
bool lacksStrength(const Asset& asset, const Material& material);

}  // namespace rubble
