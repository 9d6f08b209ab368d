#pragma once

#include "core/play/state/BegunStructures.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace rubble {

/// A bond of the structure of an instance that is mortar.
struct MortarHalf {
    Id instance = 0;
    std::uint32_t bond = 0;
    auto operator<=>(const MortarHalf&) const = default;
};

struct LooseMortar {
    std::vector<MortarHalf> halves;  // unbroken, ascending
    std::size_t visits = 0;          // instances that were looked at
};

/// The mortar that holds no longer: whose other half is broken, and that between bodies of which none is connected to
/// an anchor any more, directly or through mortar. `changed`: the instances at which anything broke or was removed
/// since the last call; all bodies of which bonds broke have been split.
///
/// Searches from the bodies at which mortar joined the changed instances with others, until it meets an anchor or a
/// body that has one. O(n log n) in the bonds of these instances to anchors and mortar, and of those on the way, and
/// O(structures of which bonds were damaged).
LooseMortar looseMortar(const SessionParts& parts, const BegunStructures& begun, const std::set<Id>& changed);

}  // namespace rubble
