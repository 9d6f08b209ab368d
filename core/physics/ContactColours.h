#pragma once

#include "core/physics/ContactBlock.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Where a contact's lane is.
struct ContactSlot {
    static constexpr std::uint32_t kNone = ~0u;
    std::uint32_t list = kNone;
    std::uint32_t index = 0;
    bool isSet() const { return list != kNone; }
};

/// Contacts with a manifold, in colours: no two of a colour share a dynamic body, so that those of one colour are solved side by
/// side, and in any order with the same result. Contacts against fixed bodies have colours of their own, solved last: what stands
/// on the ground is held up by the last word. What finds no colour is solved one by one, after all others. A colour has two lists,
/// of contacts at edges and at faces, so that a block's lanes have about as many points.
/// Source: Tonge, Benevolenski, Voroshilov 2012; Catto 2024, "Simulation Islands".
class ContactColours {
public:
    static constexpr std::uint32_t kBetweenBodies = 48;  // colours for contacts of two dynamic bodies
    static constexpr std::uint32_t kColours = 64;        // one bit each in a body's set
    static constexpr std::uint32_t kLists = 2 * kColours + 1;
    static constexpr std::uint32_t kOneByOne = kLists - 1;  // the list of those without colour
    static constexpr std::uint32_t kFewPoints = 2;          // of a contact in a colour's first list, at most

    struct List {
        std::vector<ContactBlock> blocks;
        std::vector<ReferenceBlock> references;
        std::uint32_t count = 0;  // contacts; eight a block, but one a block of those solved one by one
    };

    void resizeBodies(std::size_t count) { m_coloursOfBody.resize(count, 0); }

    /// A cleared lane for a contact of these bodies. Those that are not dynamic may be in any number of a colour's lanes.
    ContactSlot add(std::uint32_t contact, std::uint32_t first, bool firstIsDynamic, std::uint32_t second,
                    bool secondIsDynamic, std::uint32_t pointCount);
    /// Frees a lane. The last of its colour moves there: gives that contact, whose slot is now this, or kNone.
    std::uint32_t remove(ContactSlot slot, bool firstIsDynamic, bool secondIsDynamic);

    /// True where a contact of so many points is better kept in its colour's other list.
    static bool isMisplaced(ContactSlot slot, std::uint32_t pointCount) {
        return slot.list != kOneByOne && slot.list % 2 != (pointCount > kFewPoints ? 1u : 0u);
    }
    /// Moves a contact with all that is in its lane to the other list of its colour, and gives the contact that took its place, or
    /// kNone.
    std::uint32_t moveToOtherList(ContactSlot& slot);

    /// Sorts the contacts of each list by their bodies, so that neighbours in memory are neighbours in space and threads that share a
    /// list work on bodies of their own, and calls moved(contact, slot) for each. Nothing else depends on the order.
    template <class Moved>
    void sortByBodies(const Moved& moved) {
        for (std::uint32_t list = 0; list < kOneByOne; ++list) {
            sortList(m_lists[list]);
            for (std::uint32_t i = 0; i < m_lists[list].count; ++i) {
                const ContactSlot slot{list, i};
                moved(block(slot).contact[static_cast<std::size_t>(laneOf(slot))], slot);
            }
        }
        m_changes = 0;
    }
    /// Contacts that came, went or moved since they were sorted.
    std::size_t changes() const { return m_changes; }

    ContactBlock& block(ContactSlot slot) { return m_lists[slot.list].blocks[blockOf(slot)]; }
    const ContactBlock& block(ContactSlot slot) const { return m_lists[slot.list].blocks[blockOf(slot)]; }
    ReferenceBlock& reference(ContactSlot slot) { return m_lists[slot.list].references[blockOf(slot)]; }
    static int laneOf(ContactSlot slot) {
        return slot.list == kOneByOne ? 0 : static_cast<int>(slot.index % kBlockLanes);
    }

    /// In the order that they are solved in; lists 2k and 2k + 1 are of one colour.
    std::span<List> lists() { return m_lists; }
    std::span<const List> lists() const { return m_lists; }
    static std::uint32_t colourOf(std::size_t list) { return static_cast<std::uint32_t>(list / 2); }
    int colourCount() const;
    std::size_t contactCount() const;

private:
    static std::size_t blockOf(ContactSlot slot) {
        return slot.list == kOneByOne ? slot.index : slot.index / kBlockLanes;
    }
    static void sortList(List& list);
    ContactSlot addLane(std::uint32_t list);
    std::uint32_t removeLane(ContactSlot slot);

    std::vector<List> m_lists = std::vector<List>(kLists);
    std::vector<std::uint64_t> m_coloursOfBody;  // of dynamic bodies
    std::size_t m_changes = 0;
};

}  // namespace rubble
