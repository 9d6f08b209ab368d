#pragma once

#include <cstdint>
#include <vector>

namespace rubble {

/// Finds the contact of two proxies. Open addressing with linear probing; what is removed is closed up, so that the table never
/// fills with gaps.
class PairTable {
public:
    static constexpr std::uint32_t kNone = ~0u;

    /// kNone where there is none.
    std::uint32_t find(std::uint32_t first, std::uint32_t second) const;
    /// False where the pair is in it, and stays as it is.
    bool insert(std::uint32_t first, std::uint32_t second, std::uint32_t contact);
    void erase(std::uint32_t first, std::uint32_t second);

private:
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t contact = kNone;  // kNone: empty
    };

    std::size_t placeOf(std::uint64_t key) const;
    void grow();

    std::vector<Entry> m_entries;
    std::size_t m_count = 0;
};

}  // namespace rubble
