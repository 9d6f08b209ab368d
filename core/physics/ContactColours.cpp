#include "core/physics/ContactColours.h"

#include "core/base/Assert.h"

#include <bit>

namespace rubble {

std::uint32_t ContactColours::freeColour(std::uint64_t taken, bool isAgainstFixed) const {
    constexpr std::uint64_t kBetween = (std::uint64_t{1} << kBetweenBodies) - 1;
    const std::uint64_t free = ~taken & (isAgainstFixed ? ~kBetween : kBetween);
    return free == 0 ? kOneByOne : static_cast<std::uint32_t>(std::countr_zero(free));
}

ContactSlot ContactColours::add(std::uint32_t contact, std::uint32_t first, bool firstIsDynamic, std::uint32_t second,
                                bool secondIsDynamic) {
    const std::uint64_t taken =
        (firstIsDynamic ? m_coloursOfBody[first] : 0) | (secondIsDynamic ? m_coloursOfBody[second] : 0);
    ContactSlot slot{freeColour(taken, !firstIsDynamic || !secondIsDynamic), 0};
    Colour& colour = m_colours[slot.colour];
    slot.index = colour.count++;
    if (blockOf(slot) == colour.blocks.size()) {
        colour.blocks.push_back({});
        colour.references.push_back({});
    }
    if (slot.colour != kOneByOne) {
        const std::uint64_t bit = std::uint64_t{1} << slot.colour;
        if (firstIsDynamic) m_coloursOfBody[first] |= bit;
        if (secondIsDynamic) m_coloursOfBody[second] |= bit;
    }
    ContactBlock& home = block(slot);
    const auto lane = static_cast<std::size_t>(laneOf(slot));
    home.first[lane] = first;
    home.second[lane] = second;
    home.contact[lane] = contact;
    home.againstFixed[lane] = firstIsDynamic && secondIsDynamic ? 0.0f : 1.0f;
    return slot;
}

std::uint32_t ContactColours::remove(ContactSlot slot, bool firstIsDynamic, bool secondIsDynamic) {
    Colour& colour = m_colours[slot.colour];
    const int lane = laneOf(slot);
    if (slot.colour != kOneByOne) {
        const std::uint64_t bit = std::uint64_t{1} << slot.colour;
        const auto place = static_cast<std::size_t>(lane);
        if (firstIsDynamic) m_coloursOfBody[block(slot).first[place]] &= ~bit;
        if (secondIsDynamic) m_coloursOfBody[block(slot).second[place]] &= ~bit;
    }
    const ContactSlot last{slot.colour, --colour.count};
    const int lastLane = laneOf(last);
    std::uint32_t moved = ContactSlot::kNone;
    if (last.index != slot.index) {
        putLane(block(slot), lane, storedLane(block(last), lastLane));
        putLane(reference(slot), lane, storedLane(reference(last), lastLane));
        moved = block(slot).contact[static_cast<std::size_t>(lane)];
    }
    putLane(block(last), lastLane, {});
    putLane(reference(last), lastLane, {});
    if (lastLane == 0) {
        colour.blocks.pop_back();
        colour.references.pop_back();
    }
    return moved;
}

std::size_t ContactColours::contactCount() const {
    std::size_t count = 0;
    for (const Colour& colour : m_colours) count += colour.count;
    return count;
}

}  // namespace rubble
