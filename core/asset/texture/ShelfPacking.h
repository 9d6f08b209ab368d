#pragma once

#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// Texels.
struct TexelSize {
    int width = 0;
    int height = 0;
};
struct TexelPlace {
    int x = 0;
    int y = 0;
};

/// Places for rectangles in a square, in their order; nothing if they do not fit. They are sorted by height and laid in
/// rows, each as high as its first. O(n log n).
/// Source: Coffman, Garey, Johnson, Tarjan, "Performance bounds for level-oriented two-dimensional packing algorithms",
/// 1980 (next fit, decreasing height).
std::optional<std::vector<TexelPlace>> packedInShelves(std::span<const TexelSize> sizes, int side);

}  // namespace rubble
