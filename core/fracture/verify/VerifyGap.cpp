#include "core/fracture/verify/VerifyGap.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace rubble {
namespace {

constexpr double kRelativeSlack = 1e-9;  // of the outline's diameter

/// Whether a point is nearer than `distance` to an edge, and its projection at least `inset` from the ends.
bool isBeside(Vec2 point, Vec2 from, Vec2 to, double distance, double inset) {
    const Vec2 edge = to - from;
    const double length = glm::length(edge), along = glm::dot(point - from, edge) / length;
    return along > inset && along < length - inset && std::abs(cross(edge, point - from)) < distance * length;
}

/// Verifies a point of a shrunk piece, in the partition's coordinates.
std::optional<std::string> pointFault(const Partition& partition, std::uint32_t piece, const Polygon& whole, Vec2 point,
                                      double margin, double slack) {
    bool isInGap = false, isOnEdge = false;
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
        const Vec2 a = partition.points[from], b = partition.points[to];
        isInGap |= neighbour != kNone && isBeside(point, a, b, margin - slack, slack);
        isOnEdge |= neighbour == kNone && (isBeside(point, a, b, slack, 0.0) || glm::distance(point, a) <= slack ||
                                           glm::distance(point, b) <= slack);
    });
    if (isInGap) return " extends into the gap.";
    if (!isOnEdge && containment(whole, point) != Containment::Inside) return " extends beyond its piece.";
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyGap(const Fragments& fragments, double gap) {
    const ExtrudedPieces& pieces = *fragments.extruded();
    const Partition& partition = pieces.partition;
    const Partition& shapes = pieces.shapes();
    if ((gap > 0.0) != (&shapes != &partition)) return "The pieces are not shrunk as the gap requires.";
    if (!(gap > 0.0)) return std::nullopt;
    Box2 box;
    for (const std::uint32_t corner : partition.corners) box.include(partition.points[corner]);
    const double slack = kRelativeSlack * box.diagonal();
    for (std::uint32_t fragment = 0; fragment < fragments.count(); ++fragment) {
        const std::uint32_t piece = pieces.pieceOfFragment[fragment];
        const Polygon whole = pieceOutline(partition, piece);
        const std::string name = "Fragment " + std::to_string(fragment);
        for (std::uint32_t ring = shapes.ringsOfPiece[piece]; ring < shapes.ringsOfPiece[piece + 1]; ++ring) {
            Vec2 before = shapes.points[shapes.ringCorners(ring).back()];
            for (const std::uint32_t corner : shapes.ringCorners(ring)) {
                const Vec2 point = shapes.points[corner];
                for (const Vec2 position : {point, (before + point) / 2.0}) {
                    if (const auto fault = pointFault(partition, piece, whole, position, gap / 2.0, slack))
                        return name + *fault;
                }
                before = point;
            }
        }
    }
    return std::nullopt;
}

}  // namespace rubble
