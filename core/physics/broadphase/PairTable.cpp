#include "core/physics/broadphase/PairTable.h"

#include "core/base/Assert.h"
#include "core/base/Random.h"

#include <utility>

namespace rubble {
namespace {

constexpr std::size_t kInitialSize = 4096;

/// Equal for both orders.
std::uint64_t keyOf(std::uint32_t first, std::uint32_t second) {
    if (second < first) std::swap(first, second);
    return static_cast<std::uint64_t>(first) << 32 | second;
}

}  // namespace

/// The slot that contains the key, or where it would be inserted.
std::size_t PairTable::slotOf(std::uint64_t key) const {
    const std::size_t mask = m_entries.size() - 1;
    std::size_t slot = splitmix64(key) & mask;
    while (m_entries[slot].contact != kNone && m_entries[slot].key != key) slot = (slot + 1) & mask;
    return slot;
}

std::uint32_t PairTable::find(std::uint32_t first, std::uint32_t second) const {
    return m_entries.empty() ? kNone : m_entries[slotOf(keyOf(first, second))].contact;
}

void PairTable::grow() {
    std::vector<Entry> old(m_entries.empty() ? kInitialSize : 2 * m_entries.size());
    old.swap(m_entries);
    for (const Entry& entry : old) {
        if (entry.contact != kNone) m_entries[slotOf(entry.key)] = entry;
    }
}

bool PairTable::insert(std::uint32_t first, std::uint32_t second, std::uint32_t contact) {
    if (2 * (m_count + 1) > m_entries.size()) grow();
    const std::uint64_t key = keyOf(first, second);
    Entry& entry = m_entries[slotOf(key)];
    if (entry.contact != kNone) return false;
    entry = {key, contact};
    ++m_count;
    return true;
}

void PairTable::erase(std::uint32_t first, std::uint32_t second) {
    RUBBLE_ASSERT(find(first, second) != kNone);
    const std::size_t mask = m_entries.size() - 1;
    std::size_t gap = slotOf(keyOf(first, second));
    --m_count;
    // Entries whose home slot is at or before the gap move back into it.
    for (std::size_t slot = (gap + 1) & mask; m_entries[slot].contact != kNone; slot = (slot + 1) & mask) {
        const std::size_t home = splitmix64(m_entries[slot].key) & mask;
        if (((slot - home) & mask) < ((slot - gap) & mask)) continue;
        m_entries[gap] = m_entries[slot];
        gap = slot;
    }
    m_entries[gap] = {};
}

std::optional<std::string> PairTable::verifyTable() const {
    if (!m_entries.empty() && (m_entries.size() < kInitialSize || (m_entries.size() & (m_entries.size() - 1)) != 0)) {
        return "entries";
    }
    if (2 * m_count > m_entries.size()) return "count";
    std::size_t count = 0;
    for (const Entry& entry : m_entries) count += entry.contact != kNone ? 1 : 0;
    if (count != m_count) return "count";
    for (std::size_t k = 0; k < m_entries.size(); ++k) {
        const Entry& entry = m_entries[k];
        const bool isEmpty = entry.contact == kNone;
        if (isEmpty ? entry.key != 0 : slotOf(entry.key) != k) return "entries[" + std::to_string(k) + "]";
    }
    return std::nullopt;
}

}  // namespace rubble
