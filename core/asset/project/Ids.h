#pragma once

#include "core/asset/project/Project.h"

#include <algorithm>
#include <span>
#include <vector>

namespace rubble {

/// The element with an id in a list of a project, whose ids ascend; null if there is none. O(log n).
template <class Element>
const Element* findById(const std::vector<Element>& elements, Id id) {
    const auto found = std::ranges::lower_bound(elements, id, {}, &Element::id);
    return found != elements.end() && found->id == id ? &*found : nullptr;
}

/// Whether a list has an id.
bool isAmong(std::span<const Id> ids, Id id);

/// The lowest id above `after` that no element or layer of the project has.
Id lowestUnusedId(const Project& project, Id after = 0);

/// Returns an id that no element or layer of the project has: nextId, which advances; once it has reached its greatest
/// value, the lowest unused one.
Id allocateId(Project& project);

}  // namespace rubble
