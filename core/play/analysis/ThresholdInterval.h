#pragma once

#include "core/play/scene/PlayAsset.h"

#include <limits>

namespace rubble {

/// Whether an asset breaks at a threshold: one that breaks as bonded does not, but by the simplified method.
bool hasThreshold(const Project& project, const Asset& asset);

/// The thresholds that satisfy all strength requirements of an asset: low < threshold <= high.
struct ThresholdInterval {
    double low = 0.0;                                       // N·s: the largest impulse that it must survive
    double high = std::numeric_limits<double>::infinity();  // N·s: the smallest impulse that must break it
    std::uint32_t lowRequirement = kNone;  // index in Asset::requirements of the bound; kNone: unbounded
    std::uint32_t highRequirement = kNone;
    std::vector<double> impulses;  // N·s, one per requirement
    bool isPerArea = false;        // of bonds: all of these are impulses per area, N·s/m²

    /// True if the requirements conflict: no threshold satisfies all of them.
    bool isEmpty() const { return !(low < high); }
    bool contains(double threshold) const { return threshold > low && threshold <= high; }
    /// A threshold with a margin to both sides: the geometric mean of the bounds, or 25 % beyond the only bound.
    /// Nothing if the interval is empty or unbounded.
    std::optional<double> suggested() const;
};

/// The interval for the requirements of an asset: to survive an event, the threshold must be above its impulse; to
/// break in it, at most the impulse. See requirementImpulse(). What breaks whole leaves a hole of its own width: one
/// that may be as wide bounds nothing, others demand that it survives.
///
/// Errors, with the asset's name: those of requirementImpulse(); BadInput for an asset that does not break at a
/// threshold.
Result<ThresholdInterval> thresholdInterval(const Project& project, const PlayAsset& asset);

/// The same for an asset that breaks along bonds: the impulses per area, as bondImpulseOf(), with which all are
/// satisfied. It survives where no bond breaks, and see HitForecast for holes. `asset` has its fragments.
///
/// Errors, with the asset's name: those of requirementImpact().
Result<ThresholdInterval> bondInterval(const Project& project, std::shared_ptr<const PlayAsset> asset);

/// The fragments that come off an asset that breaks along bonds in the event of a requirement, ascending, with the
/// strength that it has: those of HitForecast. `asset` has its fragments.
///
/// Errors: as above.
Result<std::vector<std::uint32_t>> fragmentsLost(const Project& project, std::shared_ptr<const PlayAsset> asset,
                                                 const StrengthRequirement& requirement);

/// The requirement that an impact of this impulse has this outcome again, rounded to three digits towards the side that
/// demands more.
StrengthRequirement impulseRequirement(RequirementOutcome outcome, double impulse);

/// The requirement as text: "survives a drop of 1 m", "breaks when hit by 5 kg at 12 m/s", "gets a
/// hole of at most 0.5 m in a drop of 1 m".
std::string requirementText(const StrengthRequirement& requirement);

/// The two requirements that conflict most, and by how much, or the one that cannot be met, as a sentence; nothing if
/// the interval is not empty.
std::optional<std::string> conflictText(const Asset& asset, const ThresholdInterval& interval);

/// The interval as text: "above 734.5 N·s and at most 980 N·s"; "any" without bounds.
std::string intervalText(const ThresholdInterval& interval);

/// The impulse as text: "734.5 N·s"; per area "734.5 N·s/m²"; "none" for an infinite one.
std::string impulseText(double impulse, bool isPerArea = false);

}  // namespace rubble
