#include "core/asset/RoughCuts.h"

#include "core/asset/Breaking.h"
#include "core/asset/FractalNoise.h"
#include "core/fracture/CutSet.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

constexpr double kShareOfRoom = 0.45;   // below a half: rough edges come to less than half way to each other
constexpr double kStepsPerBump = 4.0;   // of the finest octave
constexpr std::size_t kMostSteps = 64;  // of a stretch; bumps that are finer are left out

// Parts of the asset's diameter: what is nearer is in one place, as frames of levels round apart; what is shorter stays straight, so
// that no step is as short as that.
constexpr double kReach = 1e-9, kLeastStretch = 1e-6;

double distanceToEdge(Vec2 point, Vec2 from, Vec2 to) {
    const Vec2 edge = to - from;
    const double squared = glm::dot(edge, edge);
    const double along = squared > 0.0 ? std::clamp(glm::dot(point - from, edge) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, from + along * edge);
}

/// How wide the gaps between the pieces of one breaking are, m.
double gapOf(const Bake& bake, const Asset& asset, const BakedBreaking& breaking) {
    if (breaking.parent == kNone) return gapOf(recipeOf(asset));
    const Level* level = levelFor(asset, pathOfId(bake.fragmentId(breaking.parent)), breaking.level - 1);
    return std::max(asset.shaping.gap, level ? jointWidthOf(level->pattern) : 0.0);
}

/// The stretch on which a place lies; null where nobody is there.
const EdgeStretch* stretchAt(const std::vector<EdgeStretch>& stretches, double along) {
    const auto isThere = [&](const EdgeStretch& stretch) { return stretch.from <= along && along <= stretch.to; };
    const auto found = std::ranges::find_if(stretches, isThere);
    return found != stretches.end() ? &*found : nullptr;
}

/// How far a place is from the edges of a piece for which `counts(number, across)`.
template <class Counts>
double roomIn(const Partition& partition, std::uint32_t piece, Vec2 place, Counts counts) {
    double room = 1e308;
    std::uint32_t number = 0;
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
        if (counts(number++, across)) {
            room = std::min(room, distanceToEdge(place, partition.points[from], partition.points[to]));
        }
    });
    return room;
}

}  // namespace

/// An edge with a piece behind it, in the order that both sides agree on.
struct RoughCuts::Cut {
    PieceEdge edge;
    double length, gap;                     // m
    std::vector<EdgeStretch> here, behind;  // along the edge; nobody behind a gap

    /// Where noise vanishes, from one end to the other, m along the edge.
    std::vector<double> stops(double reach) const {
        std::vector<double> stops{0.0, length};
        for (const std::vector<EdgeStretch>* side : {&here, &behind}) {
            for (const EdgeStretch& stretch : *side) stops.insert(stops.end(), {stretch.from, stretch.to});
        }
        std::ranges::sort(stops);
        const auto isThere = [&](double before, double stop) { return stop - before <= reach; };
        stops.erase(std::unique(stops.begin(), stops.end(), isThere), stops.end());
        stops.back() = length;
        return stops;
    }
};

RoughCuts::RoughCuts(const Bake& bake, const Asset& asset) : m_roughness(asset.shaping.roughness) {
    if (!(m_roughness.amplitude > 0.0)) return;
    m_diameter = boundsOf(asset.prism.outline.outer).diagonal();
    for (const BakedBreaking& breaking : bake.breakings) m_gaps.push_back(gapOf(bake, asset, breaking));
    m_edges = std::make_unique<const EdgeStretches>(bake, kReach * m_diameter);
}

EdgeCorners RoughCuts::cornersOf(std::uint32_t fragment) const {
    EdgeCorners corners;
    if (!m_edges) return corners;
    for (const PieceEdge& edge : m_edges->edgesOf(fragment)) {
        const Vec2 centre = m_edges->fragmentsOf(edge.breaking).records[edge.piece].moments.centre;
        std::vector<Vec2>& ofEdge = corners.emplace_back();
        for (const Corner& corner : cornersOn(edge, 0.0, m_edges->lengthOf(edge))) {
            ofEdge.push_back(corner.place - centre);
        }
    }
    return corners;
}

/// Those between two places of an edge, m along it.
std::vector<RoughCuts::Corner> RoughCuts::cornersOn(const PieceEdge& edge, double from, double to) const {
    if (edge.across == kNone) return cornersOnParent(edge, from, to);
    const Cut cut = cutAt(edge);
    if (cut.edge.from == edge.from) return cornersOfCut(cut, from, to);
    std::vector<Corner> corners = cornersOfCut(cut, cut.length - to, cut.length - from);
    std::ranges::reverse(corners);
    for (Corner& corner : corners) corner.along = cut.length - corner.along;
    return corners;
}

/// Those of an edge that lies on the surface of what was broken: that one's, as far as they reach.
std::vector<RoughCuts::Corner> RoughCuts::cornersOnParent(const PieceEdge& edge, double from, double to) const {
    std::vector<Corner> corners;
    bool wasRough = false;
    for (const EdgeOverlap& overlap : m_edges->overlapsOf(edge)) {
        const double begin = std::max(overlap.from, overlap.start + from);
        const double end = std::min(overlap.to, overlap.start + to);
        if (!(begin < end)) continue;
        const Vec2 shift = m_edges->originOf(overlap.parent.breaking) - m_edges->originOf(edge.breaking);
        const auto add = [&](double along, Vec2 place) { corners.push_back({along - overlap.start, place + shift}); };
        const std::vector<Corner> onParent = cornersOn(overlap.parent, begin, end);
        const bool isRough = !onParent.empty();
        const bool isCorner = begin == 0.0 && overlap.start < -kReach * m_diameter;  // of the parent, within the edge
        if (isCorner && (isRough || wasRough))
            add(0.0, m_edges->shapesOf(overlap.parent.breaking).points[overlap.parent.from]);
        for (const Corner& corner : onParent) add(corner.along, corner.place);
        wasRough = isRough;
    }
    return corners;
}

