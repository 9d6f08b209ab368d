#include "core/physics/state/StateSize.h"

namespace rubble {
namespace {

template <class... Elements>
std::size_t sum(const std::vector<Elements>&... vectors) {
    return (... + (vectors.size() * sizeof(Elements)));
}

}  // namespace

std::size_t byteCount(const WorldState& state) {
    std::size_t bytes = sizeof(WorldState) + state.tree.byteCount() + state.pairs.byteCount();
    bytes += sum(state.bodies, state.motions, state.poses, state.predictedTravel, state.freeBodies, state.awake,
                 state.woken);
    bytes += sum(state.proxies, state.freeProxies, state.rebox, state.contacts, state.freeContacts, state.separated);
    bytes += sum(state.sleepingIslands, state.freeSleepingIslands, state.stored, state.freeStored);
    bytes += sum(state.events.began, state.events.ended, state.events.hits);
    for (const ContactColours::List& list : state.colours.lists()) bytes += sum(list.blocks, list.references);
    for (const SleepingIsland& island : state.sleepingIslands) bytes += sum(island.bodies, island.contacts);
    return bytes;
}

}  // namespace rubble
