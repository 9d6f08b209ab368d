#pragma once

#include "core/base/Index.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// A hash table from pairs of proxies to contacts. Open addressing with linear probing; removal shifts entries back, so
/// that no tombstones accumulate.
class PairTable {
public:
    /// The contact of a pair, in either order; kNone if there is none.
    std::uint32_t find(std::uint32_t first, std::uint32_t second) const;
    /// False, without a change, if the table contains the pair.
    bool insert(std::uint32_t first, std::uint32_t second, std::uint32_t contact);
    /// The table must contain the pair.
    void erase(std::uint32_t first, std::uint32_t second);
    std::size_t size() const { return m_count; }
    /// Where a search would go wrong, as "entries[5]"; nothing if each pair is found.
    std::optional<std::string> verifyTable() const;
    /// Visits everything that is saved.
    template <class Self, class Visit>
    static void visitFields(Self& self, Visit& visit) {
        visit("entries", self.m_entries);
        visit("count", self.m_count);
    }
    std::size_t byteCount() const { return m_entries.size() * sizeof(Entry); }

private:
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t contact = kNone;  // kNone: empty
        template <class Self, class Visit>
        static void visitFields(Self& self, Visit& visit) {
            visit("key", self.key);
            visit("contact", self.contact);
        }
    };

    std::size_t slotOf(std::uint64_t key) const;
    void grow();

    std::vector<Entry> m_entries;
    std::size_t m_count = 0;
};

}  // namespace rubble
