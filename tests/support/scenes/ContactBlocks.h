#pragma once

#include "core/physics/step/LoadPaths.h"

namespace rubble::test {

/// The blocks of all contacts.
inline BlockList allBlocks(const WorldState& state) {
    BlockList blocks;
    for (const ContactColours::List& list : state.colours.lists()) {
        for (const ContactBlock& block : list.blocks) blocks.push_back(&block);
    }
    return blocks;
}

}  // namespace rubble::test
