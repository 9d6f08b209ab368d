#include "core/physics/state/StateSize.h"

#include "core/base/ByteCount.h"

namespace rubble {

std::size_t byteCount(const WorldState& state) {
    std::size_t bytes = sizeof(WorldState) + state.tree.byteCount() + state.pairs.byteCount();
    bytes += elementBytes(state.bodies, state.motions, state.poses, state.predictedTravel, state.predictions,
                          state.obstacleSizes, state.freeBodies, state.awake, state.woken);
    bytes += elementBytes(state.proxies, state.freeProxies, state.rebox, state.contacts, state.freeContacts,
                          state.separated);
    bytes += elementBytes(state.sleepingIslands, state.freeSleepingIslands, state.stored, state.freeStored);
    bytes += elementBytes(state.events.began, state.events.ended, state.events.hits, state.events.fellAsleep);
    for (const ContactColours::List& list : state.colours.lists()) bytes += elementBytes(list.blocks, list.references);
    for (const SleepingIsland& island : state.sleepingIslands) bytes += elementBytes(island.bodies, island.contacts);
    return bytes;
}

}  // namespace rubble
