#pragma once

#include "core/asset/placement/InstancePlacement.h"

#include <cstddef>
#include <string>
#include <vector>

namespace rubble {

/// Two overlapping instances, or an instance that overlaps the ground.
struct InstanceOverlap {
    Id first = 0;
    Id second = 0;       // > first; 0: the ground
    double depth = 0.0;  // m: the separating distance
    bool operator==(const InstanceOverlap&) const = default;
};

/// All overlaps deeper than kTouchTolerance, by exact hulls, ascending by ids: play pushes such instances apart. Fixed
/// ones may overlap the ground. Where more than kMaxOverlaps hulls overlap, as of a thousand instances in one place,
/// those that it finds first, and `isComplete` becomes false. O(n log n) for n instances, a few tenths of a second for
/// 1,000.
std::vector<InstanceOverlap> instanceOverlaps(const Project& project, bool* isComplete = nullptr);
inline constexpr std::size_t kMaxOverlaps = 10'000;
/// How many overlapNotes() lists one by one.
inline constexpr std::size_t kListedOverlaps = 100;

/// The overlap as a sentence: `"wall 3" and "wall 7" overlap by 12 mm.`
std::string sentenceOf(const InstanceOverlap& overlap, const Project& project);
/// The number of overlaps beyond the kListedOverlaps as a sentence: `Instances overlap in 400 more places.`
std::string otherOverlapsText(std::size_t found, bool isComplete);

/// A sentence about overlaps: sentenceOf() one, or otherOverlapsText().
struct OverlapNote {
    std::string sentence;
    std::vector<Id> instances;  // of the one overlap
};
/// The overlaps of a project as they are listed: kListedOverlaps, then the number of the others if there are more.
std::vector<OverlapNote> overlapNotes(const Project& project);

}  // namespace rubble
