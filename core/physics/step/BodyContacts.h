#pragma once

#include "core/physics/state/Contacts.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A contact as one of its bodies sees it.
struct BodyContact {
    std::uint32_t body = 0;
    std::uint32_t contact = 0;
    std::uint32_t other = 0;
};

/// Lists the contacts of some bodies; the lists keep their memory from step to step.
class BodyContacts {
public:
    /// Lists those that isWanted(body, other, separated contact, or null if it has a manifold) accepts, by ascending
    /// body and contact. `bodies` are awake and ascending.
    template <class IsWanted>
    std::span<const BodyContact> of(const WorldState& state, std::span<const std::uint32_t> bodies,
                                    const IsWanted& isWanted) {
        // The walk over the contacts of a body takes as long as a pass over so many.
        constexpr std::size_t kContactsPerWalk = 64;
        m_list.clear();
        if (bodies.empty()) return m_list;
        const std::size_t contacts = state.colours.contactCount() + state.separated.size();
        if (bodies.size() * kContactsPerWalk > contacts) {
            passAll(state, bodies, isWanted);
        } else {
            walk(state, bodies, isWanted);
        }
        std::ranges::sort(m_list, {}, [](const BodyContact& one) {
            return static_cast<std::uint64_t>(one.body) << 32 | one.contact;
        });
        return m_list;
    }

private:
    template <class IsWanted>
    void walk(const WorldState& state, std::span<const std::uint32_t> bodies, const IsWanted& isWanted) {
        for (const std::uint32_t body : bodies) {
            visitContacts(state, body, [&](std::uint32_t number, std::uint32_t other) {
                const Contact& contact = state.contacts[number];
                const SeparatedContact* const separated =
                    contact.slot.isSet() ? nullptr : &state.separated[contact.separatedIndex];
                if (isWanted(body, other, separated)) m_list.push_back({body, number, other});
            });
        }
    }
    template <class IsWanted>
    void passAll(const WorldState& state, std::span<const std::uint32_t> bodies, const IsWanted& isWanted) {
        m_isMarked.assign(state.bodies.size(), 0);
        for (const std::uint32_t body : bodies) m_isMarked[body] = 1;
        const auto add = [&](std::uint32_t number, std::uint32_t first, std::uint32_t second,
                             const SeparatedContact* separated) {
            if ((m_isMarked[first] | m_isMarked[second]) == 0) return;
            if (m_isMarked[first] != 0 && isWanted(first, second, separated)) m_list.push_back({first, number, second});
            if (m_isMarked[second] != 0 && isWanted(second, first, separated))
                m_list.push_back({second, number, first});
        };
        for (const ContactColours::List& list : state.colours.lists()) {
            for (const ContactBlock& block : list.blocks) {
                for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
                    add(block.contact[lane], block.first[lane], block.second[lane], nullptr);
                }
            }
        }
        for (const SeparatedContact& contact : state.separated)
            add(contact.contact, contact.bodies[0], contact.bodies[1], &contact);
    }

    std::vector<BodyContact> m_list;
    std::vector<std::uint8_t> m_isMarked;  // by body
};

}  // namespace rubble
