#pragma once

#include "core/asset/project/Project.h"

#include <optional>

namespace rubble {

/// The default contact time of an impact, s. Stones and steel of a few kilograms that meet at 10 m/s touch for a few
/// tenths of a millisecond, larger and softer bodies for several.
/// Source: Hertz contact time 2.87 (m² / (R E*² v))^(1/5), in Johnson, Contact Mechanics, 1985, section 11.4.
inline constexpr double kDefaultContactTime = 1e-3;

/// The smallest area of the plane cross-sections through a prism's centre of mass that contain z or are perpendicular
/// to it, m². Each of them leaves mass on both sides, so that breaking there separates the prism.
double minimumCrossSection(const Prism& prism);

/// The threshold that follows from the strength of a material: the impulse of a force that tears the minimum
/// cross-section,
///
///     J = tensile strength * minimum cross-section * contact time        N·s = Pa * m² * s
///
/// Nothing if the strength is unknown or the asset has no contactTime. An upper bound for slender solids, which break
/// in bending at lower loads than in tension.
std::optional<double> derivedThreshold(const Asset& asset, const Material& material);

/// The depth of a surface crack, or half the length of an internal one, beyond which a material fails by its toughness
/// instead of its strength, m; nothing if either is unknown:
///
///     a = (fracture toughness / tensile strength)² / pi
///
/// A crack n² times as deep leaves 1/n of the strength: beyond a, derived thresholds are too high.
/// Source: "transition crack length" in Dowling, Mechanical Behavior of Materials, 4th edition, 2013, section 8.2.
std::optional<double> transitionCrackLength(const Material& material);

/// The impulse at or above which an asset breaks, N·s: derived if possible, otherwise as entered. Everything that
/// plays, shows or exports a threshold calls this.
double thresholdOf(const Asset& asset, const Material& material);
/// The material must exist in the project.
double thresholdOf(const Project& project, const Asset& asset);

/// True if an asset requests a derived threshold but its material's strength is unknown: the entered one is used.
bool lacksStrength(const Asset& asset, const Material& material);

}  // namespace rubble
