#pragma once

#include "core/physics/ContactBlock.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Where a contact's lane is.
struct ContactSlot {
    static constexpr std::uint32_t kNone = ~0u;
    std::uint32_t colour = kNone;
    std::uint32_t index = 0;
    bool isSet() const { return colour != kNone; }
};

/// Contacts with a manifold, in colours: no two of a colour share a dynamic body, so that those of one colour are solved side by
/// side, and in any order with the same result. Contacts against fixed bodies have colours of their own, solved last: what stands
/// on the ground is held up by the last word. What finds no colour is solved one by one, after all others.
/// Source: Tonge, Benevolenski, Voroshilov 2012; Catto 2024, "Simulation Islands".
class ContactColours {
public:
    static constexpr std::uint32_t kBetweenBodies = 48;  // colours for contacts of two dynamic bodies
    static constexpr std::uint32_t kColours = 64;        // one bit each in a body's set
    static constexpr std::uint32_t kOneByOne = kColours;

    struct Colour {
        std::vector<ContactBlock> blocks;
        std::vector<ReferenceBlock> references;
        std::uint32_t count = 0;  // contacts; eight a block, but one a block of those solved one by one
    };

    void resizeBodies(std::size_t count) { m_coloursOfBody.resize(count, 0); }

    /// A cleared lane for a contact of these bodies. Those that are not dynamic may be in any number of a colour's lanes.
    ContactSlot add(std::uint32_t contact, std::uint32_t first, bool firstIsDynamic, std::uint32_t second,
                    bool secondIsDynamic);
    /// Frees a lane. The last of its colour moves there: gives that contact, whose slot is now this, or kNone.
    std::uint32_t remove(ContactSlot slot, bool firstIsDynamic, bool secondIsDynamic);

    ContactBlock& block(ContactSlot slot) { return m_colours[slot.colour].blocks[blockOf(slot)]; }
    const ContactBlock& block(ContactSlot slot) const { return m_colours[slot.colour].blocks[blockOf(slot)]; }
    ReferenceBlock& reference(ContactSlot slot) { return m_colours[slot.colour].references[blockOf(slot)]; }
    static int laneOf(ContactSlot slot) {
        return slot.colour == kOneByOne ? 0 : static_cast<int>(slot.index % kBlockLanes);
    }

    std::span<Colour> colours() { return m_colours; }
    std::span<const Colour> colours() const { return m_colours; }
    std::size_t contactCount() const;

private:
    static std::size_t blockOf(ContactSlot slot) {
        return slot.colour == kOneByOne ? slot.index : slot.index / kBlockLanes;
    }
    std::uint32_t freeColour(std::uint64_t taken, bool isAgainstFixed) const;

    std::vector<Colour> m_colours = std::vector<Colour>(kColours + 1);
    std::vector<std::uint64_t> m_coloursOfBody;  // of dynamic bodies
};

}  // namespace rubble
