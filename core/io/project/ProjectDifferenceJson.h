#pragma once

#include "core/io/project/ProjectDifference.h"

namespace rubble {

/// Differences of projects as JSON:
///
///     {"isSame":false,"assets":[{"name":s,"state":"changed",
///       "recipe":[{"what":s,"before":s,"after":s},...],
///       "levels":[{"level":0,"before":n,"after":n,"gone":n,"added":n,"moved":n,"reshaped":n},...],
///       "pieces":[{"path":s,"change":"moved","shift":d,"volumeBefore":v,"volumeAfter":v},...]},...],
///       "settings":[{"what":s,"before":s,"after":s},...]}
///
/// `state` is "same", "changed", "added" or "gone". A missing `before` or `after` is null. A fragment that is
/// gone or added has one volume and no shift.
std::string projectDifferenceJson(const ProjectDifference& difference);

}  // namespace rubble
