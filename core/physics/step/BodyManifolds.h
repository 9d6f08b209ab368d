#pragma once

#include "core/physics/state/Contacts.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rubble {

/// Visits the manifolds of bodies while none begins or ends: first by walks along their contacts, which wait for memory
/// at each; once that has taken as long as one pass over all, by lists of such a pass.
class BodyManifolds {
public:
    /// Calls visit(block, lane, other body) for each manifold of a body. The blocks are const if the state is.
    template <class State, class Visit>
    void visit(State& state, std::uint32_t body, const Visit& visit) {
        constexpr std::size_t kContactsPerWalk = 64;
        if (m_begins.empty() && ++m_walks * kContactsPerWalk > state.colours.contactCount()) build(state);
        if (m_begins.empty()) {
            visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t other) {
                const ContactSlot slot = state.contacts[contact].slot;
                if (slot.isSet())
                    visit(state.colours.block(slot), static_cast<std::size_t>(ContactColours::laneOf(slot)), other);
            });
            return;
        }
        for (std::size_t i = m_begins[body]; i < m_begins[body + 1]; ++i) {
            const Place& place = m_places[i];
            visit(state.colours.lists()[place.list].blocks[place.block], place.lane, place.other);
        }
    }

private:
    struct Place {
        std::uint32_t contact, other, list, block, lane;
    };

    template <class Visit>
    static void visitLanes(const WorldState& state, const Visit& visit) {
        for (std::uint32_t list = 0; list < state.colours.lists().size(); ++list) {
            const std::vector<ContactBlock>& blocks = state.colours.lists()[list].blocks;
            for (std::uint32_t block = 0; block < blocks.size(); ++block) {
                for (std::uint32_t lane = 0; lane < kBlockLanes; ++lane) {
                    const std::uint32_t first = blocks[block].first[lane], second = blocks[block].second[lane];
                    if (first == second) continue;  // an empty lane
                    visit(first, Place{blocks[block].contact[lane], second, list, block, lane});
                    visit(second, Place{blocks[block].contact[lane], first, list, block, lane});
                }
            }
        }
    }
    /// By ascending contact: where a contact is in its list depends on the regions of threads.
    void build(const WorldState& state) {
        m_begins.assign(state.bodies.size() + 1, 0);
        visitLanes(state, [&](std::uint32_t body, const Place&) { ++m_begins[body + 1]; });
        for (std::size_t body = 0; body < state.bodies.size(); ++body) m_begins[body + 1] += m_begins[body];
        m_places.resize(m_begins.back());
        std::vector<std::size_t> next(m_begins.begin(), m_begins.end() - 1);
        visitLanes(state, [&](std::uint32_t body, const Place& place) { m_places[next[body]++] = place; });
        for (std::size_t body = 0; body < state.bodies.size(); ++body) {
            const auto at = [&](std::size_t i) { return m_places.begin() + static_cast<std::ptrdiff_t>(i); };
            std::sort(at(m_begins[body]), at(m_begins[body + 1]),
                      [](const Place& a, const Place& b) { return a.contact < b.contact; });
        }
    }

    std::size_t m_walks = 0;
    std::vector<std::size_t> m_begins;  // by body, and the end; empty until the pass
    std::vector<Place> m_places;
};

}  // namespace rubble
