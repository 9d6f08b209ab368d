#include "core/physics/solver/ContactColours.h"

#include "core/base/Assert.h"

#include <bit>

namespace rubble {
namespace {

/// The first colour of neither body, or kColours.
std::uint32_t freeColour(std::uint64_t taken, bool isAgainstFixed) {
    constexpr std::uint64_t kBetween = (std::uint64_t{1} << ContactColours::kBetweenBodies) - 1;
    const std::uint64_t free = ~taken & (isAgainstFixed ? ~kBetween : kBetween);
    return free == 0 ? ContactColours::kColours : static_cast<std::uint32_t>(std::countr_zero(free));
}

std::uint32_t listOf(std::uint32_t colour, std::uint32_t pointCount) {
    if (colour == ContactColours::kColours) return ContactColours::kOverflow;
    return 2 * colour + (pointCount > ContactColours::kFewPoints ? 1 : 0);
}

std::uint64_t bitOf(std::uint32_t list) {
    return list == ContactColours::kOverflow ? 0 : std::uint64_t{1} << (list / 2);
}

}  // namespace

void ContactColours::swapLanes(ContactSlot a, ContactSlot b) {
    const auto swap = [&](auto& first, auto& second) {
        const auto stored = storedLane(first, laneOf(a));
        putLane(first, laneOf(a), storedLane(second, laneOf(b)));
        putLane(second, laneOf(b), stored);
    };
    swap(block(a), block(b));
    swap(reference(a), reference(b));
}

ContactSlot ContactColours::addLane(std::uint32_t number) {
    List& list = m_lists[number];
    const ContactSlot slot{number, list.count++};
    if (blockOf(slot) == list.blocks.size()) {
        list.blocks.emplace_back();
        list.references.emplace_back();
    }
    return slot;
}

std::uint32_t ContactColours::removeLane(ContactSlot slot) {
    List& list = m_lists[slot.list];
    const ContactSlot last{slot.list, --list.count};
    const int lane = laneOf(slot), lastLane = laneOf(last);
    std::uint32_t moved = kNone;
    if (last.index != slot.index) {
        putLane(block(slot), lane, storedLane(block(last), lastLane));
        putLane(reference(slot), lane, storedLane(reference(last), lastLane));
        moved = contactAt(slot);
    }
    if (lastLane == 0) {
        list.blocks.pop_back();
        list.references.pop_back();
    } else {
        putLane(block(last), lastLane, {});
        putLane(reference(last), lastLane, {});
    }
    return moved;
}

ContactSlot ContactColours::add(std::uint32_t contact, std::uint32_t first, bool firstIsDynamic, std::uint32_t second,
                                bool secondIsDynamic, std::uint32_t pointCount) {
    const std::uint64_t taken =
        (firstIsDynamic ? m_coloursOfBody[first] : 0) | (secondIsDynamic ? m_coloursOfBody[second] : 0);
    const ContactSlot slot = addLane(listOf(freeColour(taken, !firstIsDynamic || !secondIsDynamic), pointCount));
    if (firstIsDynamic) m_coloursOfBody[first] |= bitOf(slot.list);
    if (secondIsDynamic) m_coloursOfBody[second] |= bitOf(slot.list);
    ContactBlock& home = block(slot);
    const auto lane = static_cast<std::size_t>(laneOf(slot));
    home.first[lane] = first;
    home.second[lane] = second;
    home.contact[lane] = contact;
    home.againstFixed[lane] = firstIsDynamic && secondIsDynamic ? 0.0f : 1.0f;
    return slot;
}

std::uint32_t ContactColours::remove(ContactSlot slot, bool firstIsDynamic, bool secondIsDynamic) {
    const auto lane = static_cast<std::size_t>(laneOf(slot));
    if (firstIsDynamic) m_coloursOfBody[block(slot).first[lane]] &= ~bitOf(slot.list);
    if (secondIsDynamic) m_coloursOfBody[block(slot).second[lane]] &= ~bitOf(slot.list);
    return removeLane(slot);
}

std::uint32_t ContactColours::moveToOtherList(ContactSlot& slot) {
    RUBBLE_ASSERT(slot.list != kOverflow);
    const ContactSlot home = addLane(slot.list ^ 1u);
    putLane(block(home), laneOf(home), storedLane(block(slot), laneOf(slot)));
    putLane(reference(home), laneOf(home), storedLane(reference(slot), laneOf(slot)));
    const std::uint32_t moved = removeLane(slot);
    slot = home;
    return moved;
}

std::size_t ContactColours::contactCount() const {
    std::size_t count = 0;
    for (const List& list : m_lists) count += list.count;
    return count;
}

int ContactColours::colourCount() const {
    int count = 0;
    for (std::size_t i = 0; i < kLists; i += 2) {
        count += m_lists[i].count > 0 || (i + 1 < kLists && m_lists[i + 1].count > 0) ? 1 : 0;
    }
    return count;
}

std::optional<std::string> ContactColours::verifyColours(const std::vector<bool>& isDynamic) const {
    if (m_lists.size() != kLists) return "lists";
    if (m_coloursOfBody.size() != isDynamic.size()) return "coloursOfBody";
    std::vector<std::uint64_t> colours(isDynamic.size(), 0);
    for (std::uint32_t number = 0; number < kLists; ++number) {
        const List& list = m_lists[number];
        const std::string place = "lists[" + std::to_string(number) + "]";
        const std::size_t lanes = number == kOverflow ? 1 : kBlockLanes;
        const std::size_t blocks = (std::size_t{list.count} + lanes - 1) / lanes;
        if (list.blocks.size() != blocks || list.references.size() != blocks) return place;
        for (std::size_t k = 0; k < blocks * kBlockLanes; ++k) {
            const ContactBlock& home = list.blocks[k / kBlockLanes];
            const std::size_t lane = k % kBlockLanes;
            const bool isUsed = number == kOverflow ? lane == 0 : k < list.count;
            const std::uint32_t first = home.first[lane], second = home.second[lane];
            if (isUsed != (first != 0) || isUsed != (second != 0) || home.pointCount[lane] > 4) return place;
            if (!isUsed && (home.pointCount[lane] != 0 || home.contact[lane] != 0)) return place;
            if (first >= isDynamic.size() || second >= isDynamic.size()) return place;
            const bool isAgainstFixed = isUsed && !(isDynamic[first] && isDynamic[second]);
            if (home.againstFixed[lane] != (isAgainstFixed ? 1.0f : 0.0f)) return place;
            for (const std::uint32_t body : {first, second}) {
                if (!isDynamic[body] || number == kOverflow) continue;
                if ((colours[body] & bitOf(number)) != 0) return place;
                colours[body] |= bitOf(number);
            }
        }
    }
    for (std::size_t body = 0; body < colours.size(); ++body) {
        if (colours[body] != m_coloursOfBody[body]) return "coloursOfBody[" + std::to_string(body) + "]";
    }
    return std::nullopt;
}

}  // namespace rubble
