#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rubble {

/// A partition of the numbers [0, count) into sets, at first one for each, that are merged two by two. Each has a root,
/// one of its members. Amortised nearly O(1) an operation.
/// Source: Tarjan, Efficiency of a Good But Not Linear Set Union Algorithm, 1975, with path halving.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : m_parents(count) { std::iota(m_parents.begin(), m_parents.end(), 0u); }

    /// The root of the set that holds `member`, which must be below the count.
    std::uint32_t rootOf(std::uint32_t member) {
        while (m_parents[member] != member) member = m_parents[member] = m_parents[m_parents[member]];
        return member;
    }
    /// Merges the sets of two members; false if they are one already. The smaller root remains, so that roots are the
    /// smallest members and do not depend on the order of merges.
    bool merge(std::uint32_t a, std::uint32_t b) {
        a = rootOf(a), b = rootOf(b);
        m_parents[std::max(a, b)] = std::min(a, b);
        return a != b;
    }
    /// merge() for several threads at once, with the same sets and roots in the end; nothing else may be called
    /// meanwhile.
    /// Source: Anderson, Woll, Wait-free parallel algorithms for the union-find problem, 1991.
    bool mergeShared(std::uint32_t a, std::uint32_t b) {
        while (true) {
            a = sharedRootOf(a), b = sharedRootOf(b);
            if (a == b) return false;
            std::uint32_t root = std::max(a, b);
            const std::uint32_t under = std::min(a, b);
            // Fails if another thread has merged this root meanwhile.
            if (parent(root).compare_exchange_strong(root, under, std::memory_order_relaxed)) return true;
        }
    }
    /// Merges the sets of two different roots; `root` remains one.
    void mergeInto(std::uint32_t root, std::uint32_t other) { m_parents[other] = root; }

    std::size_t count() const { return m_parents.size(); }
    /// The root of each number.
    std::vector<std::uint32_t> roots() {
        for (std::uint32_t k = 0; k < m_parents.size(); ++k) m_parents[k] = rootOf(k);
        return m_parents;
    }

private:
    std::atomic_ref<std::uint32_t> parent(std::uint32_t member) { return std::atomic_ref(m_parents[member]); }
    std::uint32_t sharedRootOf(std::uint32_t member) {
        while (true) {
            const std::uint32_t above = parent(member).load(std::memory_order_relaxed);
            const std::uint32_t next = parent(above).load(std::memory_order_relaxed);
            if (next == above) return above;
            parent(member).store(next, std::memory_order_relaxed);  // any ancestor will do
            member = next;
        }
    }

    std::vector<std::uint32_t> m_parents;
};

}  // namespace rubble
