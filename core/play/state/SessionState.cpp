#include "core/play/state/SessionState.h"

#include "core/base/ByteCount.h"

namespace rubble {

std::size_t byteCount(const SessionState& state) {
    const PlayEvents& events = state.events;
    std::size_t damage = 0;
    for (const auto& [origin, one] : state.damage) damage += sizeof(one) + one.broken.size() / 8;
    for (const PlayBody& body : state.bodies) damage += elementBytes(body.nodes);
    for (const StructureState& one : state.structures) damage += sizeof(one) + elementBytes(one.damage, one.bodyOfNode);
    return sizeof(SessionState) + damage +
           elementBytes(state.bodies, state.origins, state.pending, state.materials, state.reportedImpacts) +
           elementBytes(events.inputs, events.breaks, events.impacts, events.born, events.removed, events.taken,
                        events.diagnostics, events.happened, events.report.records);
}

}  // namespace rubble
