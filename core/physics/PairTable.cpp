#include "core/physics/PairTable.h"

#include "core/base/Assert.h"
#include "core/base/Random.h"

#include <utility>

namespace rubble {
namespace {

constexpr std::size_t kFirstSize = 4096;

/// The same for both orders.
std::uint64_t keyOf(std::uint32_t first, std::uint32_t second) {
    if (second < first) std::swap(first, second);
    return static_cast<std::uint64_t>(first) << 32 | second;
}

}  // namespace

/// Where the key is, or would be put.
std::size_t PairTable::placeOf(std::uint64_t key) const {
    const std::size_t mask = m_entries.size() - 1;
    std::size_t place = mixed(key) & mask;
    while (m_entries[place].contact != kNone && m_entries[place].key != key) place = (place + 1) & mask;
    return place;
}

std::uint32_t PairTable::find(std::uint32_t first, std::uint32_t second) const {
    return m_entries.empty() ? kNone : m_entries[placeOf(keyOf(first, second))].contact;
}

void PairTable::grow() {
    std::vector<Entry> old(m_entries.empty() ? kFirstSize : 2 * m_entries.size());
    old.swap(m_entries);
    for (const Entry& entry : old) {
        if (entry.contact != kNone) m_entries[placeOf(entry.key)] = entry;
    }
}

bool PairTable::insert(std::uint32_t first, std::uint32_t second, std::uint32_t contact) {
    if (2 * (m_count + 1) > m_entries.size()) grow();
    const std::uint64_t key = keyOf(first, second);
    Entry& entry = m_entries[placeOf(key)];
    if (entry.contact != kNone) return false;
    entry = {key, contact};
    ++m_count;
    return true;
}

void PairTable::erase(std::uint32_t first, std::uint32_t second) {
    const std::size_t mask = m_entries.size() - 1;
    std::size_t gap = placeOf(keyOf(first, second));
    RUBBLE_ASSERT(m_entries[gap].contact != kNone);
    --m_count;
    // Whatever was pushed past the gap from at or before it comes back.
    for (std::size_t place = (gap + 1) & mask; m_entries[place].contact != kNone; place = (place + 1) & mask) {
        const std::size_t home = mixed(m_entries[place].key) & mask;
        if (((place - home) & mask) < ((place - gap) & mask)) continue;
        m_entries[gap] = m_entries[place];
        gap = place;
    }
    m_entries[gap] = {};
}

}  // namespace rubble
