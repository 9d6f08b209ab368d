#pragma once

#include "core/asset/compare/AssetDifference.h"

#include <span>

namespace rubble {

/// Differences of assets as JSON:
///
///     {"isSame":false,"assets":[{"name":s,"state":"changed",
///       "recipe":[{"what":s,"before":s,"after":s},...],
///       "levels":[{"level":0,"before":n,"after":n,"gone":n,"added":n,"moved":n,"reshaped":n},...],
///       "pieces":[{"path":s,"change":"moved","shift":d,"volumeBefore":v,"volumeAfter":v},...]},...]}
///
/// `state` is "same", "changed", "added" or "gone". A recipe's missing `before` or `after` is null. A fragment that is
/// gone or added has one volume and no shift.
std::string assetDifferenceJson(std::span<const AssetDifference> differences);

}  // namespace rubble
