#pragma once

#include "core/asset/mesh/FragmentMesh.h"
#include "core/asset/mesh/RoughCuts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace rubble::test {

/// The outline of a fragment with rough cuts, as it is drawn, in the asset's frame.
inline Polygon drawnOutline(const Bake& bake, std::uint32_t fragment, const RoughCuts& cuts) {
    const Fragment solid = bake.fragment(fragment).solid;
    const Vec2 offset{solid.offset()};
    const Polygon outline = solid.extruded()->outline();
    const EdgeCorners rough = cuts.cornersOf(fragment);
    std::size_t edge = 0;
    const auto drawn = [&](const Ring& ring) {
        Ring corners;
        for (const Vec2 corner : ring) {
            corners.push_back(corner + offset);
            if (!rough.empty()) {
                for (const Vec2 between : rough[edge]) corners.push_back(between + offset);
            }
            ++edge;
        }
        return corners;
    };
    Polygon polygon{drawn(outline.outer), {}};
    for (const Ring& hole : outline.holes) polygon.holes.push_back(drawn(hole));
    return polygon;
}

/// The sum of outlines as a chain, in which opposite edges cancel.
class BoundarySum {
public:
    /// Adds an outline `multiplicity` times; a negative multiplicity reverses it.
    void add(const Polygon& outline, int multiplicity) {
        add(outline.outer, multiplicity);
        for (const Ring& hole : outline.holes) add(hole, multiplicity);
    }

    /// The remaining length, m. Straight edges are split where others end on them.
    double remainingLength() {
        splitRemaining();
        double length = 0.0;
        for (const auto& [edge, multiplicity] : m_multiplicity) {
            length += std::abs(multiplicity) * glm::distance(m_points[edge.first], m_points[edge.second]);
        }
        return length;
    }

private:
    static constexpr double kTolerance = 1e-9;  // m: far above the rounding differences between frames
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    void add(const Ring& ring, int multiplicity) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            add(indexOf(ring[k]), indexOf(ring[k + 1 < ring.size() ? k + 1 : 0]), multiplicity);
        }
    }

    void add(std::uint32_t from, std::uint32_t to, int multiplicity) {
        if (from == to) return;
        const Edge edge{std::min(from, to), std::max(from, to)};
        if ((m_multiplicity[edge] += from < to ? multiplicity : -multiplicity) == 0) m_multiplicity.erase(edge);
    }

    void splitRemaining() {
        std::vector<std::pair<double, std::uint32_t>> ends;  // x, point
        for (const auto& [edge, multiplicity] : m_multiplicity) {
            for (const std::uint32_t end : {edge.first, edge.second}) ends.emplace_back(m_points[end].x, end);
        }
        std::ranges::sort(ends);
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        const std::map<Edge, int> unsplit = std::exchange(m_multiplicity, {});
        for (const auto& [edge, multiplicity] : unsplit) addSplit(edge, multiplicity, ends);
    }

    void addSplit(Edge edge, int multiplicity, const std::vector<std::pair<double, std::uint32_t>>& ends) {
        const Vec2 from = m_points[edge.first], to = m_points[edge.second];
        const double length = glm::distance(from, to);
        const Vec2 along = (to - from) / length;
        std::vector<std::pair<double, std::uint32_t>> stops{{0.0, edge.first}, {length, edge.second}};
        const auto begin = std::ranges::lower_bound(ends, std::pair(std::min(from.x, to.x) - kTolerance, 0u));
        for (auto end = begin; end != ends.end() && end->first <= std::max(from.x, to.x) + kTolerance; ++end) {
            const Vec2 offset = m_points[end->second] - from;
            const double position = glm::dot(offset, along);
            const bool isOn =
                std::abs(glm::dot(offset, perpendicular(along))) <= kTolerance && position > 0.0 && position < length;
            if (isOn && end->second != edge.first && end->second != edge.second)
                stops.emplace_back(position, end->second);
        }
        std::ranges::sort(stops);
        for (std::size_t k = 0; k + 1 < stops.size(); ++k) add(stops[k].second, stops[k + 1].second, multiplicity);
    }

    /// The index of a point, or of one that coincides with it.
    std::uint32_t indexOf(Vec2 point) {
        const auto x = static_cast<std::int64_t>(std::floor(point.x / kTolerance / 4.0));
        const auto y = static_cast<std::int64_t>(std::floor(point.y / kTolerance / 4.0));
        for (std::int64_t i = x - 1; i <= x + 1; ++i) {
            for (std::int64_t j = y - 1; j <= y + 1; ++j) {
                const auto found = m_indices.find({i, j});
                if (found != m_indices.end() && glm::distance(m_points[found->second], point) <= kTolerance)
                    return found->second;
            }
        }
        const auto index = static_cast<std::uint32_t>(m_points.size());
        m_points.push_back(point);
        m_indices.insert({{x, y}, index});
        return index;
    }

    std::vector<Vec2> m_points;
    std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> m_indices;
    std::map<Edge, int> m_multiplicity;
};

}  // namespace rubble::test
