#pragma once

#include "core/play/PlayAsset.h"

#include <limits>

namespace rubble {

/// The thresholds that satisfy all intents of an asset: those above `low` and no higher than `high`.
struct ThresholdInterval {
    double low = 0.0;                                       // N s: the hardest of what it survives
    double high = std::numeric_limits<double>::infinity();  // N s: the gentlest of what breaks it
    std::uint32_t lowIntent = kNone;  // that bounds it, as an index in Asset::intents; kNone: nothing does
    std::uint32_t highIntent = kNone;
    std::vector<double> impulses;  // N s, one an intent

    /// True where the intents conflict: no threshold satisfies all of them.
    bool isEmpty() const { return !(low < high); }
    bool contains(double threshold) const { return threshold > low && threshold <= high; }
    /// One that satisfies all of them with room to either side: the geometric middle, or a quarter beyond the only bound.
    /// Nothing where there is none, or where any would do.
    std::optional<double> suggested() const;
};

/// What the intents of an asset ask of its threshold, see intentImpulse(): surviving an event asks for a threshold above
/// its impulse, breaking by it for one that is no higher.
///
/// Errors: those of intentImpulse(), with the asset's name.
Result<ThresholdInterval> thresholdInterval(const Project& project, const PlayAsset& asset);

/// "survives a drop of 1 m", "breaks when hit by 5 kg at 12 m/s".
std::string intentText(const Intent& intent);

/// The two intents that conflict most and by how much, or the one that cannot be had at all, as a sentence; nothing where the
/// interval has thresholds.
std::optional<std::string> conflictText(const Asset& asset, const ThresholdInterval& interval);

/// "above 734.5 N s and at most 980 N s"; "any" where nothing bounds it.
std::string intervalText(const ThresholdInterval& interval);

/// "734.5 N s".
std::string impulseText(double impulse);

}  // namespace rubble
