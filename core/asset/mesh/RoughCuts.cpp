#include "core/asset/mesh/RoughCuts.h"

#include "core/asset/mesh/FractalNoise.h"
#include "core/asset/mesh/FragmentMesh.h"
#include "core/geometry/predicates/SegmentDistance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

constexpr double kClearanceFraction = 0.45;    // below 1/2, so that rough edges of a piece never meet
constexpr double kStepsPerBump = 4.0;          // of the finest octave
constexpr std::size_t kMaxIntervalSteps = 64;  // per interval; finer bumps are left out

// Relative to the asset's diameter. Points within the tolerance coincide, since the frames of levels round differently;
// shorter intervals stay straight, so that steps are longer than the tolerance.
constexpr double kTolerance = 1e-9, kMinInterval = 1e-6;

/// The interval at a position along the edge; null if there is none.
const EdgeInterval* intervalAt(const std::vector<EdgeInterval>& intervals, double along) {
    const auto contains = [&](const EdgeInterval& interval) { return interval.from <= along && along <= interval.to; };
    const auto found = std::ranges::find_if(intervals, contains);
    return found != intervals.end() ? &*found : nullptr;
}

/// The distance from a point to those edges of a piece for which `counts(number, neighbour)`.
template <class Counts>
double clearance(const Partition& partition, std::uint32_t piece, Vec2 point, Counts counts) {
    double least = 1e308;
    std::uint32_t number = 0;
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
        if (counts(number++, neighbour)) {
            least = std::min(least, distanceToSegment(point, partition.points[from], partition.points[to]));
        }
    });
    return least;
}

}  // namespace

/// An edge between two pieces, with an orientation that is the same seen from both.
struct RoughCuts::Cut {
    PieceEdge edge;
    double length, gap;                      // m
    std::vector<EdgeInterval> here, behind;  // along the edge; none behind a gap

    /// The positions where the noise vanishes, m along the edge, both ends included.
    std::vector<double> stops(double tolerance) const {
        std::vector<double> stops{0.0, length};
        for (const std::vector<EdgeInterval>* side : {&here, &behind}) {
            for (const EdgeInterval& interval : *side) stops.insert(stops.end(), {interval.from, interval.to});
        }
        std::ranges::sort(stops);
        const auto coincide = [&](double before, double stop) { return stop - before <= tolerance; };
        stops.erase(std::unique(stops.begin(), stops.end(), coincide), stops.end());
        stops.back() = length;
        return stops;
    }
};

RoughCuts::RoughCuts(const Bake& bake, const Asset& asset) : m_roughness(asset.shaping.roughness) {
    if (!(m_roughness.amplitude > 0.0) || !asset.isPrism()) return;
    m_diameter = boundsOf(asset.prism().outline.outer).diagonal();
    for (const BakedFracture& fracture : bake.fractures) m_gaps.push_back(fracture.fragments.gap);
    m_edges = std::make_unique<const EdgeHierarchy>(bake, kTolerance * m_diameter);
}

EdgeCorners RoughCuts::cornersOf(std::uint32_t fragment) const {
    EdgeCorners corners;
    if (!m_edges) return corners;
    for (const PieceEdge& edge : m_edges->edgesOf(fragment)) {
        const Vec2 centre = m_edges->fragmentsOf(edge.fracture).extruded()->records[edge.piece].moments.centre;
        std::vector<Vec2>& ofEdge = corners.emplace_back();
        for (const Corner& corner : cornersOn(edge, 0.0, m_edges->lengthOf(edge))) {
            ofEdge.push_back(corner.position - centre);
        }
    }
    return corners;
}

/// The points between two positions of an edge, m along it.
std::vector<RoughCuts::Corner> RoughCuts::cornersOn(const PieceEdge& edge, double from, double to) const {
    if (edge.neighbour == kNone) return cornersOnParent(edge, from, to);
    const Cut cut = cutAt(edge);
    if (cut.edge.from == edge.from) return cornersOfCut(cut, from, to);
    std::vector<Corner> corners = cornersOfCut(cut, cut.length - to, cut.length - from);
    std::ranges::reverse(corners);
    for (Corner& corner : corners) corner.along = cut.length - corner.along;
    return corners;
}

/// The points of an edge on the surface of the parent: those of the parent's edges.
std::vector<RoughCuts::Corner> RoughCuts::cornersOnParent(const PieceEdge& edge, double from, double to) const {
    std::vector<Corner> corners;
    bool wasRough = false;
    for (const EdgeOverlap& overlap : m_edges->overlapsOf(edge)) {
        const double begin = std::max(overlap.from, overlap.start + from);
        const double end = std::min(overlap.to, overlap.start + to);
        if (!(begin < end)) continue;
        const Vec2 shift = m_edges->originOf(overlap.parent.fracture) - m_edges->originOf(edge.fracture);
        const auto add = [&](double along, Vec2 position) {
            corners.push_back({along - overlap.start, position + shift});
        };
        const std::vector<Corner> onParent = cornersOn(overlap.parent, begin, end);
        const bool isRough = !onParent.empty();
        const bool isCorner =
            begin == 0.0 && overlap.start < -kTolerance * m_diameter;  // of the parent, within the edge
        if (isCorner && (isRough || wasRough))
            add(0.0, m_edges->shapesOf(overlap.parent.fracture).points[overlap.parent.from]);
        for (const Corner& corner : onParent) add(corner.along, corner.position);
        wasRough = isRough;
    }
    return corners;
}

