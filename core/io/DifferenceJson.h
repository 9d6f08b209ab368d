#pragma once

#include "core/asset/AssetDifference.h"

#include <span>

namespace rubble {

/// Differences of assets as JSON:
///
///     {"isSame":false,"assets":[{"name":s,"state":"changed",
///       "recipe":[{"what":s,"before":s,"after":s},...],
///       "levels":[{"level":0,"before":n,"after":n,"gone":n,"added":n,"moved":n,"reshaped":n},...],
///       "pieces":[{"path":s,"change":"moved","shift":d,"volumeBefore":v,"volumeAfter":v},...]},...]}
///
/// `state` is "same", "changed", "added" or "gone"; `before` and `after` of what is not there are null; of a fragment that is
/// gone or added there are the volume that it has, and no shift.
std::string differenceJson(std::span<const AssetDifference> differences);

}  // namespace rubble
