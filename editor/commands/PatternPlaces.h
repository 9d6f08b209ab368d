#pragma once

#include "core/asset/Project.h"

#include <QString>

namespace rubble {

/// The patterns of an asset in a row: that of the whole (0), of its levels (1, ...), and of the fragments that are broken in their own
/// way, behind them.
std::size_t patternCount(const Asset& asset);
/// The pattern at a place, or null where a fragment stays whole.
const Pattern* patternAt(const Asset& asset, std::size_t place);
/// The same to be changed. A fragment that stayed whole is broken from now on.
Pattern& patternAt(Asset& asset, std::size_t place);
/// The place of the pattern that breaks a fragment: its own, or that of its level; of the whole where neither is there.
std::size_t placeFor(const Asset& asset, const FragmentPath& fragment);
/// Whether a fragment is broken by a pattern of its own.
bool hasOwnPattern(const Asset& asset, const FragmentPath& fragment);
/// The pattern that breaks a fragment alone (the whole's for the empty path), to be changed: where it was broken as its level says, it
/// has a copy of that from now on, which breaks it into the same pieces of the same names.
Pattern& ownPattern(Asset& asset, const FragmentPath& fragment);
/// The level at a place; null for the whole and for fragments that stay whole.
const Level* levelAt(const Asset& asset, std::size_t place);
/// Fragments below `volume` (m^3) are not broken there from now on; nothing changes where there is no level.
void setMinimumVolume(Asset& asset, std::size_t place, double volume);
/// Takes a level, or what is said of a fragment, away.
void removeLevelAt(Asset& asset, std::size_t place);

/// How deep what is broken there lies: 0 for the whole.
std::size_t depthAt(const Asset& asset, std::size_t place);
/// "The whole", "Fragments, level 1", "Fragment 5.17".
QString placeText(const Asset& asset, std::size_t place);

}  // namespace rubble
