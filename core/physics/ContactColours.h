#pragma once

#include "core/base/Assert.h"
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
    static constexpr std::size_t kMostCells = 256;
    using CellEnds = std::array<std::uint32_t, kMostCells>;
    static constexpr std::uint32_t kFewPoints = 2;  // of a contact in a colour's first list, at most

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

    /// Brings the contacts of a list into order of cellOf(first body, second body), a number below `cells`, by as few exchanges
    /// as that takes, and calls moved(contact, slot) for each that moved. Nothing else depends on the order; lists may be brought
    /// into order side by side.
    template <class CellOf, class Moved>
    CellEnds order(std::uint32_t list, std::size_t cells, const CellOf& cellOf, const Moved& moved) {
        const auto cellAt = [&](std::uint32_t index) -> std::size_t {
            const ContactBlock& home = block({list, index});
            const auto lane = static_cast<std::size_t>(index % kBlockLanes);
            return cellOf(home.first[lane], home.second[lane]);
        };
        RUBBLE_ASSERT(cells <= kMostCells);
        std::array<std::uint32_t, kMostCells + 1> next{};
        CellEnds end{};
        for (std::uint32_t index = 0; index < m_lists[list].count; ++index) ++next[cellAt(index) + 1];
        for (std::size_t cell = 0; cell < cells; ++cell) end[cell] = next[cell + 1] += next[cell];
        for (std::size_t cell = 0; cell < cells; ++cell) {
            for (; next[cell] < end[cell]; ++next[cell]) {
                const ContactSlot slot{list, next[cell]};
                for (std::size_t other = cellAt(slot.index); other != cell; other = cellAt(slot.index)) {
                    const ContactSlot place{list, next[other]++};
                    if (cellAt(place.index) == other) continue;
                    exchangeLanes(slot, place);
                    moved(contactAt(slot), slot);
                    moved(contactAt(place), place);
                }
            }
        }
        return end;
    }

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
    std::uint32_t contactAt(ContactSlot slot) const {
        return block(slot).contact[static_cast<std::size_t>(laneOf(slot))];
    }
    void exchangeLanes(ContactSlot a, ContactSlot b);
    ContactSlot addLane(std::uint32_t list);
    std::uint32_t removeLane(ContactSlot slot);

    std::vector<List> m_lists = std::vector<List>(kLists);
    std::vector<std::uint64_t> m_coloursOfBody;  // of dynamic bodies
};

}  // namespace rubble
