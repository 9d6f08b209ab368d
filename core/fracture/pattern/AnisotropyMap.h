#pragma once

#include "core/fracture/partition/Partition.h"
#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

struct Pattern;

/// The affine map from an outline's plane to one in which distances are isotropic, and back. Relative to the outline's
/// local frame, which keeps the digits of coordinates far from zero.
class AnisotropyMap {
public:
    /// The composition of the pattern's enabled grain layers; nothing if there are none.
    static std::optional<AnisotropyMap> of(const Pattern& pattern, const Polygon& outline);

    Vec2 operator()(Vec2 point) const { return apply(point - m_origin); }
    /// The inverse map of a point.
    Vec2 inverse(Vec2 mapped) const { return m_origin + applyInverse(mapped); }
    std::vector<Vec2> operator()(std::span<const Vec2> points) const;
    Polygon operator()(Polygon polygon) const;

    /// Maps a partition of the mapped outline back to the outline, whose own points are restored bit for bit.
    Partition inverse(Partition partition, const Polygon& outline) const;
    /// Maps a partition, to verify its cells.
    Partition operator()(Partition partition) const;

private:
    Vec2 apply(Vec2 offset) const { return m_forward[0] * offset.x + m_forward[1] * offset.y; }
    Vec2 applyInverse(Vec2 mapped) const { return m_inverse[0] * mapped.x + m_inverse[1] * mapped.y; }

    Vec2 m_origin{0.0, 0.0};
    std::array<Vec2, 2> m_forward{};  // columns of a matrix
    std::array<Vec2, 2> m_inverse{};  // of its inverse
};

}  // namespace rubble
