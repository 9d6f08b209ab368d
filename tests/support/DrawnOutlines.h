#pragma once

#include "core/asset/RoughCuts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace rubble::test {

/// The outline of a fragment as it is drawn, rough, in the asset's frame.
inline Polygon drawnOutline(const Bake& bake, std::uint32_t fragment, const RoughCuts& cuts) {
    const Fragment solid = bake.fragment(fragment).solid;
    const Vec2 offset{solid.offset()};
    const Polygon outline = solid.outline();
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

/// A boundary put together from outlines, in which what runs there and back along the same way vanishes.
class BoundarySum {
public:
    /// `turns`: how many times, less than 0 for backwards.
    void add(const Polygon& outline, int turns) {
        add(outline.outer, turns);
        for (const Ring& hole : outline.holes) add(hole, turns);
    }

    /// How much is left of it, m. Straight edges that others meet in their middle are parted there.
    double leftOver() {
        partWhatIsLeft();
        double length = 0.0;
        for (const auto& [edge, turns] : m_turns) {
            length += std::abs(turns) * glm::distance(m_places[edge.first], m_places[edge.second]);
        }
        return length;
    }

private:
    static constexpr double kSame = 1e-9;  // m: outlines of other frames are rounded apart by far less
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    void add(const Ring& ring, int turns) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            add(placeOf(ring[k]), placeOf(ring[k + 1 < ring.size() ? k + 1 : 0]), turns);
        }
    }

    void add(std::uint32_t from, std::uint32_t to, int turns) {
        if (from == to) return;
        const Edge edge{std::min(from, to), std::max(from, to)};
        if ((m_turns[edge] += from < to ? turns : -turns) == 0) m_turns.erase(edge);
    }

    void partWhatIsLeft() {
        std::vector<std::pair<double, std::uint32_t>> ends;  // x, place
        for (const auto& [edge, turns] : m_turns) {
            for (const std::uint32_t end : {edge.first, edge.second}) ends.emplace_back(m_places[end].x, end);
        }
        std::ranges::sort(ends);
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        const std::map<Edge, int> whole = std::exchange(m_turns, {});
        for (const auto& [edge, turns] : whole) addParted(edge, turns, ends);
    }

    void addParted(Edge edge, int turns, const std::vector<std::pair<double, std::uint32_t>>& ends) {
        const Vec2 from = m_places[edge.first], to = m_places[edge.second];
        const double length = glm::distance(from, to);
        const Vec2 along = (to - from) / length;
        std::vector<std::pair<double, std::uint32_t>> stops{{0.0, edge.first}, {length, edge.second}};
        const auto begin = std::ranges::lower_bound(ends, std::pair(std::min(from.x, to.x) - kSame, 0u));
        for (auto end = begin; end != ends.end() && end->first <= std::max(from.x, to.x) + kSame; ++end) {
            const Vec2 way = m_places[end->second] - from;
            const double place = glm::dot(way, along);
            const bool isOn = std::abs(glm::dot(way, perpendicular(along))) <= kSame && place > 0.0 && place < length;
            if (isOn && end->second != edge.first && end->second != edge.second) stops.emplace_back(place, end->second);
        }
        std::ranges::sort(stops);
        for (std::size_t k = 0; k + 1 < stops.size(); ++k) add(stops[k].second, stops[k + 1].second, turns);
    }

    /// The number of a place, or of one that is as good as the same.
    std::uint32_t placeOf(Vec2 place) {
        const auto x = static_cast<std::int64_t>(std::floor(place.x / kSame / 4.0));
        const auto y = static_cast<std::int64_t>(std::floor(place.y / kSame / 4.0));
        for (std::int64_t i = x - 1; i <= x + 1; ++i) {
            for (std::int64_t j = y - 1; j <= y + 1; ++j) {
                const auto found = m_numbers.find({i, j});
                if (found != m_numbers.end() && glm::distance(m_places[found->second], place) <= kSame)
                    return found->second;
            }
        }
        const auto number = static_cast<std::uint32_t>(m_places.size());
        m_places.push_back(place);
        m_numbers.insert({{x, y}, number});
        return number;
    }

    std::vector<Vec2> m_places;
    std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> m_numbers;
    std::map<Edge, int> m_turns;
};

}  // namespace rubble::test
