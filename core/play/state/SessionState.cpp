#include "core/play/state/SessionState.h"

namespace rubble {
namespace {

template <class... Elements>
std::size_t sum(const std::vector<Elements>&... vectors) {
    return (... + (vectors.size() * sizeof(Elements)));
}

}  // namespace

std::size_t byteCount(const SessionState& state) {
    const PlayEvents& events = state.events;
    return sizeof(SessionState) + sum(state.bodies, state.origins, state.pending, state.materials, state.recentBreaks) +
           sum(events.inputs, events.breaks, events.impacts, events.born, events.removed, events.notices);
}

}  // namespace rubble
