#include "core/asset/RoughCuts.h"

#include "core/base/Random.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kShareOfRoom = 0.45;   // below a half: rough edges come to less than half way to each other
constexpr double kStepsPerBump = 4.0;   // of the finest octave
constexpr std::size_t kMostSteps = 64;  // of an edge; bumps that are finer are left out
constexpr double kFarthestCell = 1e15;  // of the lattice, where whole numbers are still told apart

/// In [-1, 1] at a lattice point.
double latticeValue(double x, double y, std::uint64_t randomSeed) {
    const auto number = [](double value) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(value)); };
    const std::uint64_t bits = mixedWith(mixedWith(randomSeed, number(x)), number(y));
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
}

/// From 0 to 1 with no slope nor bend at either end.
double smoothed(double share) { return share * share * share * (share * (share * 6.0 - 15.0) + 10.0); }

double valueNoise(Vec2 place, std::uint64_t randomSeed) {
    place = glm::clamp(place, -kFarthestCell, kFarthestCell);
    const Vec2 cell{std::floor(place.x), std::floor(place.y)};
    const double shareX = smoothed(place.x - cell.x), shareY = smoothed(place.y - cell.y);
    const auto row = [&](double y) {
        const double left = latticeValue(cell.x, y, randomSeed), right = latticeValue(cell.x + 1.0, y, randomSeed);
        return left + shareX * (right - left);
    };
    const double below = row(cell.y), above = row(cell.y + 1.0);
    return below + shareY * (above - below);
}

double distanceToEdge(Vec2 point, Vec2 from, Vec2 to) {
    const Vec2 edge = to - from;
    const double squared = glm::dot(edge, edge);
    const double along = squared > 0.0 ? std::clamp(glm::dot(point - from, edge) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, from + along * edge);
}

/// One edge of a piece, in the order that both of its sides agree on.
struct CutEdge {
    std::uint32_t from, to;  // points of the shapes
    std::uint32_t piece, across;
};

class RoughEdges {
public:
    RoughEdges(const Fragments& all, const Roughness& roughness, double gap)
        : m_all(all), m_shapes(all.shapes()), m_roughness(roughness), m_gap(gap) {}

    /// From one end to the other, in the order of CutEdge.
    std::vector<Vec2> corners(const CutEdge& edge) const {
        const Vec2 from = m_shapes.points[edge.from], to = m_shapes.points[edge.to];
        const double length = glm::distance(from, to);
        const double finest = m_roughness.frequency * static_cast<double>(1u << (m_roughness.octaves - 1));
        const double wanted = std::min(std::floor(length * finest * kStepsPerBump), static_cast<double>(kMostSteps));
        std::vector<Vec2> corners;
        if (!(wanted >= 2.0)) return corners;
        const auto steps = static_cast<std::size_t>(wanted);
        const Vec2 left = perpendicular((to - from) / length);
        for (std::size_t k = 1; k < steps; ++k) {
            const Vec2 place = from + static_cast<double>(k) / wanted * (to - from);
            corners.push_back(place + displacementAt(place, edge, length / wanted) * left);
        }
        return corners;
    }

private:
    double displacementAt(Vec2 place, const CutEdge& edge, double step) const {
        const Vec2 inAsset = m_shapes.origin + place + Vec2{m_all.origin};
        const double noise = fractalNoise(m_roughness.frequency * inAsset, m_roughness.octaves, m_roughness.randomSeed);
        double room = roomIn(edge.piece, place, edge);
        if (m_gap == 0.0) room = std::min(room, roomIn(edge.across, place, edge));
        double most = std::min(m_roughness.amplitude, kShareOfRoom * std::max(room - step, 0.0));
        if (m_gap > 0.0 && noise < 0.0) most = std::min(most, kShareOfRoom * m_gap);  // out of the piece
        return noise * most;
    }

    /// How far a point of an edge is from the other edges of a piece.
    double roomIn(std::uint32_t piece, Vec2 place, const CutEdge& edge) const {
        double room = 1e308;
        forEachEdge(m_shapes, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t) {
            const bool isSame = (from == edge.from && to == edge.to) || (from == edge.to && to == edge.from);
            if (!isSame) room = std::min(room, distanceToEdge(place, m_shapes.points[from], m_shapes.points[to]));
        });
        return room;
    }

    const Fragments& m_all;
    const Partition& m_shapes;
    const Roughness& m_roughness;
    double m_gap;
};

}  // namespace

double fractalNoise(Vec2 place, std::uint32_t octaves, std::uint64_t randomSeed) {
    double sum = 0.0, height = 1.0, total = 0.0;
    for (std::uint32_t octave = 0; octave < octaves; ++octave) {
        sum += height * valueNoise(place, mixedWith(randomSeed, octave));
        total += height;
        height /= 2.0;
        place *= 2.0;
    }
    return total > 0.0 ? sum / total : 0.0;
}

std::vector<std::vector<Vec2>> roughCorners(const Fragment& fragment, const Roughness& roughness, double gap) {
    const Fragments& all = fragment.all();
    const std::uint32_t piece = fragment.piece();
    const Vec2 centre = all.records[piece].moments.centre;
    const RoughEdges edges(all, roughness, gap);
    std::vector<std::vector<Vec2>> corners;
    forEachEdge(all.shapes(), piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
        std::vector<Vec2>& ofEdge = corners.emplace_back();
        if (across == kNone || !(roughness.amplitude > 0.0)) return;
        const bool isTurned = gap == 0.0 && to < from;
        ofEdge = isTurned ? edges.corners({to, from, piece, across}) : edges.corners({from, to, piece, across});
        if (isTurned) std::ranges::reverse(ofEdge);
        for (Vec2& corner : ofEdge) corner -= centre;
    });
    return corners;
}

}  // namespace rubble
