#pragma once

#include "core/asset/project/Project.h"
#include "core/geometry/search/Box3.h"

#include <QString>

namespace rubble {

// The patterns of an asset by index: that of the whole asset (0), those of its levels (1, ...), then those of fragments
// with a pattern of their own. A fragment that is kept whole has an index, but no pattern.

std::size_t patternCount(const Asset& asset);
/// Null for a fragment that is kept whole.
const Pattern* patternAt(const Asset& asset, std::size_t index);
/// The same, mutable. A fragment that was kept whole gets an empty pattern.
Pattern& patternAt(Asset& asset, std::size_t index);
/// The index of the pattern that fractures a fragment: its own, or that of its level; 0 if there is neither.
std::size_t patternIndexFor(const Asset& asset, const FragmentPath& fragment);
/// Whether a fragment has a pattern of its own.
bool hasOwnPattern(const Asset& asset, const FragmentPath& fragment);
/// The pattern that fractures this fragment alone (the whole asset for the empty path), mutable. A fragment with the
/// pattern of its level gets a copy of that, which gives the same fragments with the same names.
Pattern& ownPattern(Asset& asset, const FragmentPath& fragment);
/// Null for the whole asset and for fragments that are kept whole.
const Level* levelAt(const Asset& asset, std::size_t index);
/// Sets the volume (m³) below which fragments are not fractured; does nothing if there is no level.
void setMinimumVolume(Asset& asset, std::size_t index, double volume);
/// Sets the threshold, N·s, of the fragments that are fractured; none: it follows from their volumes. Does nothing if
/// there is no level.
void setLevelThreshold(Asset& asset, std::size_t index, std::optional<double> threshold);
/// Sets the factor of the strength of the bonds between the fragments; does nothing if there is no level.
void setBondStrength(Asset& asset, std::size_t index, double strength);
/// Removes a level, or a fragment's own pattern.
void removeLevelAt(Asset& asset, std::size_t index);

/// The level of what the pattern fractures: 0 for the whole asset.
std::size_t depthAt(const Asset& asset, std::size_t index);
/// The bounding box of what the pattern fractures, in the frame of its seeds. For the fragments of a level, which
/// differ, it has a typical size.
Box2 domainBounds(const Asset& asset, std::size_t index = 0);
/// The same in space; without height for a prism.
Box3 domainBox(const Asset& asset, std::size_t index = 0);
/// The name of a pattern: "Intact asset", "Fragments, level 1", "Fragment 5.17".
QString patternName(const Asset& asset, std::size_t index);

}  // namespace rubble
