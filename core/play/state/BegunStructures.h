#pragma once

#include "core/play/state/SessionState.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble {

/// The structures of whole instances of which bonds were damaged, by instance. Valid while no structure is begun.
class BegunStructures {
public:
    explicit BegunStructures(const SessionState& state) : m_state(state) {
        for (std::uint32_t k = 0; k < state.structures.size(); ++k) {
            const StructureState& one = state.structures[k];
            if (one.parent == kNone) m_indices.emplace_back(state.origins[one.origin].instance, k);
        }
        std::ranges::sort(m_indices);
    }

    /// Its index in SessionState::structures; kNone: no bond of it was damaged.
    std::uint32_t indexOf(Id instance) const {
        const auto found = std::ranges::lower_bound(m_indices, instance, {}, &std::pair<Id, std::uint32_t>::first);
        return found != m_indices.end() && found->first == instance ? found->second : kNone;
    }
    /// Null: no bond of it was damaged.
    const StructureState* find(Id instance) const {
        const std::uint32_t index = indexOf(instance);
        return index != kNone ? &m_state.structures[index] : nullptr;
    }

private:
    const SessionState& m_state;
    std::vector<std::pair<Id, std::uint32_t>> m_indices;
};

}  // namespace rubble