/// The edge, or the one behind it: they have the same cut, unless there is a gap between them.
RoughCuts::Cut RoughCuts::cutAt(const PieceEdge& edge) const {
    Cut cut{edge, m_edges->lengthOf(edge), m_gaps[edge.breaking], m_edges->stretchesOf(edge), {}};
    if (cut.gap > 0.0) return cut;
    for (const PieceEdge& facing : m_edges->edgesOf(edge.breaking, edge.across)) {
        if (facing.from != edge.to || facing.to != edge.from) continue;
        cut.behind = m_edges->stretchesOf(facing);
        if (facing.from < facing.to) {
            cut.edge = facing;
            std::swap(cut.here, cut.behind);
        }
        for (EdgeStretch& stretch : cut.behind) {
            stretch.from = cut.length - std::exchange(stretch.to, cut.length - stretch.from);
        }
    }
    return cut;
}

/// Those between two places of a cut: noise stretch by stretch, and the stops between stretches where either is rough.
std::vector<RoughCuts::Corner> RoughCuts::cornersOfCut(const Cut& cut, double from, double to) const {
    const double reach = kReach * m_diameter;
    const std::vector<double> stops = cut.stops(reach);
    std::vector<Corner> corners;
    const auto add = [&](const Corner& corner) {
        if (corner.along > from + reach && corner.along < to - reach) corners.push_back(corner);
    };
    bool wasRough = false;
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
        const double begin = stops[k], end = stops[k + 1];
        if (end <= from + reach || begin >= to - reach) continue;
        const std::vector<Corner> between = cornersBetween(cut, begin, end);
        const bool isRough = !between.empty();
        if (isRough || wasRough) add({begin, placeOn(cut, begin)});
        for (const Corner& corner : between) add(corner);
        wasRough = isRough;
    }
    return corners;
}

/// Those between two neighbouring stops of a cut; none where nobody lies on one of its sides.
std::vector<RoughCuts::Corner> RoughCuts::cornersBetween(const Cut& cut, double from, double to) const {
    std::vector<Corner> corners;
    const double length = to - from, middle = from + length / 2.0;
    const EdgeStretch* here = stretchAt(cut.here, middle);
    const EdgeStretch* behind = stretchAt(cut.behind, middle);
    if (!here || (!behind && !(cut.gap > 0.0)) || length < kLeastStretch * m_diameter) return corners;
    const double finest = m_roughness.frequency * static_cast<double>(1u << (m_roughness.octaves - 1));
    const double wanted = std::min(std::floor(length * finest * kStepsPerBump), static_cast<double>(kMostSteps));
    if (!(wanted >= 2.0)) return corners;
    const auto steps = static_cast<std::size_t>(wanted);
    const Vec2 first = placeOn(cut, from), last = placeOn(cut, to);
    const Vec2 left = perpendicular((last - first) / length);
    const double step = length / wanted;
    for (std::size_t k = 1; k < steps; ++k) {
        const double share = static_cast<double>(k) / wanted;
        const Vec2 place = first + share * (last - first);
        double room = std::min(glm::distance(place, first), glm::distance(place, last));
        room = std::min(room, roomBeside(*here, cut, place));
        if (behind) room = std::min(room, roomBeside(*behind, cut, place));
        corners.push_back({from + share * length, place + displacementAt(place, cut, room, step) * left});
    }
    return corners;
}

double RoughCuts::displacementAt(Vec2 place, const Cut& cut, double room, double step) const {
    const Vec2 inAsset = m_edges->originOf(cut.edge.breaking) + place;
    const double noise = fractalNoise(m_roughness.frequency * inAsset, m_roughness.octaves, m_roughness.randomSeed);
    const bool isIntoGap = cut.gap > 0.0 && noise < 0.0;
    if (isIntoGap) room = std::min(room, roomToSurface(cut, place));
    double most = std::min(m_roughness.amplitude, kShareOfRoom * std::max(room - step, 0.0));
    if (isIntoGap) most = std::min(most, kShareOfRoom * cut.gap);
    return noise * most;
}

Vec2 RoughCuts::placeOn(const Cut& cut, double along) const {
    const RawVector<Vec2>& points = m_edges->shapesOf(cut.edge.breaking).points;
    const Vec2 from = points[cut.edge.from], to = points[cut.edge.to];
    if (along == 0.0 || along == cut.length) return along == 0.0 ? from : to;
    return from + along / cut.length * (to - from);
}

/// How far a place of a cut is from the other edges of the piece that lies there.
double RoughCuts::roomBeside(const EdgeStretch& stretch, const Cut& cut, Vec2 place) const {
    place += m_edges->originOf(cut.edge.breaking) - m_edges->originOf(stretch.breaking);
    return roomIn(m_edges->shapesOf(stretch.breaking), stretch.piece, place,
                  [&](std::uint32_t number, std::uint32_t) { return number != stretch.number; });
}

/// How far a place beside a gap is from the surface of what was broken, as far as the piece lay at it before the gap was taken.
double RoughCuts::roomToSurface(const Cut& cut, Vec2 place) const {
    return roomIn(m_edges->fragmentsOf(cut.edge.breaking).partition, cut.edge.piece, place,
                  [](std::uint32_t, std::uint32_t across) { return across == kNone; });
}

}  // namespace rubble
