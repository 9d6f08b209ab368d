#pragma once

#include "core/play/scene/SupportSpread.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace rubble {

/// The support of a group of instances that mortar joins, kept between steps.
struct KeptSupport {
    std::unique_ptr<SupportSpread> spread;  // null: not known yet
    std::uint32_t begun = 0;                // how many of the structures were damaged
    std::vector<InstanceNode> unsupported;  // ascending: those that support does not reach, and did at the start
};

/// What a session keeps of support, by the first instance of each group. A copy begins without any: it follows from the
/// rest of the state, and need not be in snapshots.
struct KeptSupports {
    std::map<Id, KeptSupport> groups;

    KeptSupports() = default;
    KeptSupports(const KeptSupports&) {}
    KeptSupports& operator=(const KeptSupports&) {
        groups.clear();
        return *this;
    }
    KeptSupports(KeptSupports&&) = default;
    KeptSupports& operator=(KeptSupports&&) = default;
    ~KeptSupports() = default;
};

}  // namespace rubble
