#pragma once

#include "core/play/session/Session.h"

#include <set>
#include <utility>

namespace rubble::test {

using Bonds = std::set<std::pair<Id, std::size_t>>;  // by instance

/// The bonds of all instances that have broken.
inline Bonds brokenBonds(const Session& session) {
    Bonds bonds;
    for (const auto& [instance, damage] : session.damage()) {
        for (std::size_t bond = 0; bond < damage.broken.size(); ++bond)
            if (damage.broken[bond]) bonds.emplace(instance, bond);
    }
    return bonds;
}

}  // namespace rubble::test
