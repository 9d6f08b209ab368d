#pragma once

#include "core/asset/project/Project.h"

#include <optional>

namespace rubble {

/// The default contact time of an impact, s. Stones and steel of a few kilograms that meet at 10 m/s touch for a few
/// tenths of a millisecond, larger and softer bodies for several.
/// Source: Hertz contact time 2.87 (m² / (R E*² v))^(1/5), in Johnson, Contact Mechanics, 1985, section 11.4.
inline constexpr double kDefaultContactTime = 1e-3;

/// The ratio of strength times squared thickness to the force at the middle of a plate that breaks it in local bending.
/// The tensile stress opposite of a concentrated force F on a simply supported circular plate of thickness t, radius a
/// and Poisson's ratio nu is
///
///     stress = F / t² * ((1 + nu) (0.485 ln(a/t) + 0.52) + 0.48)
///
/// Here nu = 1/4, and a = kBendingRadius * t; from half to twice that radius the ratio goes from 1.9 to 2.7.
/// Source: Timoshenko, Woinowsky-Krieger, Theory of Plates and Shells, 2nd edition, 1959, equation (97).
inline constexpr double kBendingRatio = 2.3;
inline constexpr double kBendingRadius = 7.0;

/// The least thickness of a prism, m: its depth, or the width of its outline through the centre of mass if that is
/// less.
double thicknessOf(const Prism& prism);
/// The same of a prism; of a mesh, the least extent of its box.
double thicknessOf(const Asset& asset);

/// How a solid breaks in local bending.
struct BendingStrength {
    double thickness = 0.0;    // m
    double force = 0.0;        // N, that breaks it when it acts for long
    double duration = 0.0;     // s, for which that force must act
    bool isByInertia = false;  // the solid's inertia, rather than the contact time, decides the duration
    double threshold() const { return force * duration; }
};
/// The force and the duration that break an asset, after docs/adr/0032:
///
///     force = tensile strength * thickness² / kBendingRatio
///     duration = max(2 / pi * contact time, 33.8 * thickness * sqrt(density / Young's modulus))
///
/// Nothing if the strength is unknown or the asset has no contactTime; without Young's modulus, the contact time
/// decides.
std::optional<BendingStrength> bendingStrength(const Asset& asset, const Material& material);

/// The threshold that follows from the strength of a material, N·s, by bendingStrength(). Nothing if the strength is
/// unknown or the asset has no contactTime.
std::optional<double> derivedThreshold(const Asset& asset, const Material& material);

/// Derives the threshold of an asset from the strength of its material from now on.
void deriveThreshold(Asset& asset);
/// The same if the strength of its material is known: for new assets.
void deriveThresholdIfKnown(Asset& asset, const Material& material);
/// True if nobody entered the threshold: it is that of a new asset, or derived.
bool hasDefaultThreshold(const Asset& asset);
/// Gives an asset an entered threshold.
void enterThreshold(Asset& asset, double threshold);

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
