#include "core/asset/texture/ShelfPacking.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace rubble {

std::optional<std::vector<TexelPlace>> packedInShelves(std::span<const TexelSize> sizes, int side) {
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t k) { return std::tuple(-sizes[k].height, -sizes[k].width, k); });
    std::vector<TexelPlace> places(sizes.size());
    TexelPlace next;
    int shelfHeight = 0;
    for (const std::size_t k : order) {
        const auto [width, height] = sizes[k];
        if (next.x + width > side) {
            next = {0, next.y + shelfHeight};
            shelfHeight = 0;
        }
        shelfHeight = std::max(shelfHeight, height);
        if (next.x + width > side || next.y + shelfHeight > side) return std::nullopt;
        places[k] = next;
        next.x += width;
    }
    return places;
}

}  // namespace rubble