/// The cut of an edge: without a gap, the edge on its other side has the same.
RoughCuts::Cut RoughCuts::cutAt(const PieceEdge& edge) const {
    Cut cut{edge, m_edges->lengthOf(edge), m_gaps[edge.fracture], m_edges->intervalsOf(edge), {}};
    if (cut.gap > 0.0) return cut;
    for (const PieceEdge& facing : m_edges->edgesOf({edge.fracture, edge.neighbour})) {
        if (facing.from != edge.to || facing.to != edge.from) continue;
        cut.behind = m_edges->intervalsOf(facing);
        if (facing.from < facing.to) {
            cut.edge = facing;
            std::swap(cut.here, cut.behind);
        }
        for (EdgeInterval& interval : cut.behind) {
            interval.from = cut.length - std::exchange(interval.to, cut.length - interval.from);
        }
    }
    return cut;
}

/// The points between two positions of a cut: noise in each interval, and the stops between intervals if either is
/// rough.
std::vector<RoughCuts::Corner> RoughCuts::cornersOfCut(const Cut& cut, double from, double to) const {
    const double tolerance = kTolerance * m_diameter;
    const std::vector<double> stops = cut.stops(tolerance);
    std::vector<Corner> corners;
    const auto add = [&](const Corner& corner) {
        if (corner.along > from + tolerance && corner.along < to - tolerance) corners.push_back(corner);
    };
    bool wasRough = false;
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
        const double begin = stops[k], end = stops[k + 1];
        if (end <= from + tolerance || begin >= to - tolerance) continue;
        const std::vector<Corner> between = cornersBetween(cut, begin, end);
        const bool isRough = !between.empty();
        if (isRough || wasRough) add({begin, pointOn(cut, begin)});
        for (const Corner& corner : between) add(corner);
        wasRough = isRough;
    }
    return corners;
}

/// The points between two consecutive stops of a cut; none if a side has no piece there.
std::vector<RoughCuts::Corner> RoughCuts::cornersBetween(const Cut& cut, double from, double to) const {
    std::vector<Corner> corners;
    const double length = to - from, middle = from + length / 2.0;
    const EdgeInterval* here = intervalAt(cut.here, middle);
    const EdgeInterval* behind = intervalAt(cut.behind, middle);
    if (!here || (!behind && !(cut.gap > 0.0)) || length < kMinInterval * m_diameter) return corners;
    const double finest = m_roughness.frequency * static_cast<double>(1u << (m_roughness.octaves - 1));
    const double wanted = std::min(std::floor(length * finest * kStepsPerBump), static_cast<double>(kMaxIntervalSteps));
    if (!(wanted >= 2.0)) return corners;
    const auto steps = static_cast<std::size_t>(wanted);
    const Vec2 first = pointOn(cut, from), last = pointOn(cut, to);
    const Vec2 left = perpendicular((last - first) / length);
    const double step = length / wanted;
    for (std::size_t k = 1; k < steps; ++k) {
        const double fraction = static_cast<double>(k) / wanted;
        const Vec2 point = first + fraction * (last - first);
        double clearance = std::min(glm::distance(point, first), glm::distance(point, last));
        clearance = std::min(clearance, clearanceIn(*here, cut, point));
        if (behind) clearance = std::min(clearance, clearanceIn(*behind, cut, point));
        corners.push_back({from + fraction * length, point + displacementAt(point, cut, clearance, step) * left});
    }
    return corners;
}

double RoughCuts::displacementAt(Vec2 position, const Cut& cut, double clearance, double step) const {
    const Vec2 inAsset = m_edges->originOf(cut.edge.fracture) + position;
    const double noise = fractalNoise(m_roughness.frequency * inAsset, m_roughness.octaves, m_roughness.randomSeed);
    const bool isIntoGap = cut.gap > 0.0 && noise < 0.0;
    if (isIntoGap) clearance = std::min(clearance, clearanceToSurface(cut, position));
    double most = std::min(m_roughness.amplitude, kClearanceFraction * std::max(clearance - step, 0.0));
    if (isIntoGap) most = std::min(most, kClearanceFraction * cut.gap);
    return noise * most;
}

Vec2 RoughCuts::pointOn(const Cut& cut, double along) const {
    const UninitializedVector<Vec2>& points = m_edges->shapesOf(cut.edge.fracture).points;
    const Vec2 from = points[cut.edge.from], to = points[cut.edge.to];
    if (along == 0.0 || along == cut.length) return along == 0.0 ? from : to;
    return from + along / cut.length * (to - from);
}

/// The distance from a point of a cut to the other edges of the piece at an interval.
double RoughCuts::clearanceIn(const EdgeInterval& interval, const Cut& cut, Vec2 position) const {
    position += m_edges->originOf(cut.edge.fracture) - m_edges->originOf(interval.fracture);
    return clearance(m_edges->shapesOf(interval.fracture), interval.piece, position,
                     [&](std::uint32_t number, std::uint32_t) { return number != interval.number; });
}

/// The distance from a point beside a gap to the part of the parent's surface that the piece had before the gap was
/// cut.
double RoughCuts::clearanceToSurface(const Cut& cut, Vec2 position) const {
    return clearance(m_edges->fragmentsOf(cut.edge.fracture).extruded()->partition, cut.edge.piece, position,
                     [](std::uint32_t, std::uint32_t neighbour) { return neighbour == kNone; });
}

}  // namespace rubble
