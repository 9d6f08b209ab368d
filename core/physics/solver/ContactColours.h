#pragma once

#include "core/base/Assert.h"
#include "core/base/Index.h"
#include "core/physics/solver/ContactBlock.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The position of a contact's lane.
struct ContactSlot {
    std::uint32_t list = kNone;
    std::uint32_t index = 0;
    bool isSet() const { return list != kNone; }
};

/// The constraint graph: contacts with a manifold, by colour. No two contacts of a colour share a dynamic body, so that
/// they can be solved in parallel and in any order with the same result. Contacts with fixed bodies have colours of
/// their own, solved last, so that the ground has priority. Contacts that find no colour are overflow, solved one by
/// one after all others. Each colour has two lists, of contacts with few and with many points, so that the lanes of a
/// block have similar point counts.
/// Source: Tonge, Benevolenski, Voroshilov 2012; Catto 2024, "Simulation Islands".
class ContactColours {
public:
    static constexpr std::uint32_t kBetweenBodies = 48;  // colours for contacts between two dynamic bodies
    static constexpr std::uint32_t kColours = 64;        // one bit each in the set of a body
    static constexpr std::uint32_t kLists = 2 * kColours + 1;
    static constexpr std::uint32_t kOverflow = kLists - 1;  // the list of contacts without colour
    static constexpr std::size_t kMaxCells = 256;
    using CellEnds = std::array<std::uint32_t, kMaxCells>;
    static constexpr std::uint32_t kFewPoints = 2;  // the most points of a contact in a colour's first list

    struct List {
        std::vector<ContactBlock> blocks;
        std::vector<ReferenceBlock> references;
        std::uint32_t count = 0;  // contacts; eight per block, but one per block of the overflow list
        template <class Self, class Visit>
        static void visitFields(Self& self, Visit& visit) {
            visit("blocks", self.blocks);
            visit("references", self.references);
            visit("count", self.count);
        }
    };

    void resizeBodies(std::size_t count) { m_coloursOfBody.resize(count, 0); }

    /// Assigns a cleared lane to a contact of these bodies. Bodies that are not dynamic may be in several lanes of a
    /// colour.
    ContactSlot add(std::uint32_t contact, std::uint32_t first, bool firstIsDynamic, std::uint32_t second,
                    bool secondIsDynamic, std::uint32_t pointCount);
    /// Frees a lane. The last contact of the list moves into it; returns that contact, which is in `slot` now, or
    /// kNone.
    std::uint32_t remove(ContactSlot slot, bool firstIsDynamic, bool secondIsDynamic);

    /// Whether a contact with this point count belongs in its colour's other list.
    static bool isMisplaced(ContactSlot slot, std::uint32_t pointCount) {
        return slot.list != kOverflow && slot.list % 2 != (pointCount > kFewPoints ? 1u : 0u);
    }
    /// Moves a contact and its lane to the other list of its colour. Returns the contact that moved into its slot, or
    /// kNone.
    std::uint32_t moveToOtherList(ContactSlot& slot);

    /// Sorts the contacts of a list by cellOf(first body, second body), a number below `cells`, with the fewest swaps,
    /// and calls moved(contact, slot) for each that moved. Returns the end of each cell. Results do not depend on the
    /// order. Several lists may be sorted in parallel.
    template <class CellOf, class Moved>
    CellEnds sort(std::uint32_t list, std::size_t cells, const CellOf& cellOf, const Moved& moved) {
        const auto cellAt = [&](std::uint32_t index) -> std::size_t {
            const ContactBlock& home = block({list, index});
            const auto lane = static_cast<std::size_t>(index % kBlockLanes);
            return cellOf(home.first[lane], home.second[lane]);
        };
        RUBBLE_ASSERT(cells <= kMaxCells);
        std::array<std::uint32_t, kMaxCells + 1> next{};
        CellEnds end{};
        for (std::uint32_t index = 0; index < m_lists[list].count; ++index) ++next[cellAt(index) + 1];
        for (std::size_t cell = 0; cell < cells; ++cell) end[cell] = next[cell + 1] += next[cell];
        for (std::size_t cell = 0; cell < cells; ++cell) {
            for (; next[cell] < end[cell]; ++next[cell]) {
                const ContactSlot slot{list, next[cell]};
                for (std::size_t target = cellAt(slot.index); target != cell; target = cellAt(slot.index)) {
                    const ContactSlot other{list, next[target]++};
                    if (cellAt(other.index) == target) continue;
                    swapLanes(slot, other);
                    moved(contactAt(slot), slot);
                    moved(contactAt(other), other);
                }
            }
        }
        return end;
    }

    ContactBlock& block(ContactSlot slot) { return m_lists[slot.list].blocks[blockOf(slot)]; }
    const ContactBlock& block(ContactSlot slot) const { return m_lists[slot.list].blocks[blockOf(slot)]; }
    ReferenceBlock& reference(ContactSlot slot) { return m_lists[slot.list].references[blockOf(slot)]; }
    static int laneOf(ContactSlot slot) {
        return slot.list == kOverflow ? 0 : static_cast<int>(slot.index % kBlockLanes);
    }

    /// The lists in solving order; lists 2k and 2k + 1 form one colour.
    std::span<List> lists() { return m_lists; }
    std::span<const List> lists() const { return m_lists; }
    static std::uint32_t colourOf(std::size_t list) { return static_cast<std::uint32_t>(list / 2); }
    int colourCount() const;
    std::size_t contactCount() const;
    /// The list whose lanes do not fit, as "lists[5]", or the body whose colours are not those of its contacts;
    /// nothing if all do. `isDynamic` says it of each body.
    std::optional<std::string> verifyColours(const std::vector<bool>& isDynamic) const;
    /// Visits everything that is saved.
    template <class Self, class Visit>
    static void visitFields(Self& self, Visit& visit) {
        visit("lists", self.m_lists);
        visit("coloursOfBody", self.m_coloursOfBody);
    }

private:
    static std::size_t blockOf(ContactSlot slot) {
        return slot.list == kOverflow ? slot.index : slot.index / kBlockLanes;
    }
    std::uint32_t contactAt(ContactSlot slot) const {
        return block(slot).contact[static_cast<std::size_t>(laneOf(slot))];
    }
    void swapLanes(ContactSlot a, ContactSlot b);
    ContactSlot addLane(std::uint32_t list);
    std::uint32_t removeLane(ContactSlot slot);

    std::vector<List> m_lists = std::vector<List>(kLists);
    std::vector<std::uint64_t> m_coloursOfBody;  // a set per body; of dynamic bodies only
};

}  // namespace rubble
