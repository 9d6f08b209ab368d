#pragma once

#include "core/asset/project/Project.h"

#include <span>

namespace rubble {

/// Whether a list has an id.
bool isAmong(std::span<const Id> ids, Id id);

/// The lowest id above `after` that no element or layer of the project has.
Id lowestUnusedId(const Project& project, Id after = 0);

/// Returns an id that no element or layer of the project has: nextId, which advances; once it has reached its greatest
/// value, the lowest unused one.
Id allocateId(Project& project);

}  // namespace rubble
