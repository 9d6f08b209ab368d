#pragma once

#include "core/fracture/PatternKindForward.h"
#include "core/fracture/Report.h"
#include "core/geometry/Polygon.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

struct Partition;
struct Pattern;

/// A grain as wood has one: along it distances count for less, so that the cells of all the pattern's seeds are so much longer than
/// they would be. Cuts and where seeds are thrown do not change.
struct Grain {
    double angle = 0.0;  // rad: of the grain, counter-clockwise from the x axis
    double ratio = 3.0;  // >= 1: how many times as far a cell reaches along it

    bool operator==(const Grain&) const = default;
    static const PatternKind kKind;
};

/// Takes points around an outline to a plane in which all directions count alike, and back. Relative to the outline's frame, which
/// keeps their digits far from zero.
class GrainMap {
public:
    /// Of all the pattern's layers of grain that are on, one after the other; none where there is none.
    static std::optional<GrainMap> of(const Pattern& pattern, const Polygon& outline);

    Vec2 operator()(Vec2 point) const { return there(point - m_origin); }
    /// Where a mapped point comes from.
    Vec2 origin(Vec2 mapped) const { return m_origin + back(mapped); }
    std::vector<Vec2> operator()(std::span<const Vec2> points) const;
    Polygon operator()(Polygon polygon) const;

    /// A partition of the mapped outline as one of the outline: the outline's own points come back bit for bit.
    Partition back(Partition partition, const Polygon& outline) const;
    /// The other way: for checks of cells.
    Partition operator()(Partition partition) const;

private:
    Vec2 there(Vec2 offset) const { return m_there[0] * offset.x + m_there[1] * offset.y; }
    Vec2 back(Vec2 mapped) const { return m_back[0] * mapped.x + m_back[1] * mapped.y; }

    Vec2 m_origin{0.0, 0.0};
    std::array<Vec2, 2> m_there{};  // columns of a matrix
    std::array<Vec2, 2> m_back{};   // of its inverse
};

}  // namespace rubble
