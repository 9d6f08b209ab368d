#pragma once

#include "core/base/Parallel.h"
#include "core/base/UninitializedVector.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rubble {

/// Items by group, in two arrays.
template <class Item>
struct Groups {
    std::vector<std::uint32_t> first;  // groups + 1
    UninitializedVector<Item> items;

    std::span<const Item> of(std::size_t group) const {
        return std::span(items).subspan(first[group], first[group + 1] - first[group]);
    }
    std::span<Item> of(std::size_t group) {
        return std::span(items).subspan(first[group], first[group + 1] - first[group]);
    }
};

/// Groups what `forEach` gives: each call of forEach(part, visit), on any thread, calls visit(group, item) for the same
/// items in the same order. In their groups, items are in the order of parts, then in this one. Called twice for each
/// part. O(items + groups · parts).
template <class Item, class ForEach>
Groups<Item> grouped(std::size_t groups, std::size_t parts, int threads, const ForEach& forEach) {
    std::vector<std::vector<std::uint32_t>> next(parts);  // of each group: at first, how many items it has of the part
    forEachIndex(parts, threads, [&](std::size_t part) {
        std::vector<std::uint32_t>& counts = next[part];
        counts.assign(groups, 0);
        forEach(part, [&](std::size_t group, const Item&) { ++counts[group]; });
    });
    Groups<Item> result;
    result.first.resize(groups + 1);
    std::uint32_t first = 0;
    for (std::size_t group = 0; group < groups; ++group) {
        result.first[group] = first;
        for (std::vector<std::uint32_t>& of : next) first += std::exchange(of[group], first);
    }
    result.first[groups] = first;
    result.items.resize(first);
    forEachIndex(parts, threads, [&](std::size_t part) {
        std::vector<std::uint32_t>& places = next[part];
        forEach(part, [&](std::size_t group, const Item& item) { result.items[places[group]++] = item; });
    });
    return result;
}

/// In how many parts items are grouped by some threads: each part needs a number for each group.
inline std::size_t groupingParts(int threads) { return static_cast<std::size_t>(std::clamp(threads, 1, 8)); }

/// The same on one thread: each call of forEach(visit) calls visit(group, item).
template <class Item, class ForEach>
Groups<Item> grouped(std::size_t groups, const ForEach& forEach) {
    return grouped<Item>(groups, 1, 1, [&](std::size_t, const auto& visit) { forEach(visit); });
}

}  // namespace rubble
