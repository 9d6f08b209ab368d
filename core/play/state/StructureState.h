#pragma once

#include "core/play/scene/PlayStructure.h"
#include "core/structure/graph/BondDamage.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

/// The bonds of a structure in a session, from the first hit that damages them.
struct StructureState {
    std::uint32_t origin = 0;               // of the solid that it is
    std::uint32_t parent = kNone;           // PlayStructure::parent
    std::vector<BondDamage> damage;         // of each bond
    std::vector<std::uint32_t> bodyOfNode;  // number of the body that it is bonded in; kNone: it came off alone
    std::shared_ptr<const PlayStructure> structure;  // follows from the two above
};

}  // namespace rubble
