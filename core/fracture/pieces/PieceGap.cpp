#include "core/fracture/pieces/PieceGap.h"

#include "core/base/Parallel.h"
#include "core/base/QuantityText.h"
#include "core/fracture/partition/CappedDiagnostics.h"
#include "core/fracture/pieces/StrictConvexity.h"
#include "core/geometry/polygon/PolygonBoolean.h"
#include "core/geometry/predicates/SegmentDistance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMaxAlongOutline = 4.0;  // margins: how far a cut edge affects the outline beside it
constexpr double kOverlap = 1.0 / 64.0;   // margins
constexpr double kOnEdge = 0x1p-40;       // of the piece's bounding radius: points this close to an edge lie on it

Ring positionsOf(const ShrunkRing& ring) {
    Ring positions;
    for (const ShrunkCorner& corner : ring) positions.push_back(corner.position);
    return positions;
}

std::vector<ShrunkRing> ringsOf(const Partition& partition, std::uint32_t piece) {
    std::vector<ShrunkRing> rings;
    for (std::uint32_t ring = partition.ringsOfPiece[piece]; ring < partition.ringsOfPiece[piece + 1]; ++ring) {
        ShrunkRing& corners = rings.emplace_back();
        for (std::uint32_t corner = partition.cornersOfRing[ring]; corner < partition.cornersOfRing[ring + 1];
             ++corner) {
            corners.push_back({partition.points[partition.corners[corner]], partition.neighbours[corner]});
        }
    }
    return rings;
}

/// The directions of the two edges at a corner, and the angle between them.
struct Turn {
    Vec2 in, out;
    double sine;  // > 0: a convex corner
    double cosine;
};

Turn turnAt(const ShrunkRing& ring, std::size_t corner) {
    const std::size_t size = ring.size();
    const Vec2 here = ring[corner].position;
    Turn turn{glm::normalize(here - ring[(corner + size - 1) % size].position),
              glm::normalize(ring[(corner + 1) % size].position - here), 0.0, 0.0};
    turn.sine = cross(turn.in, turn.out);
    turn.cosine = glm::dot(turn.in, turn.out);
    return turn;
}

/// Whether the strip along a cut edge ends before it meets the line of the outline edge next to it: they are nearly
/// parallel.
bool isNearlyStraight(const Turn& turn) { return turn.cosine > 0.0 && turn.sine * kMaxAlongOutline < 1.0; }

/// Whether a piece is convex, and each cut edge can be moved inwards as a half-plane.
bool isSimplyConvex(const std::vector<ShrunkRing>& rings) {
    if (rings.size() != 1 || !isStrictlyConvex(positionsOf(rings[0]))) return false;
    const ShrunkRing& ring = rings[0];
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const bool isCutBefore = ring[(k + ring.size() - 1) % ring.size()].neighbour != kNone;
        if (isCutBefore != (ring[k].neighbour != kNone) && isNearlyStraight(turnAt(ring, k))) return false;
    }
    return true;
}

/// Whether a corner is to be removed: it coincides with the one before, or the ring turns back there, within `width`,
/// as rounding leaves it beside strips. Updates the neighbour of `before` to that of the remaining edge.
bool isNeedle(ShrunkCorner& before, const ShrunkCorner& corner, const ShrunkCorner& after, double width) {
    const bool isDouble = glm::distance(before.position, corner.position) <= width;
    const bool turnsBack = glm::dot(before.position - corner.position, after.position - corner.position) > 0.0;
    const bool isShorterAfter =
        turnsBack && distanceToSegment(after.position, corner.position, before.position) <= width;
    const bool isShorterBefore =
        turnsBack && distanceToSegment(before.position, corner.position, after.position) <= width;
    if (isDouble || (isShorterBefore && !isShorterAfter)) before.neighbour = corner.neighbour;
    return isDouble || isShorterAfter || isShorterBefore;
}

ShrunkRing withoutNeedles(ShrunkRing ring, double width) {
    for (std::size_t k = 0, seen = 0; ring.size() >= 3 && seen < ring.size();) {
        const std::size_t size = ring.size();
        k %= size;
        if (isNeedle(ring[(k + size - 1) % size], ring[k], ring[(k + 1) % size], width)) {
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
            k += size - 2;  // the previous corner may be one now
            seen = 0;
        } else {
            ++k;
            ++seen;
        }
    }
    return ring.size() < 3 ? ShrunkRing{} : ring;
}

/// The distance below which points of a piece coincide.
double coincidenceDistance(const ShrunkRing& outer) {
    const Box2 box = boundsOf(positionsOf(outer));
    return kOnEdge * std::max(glm::length(box.min), glm::length(box.max));
}

/// The part of a convex ring at least `margin` to the left of an edge's line. The new edge has the edge's
/// neighbour.
ShrunkRing clipped(const ShrunkRing& ring, Vec2 from, Vec2 to, std::uint32_t neighbour, double margin) {
    const Vec2 inward = perpendicular(glm::normalize(to - from));
    const auto clearance = [&](Vec2 point) { return glm::dot(inward, point - from) - margin; };
    ShrunkRing left;
    const auto add = [&](Vec2 position, std::uint32_t behind) {
        if (!left.empty() && left.back().position == position) left.pop_back();
        left.push_back({position, behind});
    };
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 a = ring[k].position, b = ring[k + 1 < ring.size() ? k + 1 : 0].position;
        const double clearanceA = clearance(a), clearanceB = clearance(b);
        if (clearanceA >= 0.0) add(a, clearanceA == 0.0 && clearanceB < 0.0 ? neighbour : ring[k].neighbour);
        if (clearanceA > 0.0 && clearanceB < 0.0) add(a + clearanceA / (clearanceA - clearanceB) * (b - a), neighbour);
        if (clearanceA < 0.0 && clearanceB > 0.0)
            add(b + clearanceB / (clearanceB - clearanceA) * (a - b), ring[k].neighbour);
    }
    while (left.size() > 1 && left.front().position == left.back().position) left.pop_back();
    return left.size() < 3 ? ShrunkRing{} : left;
}

ShrunkPiece shrunkConvex(const ShrunkRing& ring, double margin) {
    ShrunkRing left = ring;
    for (std::size_t k = 0; k < ring.size() && !left.empty(); ++k) {
        if (ring[k].neighbour == kNone) continue;
        left =
            clipped(left, ring[k].position, ring[k + 1 < ring.size() ? k + 1 : 0].position, ring[k].neighbour, margin);
    }
    left = withoutNeedles(std::move(left), coincidenceDistance(ring));
    if (left.empty()) return {};
    return {{std::move(left)}, false};
}

/// Appends the end of a strip: it starts slightly outside the piece, so that no two lines coincide, extends beyond the
/// edge's end as the next edge requires, and ends at the margin.
void addEnd(Vec2 end, Vec2 along, Vec2 next, double sine, double cosine, bool isNextCut, double margin, Ring& strip) {
    const Vec2 inward = perpendicular(along) * margin;
    strip.push_back(end - kOverlap * inward);
    if (sine <= 0.0 && isNextCut) {
        const double halfTangent = cosine > -1.0 ? -sine / (1.0 + cosine) : 1.0;  // of half the exterior angle
        const Vec2 beyond = std::min(halfTangent, 1.0) * margin * along;
        strip.insert(strip.end(), {end + beyond, end + beyond + inward});
    } else if (sine <= 0.0 || isNextCut || cosine <= 0.0) {
        strip.push_back(end + inward);
    } else if (sine * kMaxAlongOutline < 1.0) {
        const Vec2 far = kMaxAlongOutline * margin * next;
        const Vec2 outward = -kOverlap * margin * perpendicular(next);
        strip.insert(strip.end(), {end + far + outward, end + glm::dot(far, along) * along + inward});
    } else {
        strip.push_back(end + margin / sine * next + kOverlap * margin * along);
    }
}

/// The strip along the edge that starts at a corner, with its extensions.
Ring stripAt(const ShrunkRing& ring, std::size_t corner, double margin) {
    const std::size_t size = ring.size(), next = (corner + 1) % size;
    const Turn before = turnAt(ring, corner), behind = turnAt(ring, next);
    Ring end, start;
    addEnd(ring[next].position, behind.in, behind.out, behind.sine, behind.cosine, ring[next].neighbour != kNone,
           margin, end);
    // The other end, mirrored.
    const auto mirrored = [](Vec2 vector) { return Vec2(-vector.x, vector.y); };
    addEnd(mirrored(ring[corner].position), mirrored(-before.out), mirrored(-before.in), before.sine, before.cosine,
           ring[(corner + size - 1) % size].neighbour != kNone, margin, start);
    for (std::size_t k = start.size(); k-- > 0;) end.push_back(mirrored(start[k]));
    return end;
}

/// The square removed around a reflex corner between a cut edge and the outline.
Ring squareAround(Vec2 corner, Vec2 along, double margin) {
    const Vec2 ahead = margin * along, left = perpendicular(ahead);
    return {corner - ahead - left, corner + ahead - left, corner + ahead + left, corner - ahead + left};
}

/// The neighbour of an edge of the result: that of the piece's edge which it lies on, or is offset from.
std::uint32_t neighbourOf(const std::vector<ShrunkRing>& rings, Vec2 from, Vec2 to, double onEdge) {
    std::uint32_t nearest = kNone;
    double minDistance = 0.0;
    for (const ShrunkRing& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2 a = ring[k].position, b = ring[k + 1 < ring.size() ? k + 1 : 0].position;
            if (ring[k].neighbour == kNone) {
                if (distanceToSegment(from, a, b) <= onEdge && distanceToSegment(to, a, b) <= onEdge) return kNone;
                continue;
            }
            const double distance = distanceToSegment((from + to) / 2.0, a, b);
            if (nearest != kNone && distance >= minDistance) continue;
            nearest = ring[k].neighbour;
            minDistance = distance;
        }
    }
    return nearest;
}

ShrunkPiece shrunkConcave(const std::vector<ShrunkRing>& rings, double margin) {
    Polygon polygon{positionsOf(rings[0]), {}};
    std::vector<Ring> strips;
    for (const ShrunkRing& ring : rings) {
        if (&ring != rings.data()) polygon.holes.push_back(positionsOf(ring));
        for (std::size_t k = 0; k < ring.size(); ++k) {
            if (ring[k].neighbour != kNone) strips.push_back(stripAt(ring, k, margin));
            const Turn turn = turnAt(ring, k);
            const bool isCutBefore = ring[(k + ring.size() - 1) % ring.size()].neighbour != kNone;
            if (isCutBefore == (ring[k].neighbour != kNone) || turn.sine > 0.0) continue;
            strips.push_back(squareAround(ring[k].position, isCutBefore ? turn.in : turn.out, margin));
        }
    }
    const std::vector<Polygon> parts = difference(polygon, strips);
    const double onEdge = coincidenceDistance(rings[0]);
    const auto isWide = [&](const Polygon& part) { return area(part) > onEdge * perimeter(part); };
    if (parts.empty() || !isWide(parts[0])) return {};
    ShrunkPiece shrunk{{}, parts.size() > 1 && isWide(parts[1])};
    const auto addRing = [&](const Ring& ring) {
        ShrunkRing shrunkRing;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            shrunkRing.push_back({ring[k], neighbourOf(rings, ring[k], ring[k + 1 < ring.size() ? k + 1 : 0], onEdge)});
        }
        shrunkRing = withoutNeedles(std::move(shrunkRing), onEdge);
        if (!shrunkRing.empty()) shrunk.rings.push_back(std::move(shrunkRing));
    };
    addRing(parts[0].outer);
    if (shrunk.rings.empty()) return {};  // a hole must not become the outer ring
    for (const Ring& hole : parts[0].holes) addRing(hole);
    return shrunk;
}

Diagnostic disconnectedReport(const Partition& partition, std::uint32_t piece, const ShrunkPiece& left) {
    double lost = pieceArea(partition, piece);
    for (const ShrunkRing& ring : left.rings) lost -= signedArea(positionsOf(ring));
    return diagnostic(DiagnosticCode::VanishedPiece, {.seed = partition.seedOfPiece[piece]},
                      "The gap between fragments cuts a piece of " + cellText(partition, piece) +
                          " apart; its largest part remains, and " + quantityText(QuantityKind::Area, lost) +
                          " are left out.",
                      lost);
}

void append(const ShrunkPiece& piece, Partition& shapes) {
    for (const ShrunkRing& ring : piece.rings) {
        for (const ShrunkCorner& corner : ring) {
            shapes.corners.push_back(static_cast<std::uint32_t>(shapes.points.size()));
            shapes.points.push_back(corner.position);
            shapes.neighbours.push_back(corner.neighbour);
        }
        shapes.cornersOfRing.push_back(static_cast<std::uint32_t>(shapes.corners.size()));
    }
    shapes.ringsOfPiece.push_back(static_cast<std::uint32_t>(shapes.cornersOfRing.size() - 1));
}

}  // namespace

ShrunkPiece shrunkPiece(const Partition& partition, std::uint32_t piece, double margin) {
    const std::vector<ShrunkRing> rings = ringsOf(partition, piece);
    return isSimplyConvex(rings) ? shrunkConvex(rings[0], margin) : shrunkConcave(rings, margin);
}

Diagnostic vanishedReport(const Partition& partition, std::uint32_t piece, double lost) {
    return diagnostic(DiagnosticCode::VanishedPiece, {.seed = partition.seedOfPiece[piece]},
                      "A piece of " + cellText(partition, piece) +
                          " is narrower than the gap between fragments; it is omitted with " +
                          quantityText(QuantityKind::Area, lost) + ".",
                      lost);
}

Result<Partition> shrunkPartition(const Partition& partition, double margin, const TaskContext& task) {
    std::vector<ShrunkPiece> pieces(partition.pieceCount());
    forEachIndex(pieces.size(), task.threads, [&](std::size_t piece) {
        if (!task.isCancelled()) pieces[piece] = shrunkPiece(partition, static_cast<std::uint32_t>(piece), margin);
    });
    if (task.isCancelled()) return TaskContext::cancelled();
    Partition shapes{.origin = partition.origin,
                     .seedOfPiece = partition.seedOfPiece,
                     .ringsOfPiece = {0},
                     .cornersOfRing = {0},
                     .pieceOfSeed = partition.pieceOfSeed,
                     .cutLayers = partition.cutLayers,
                     .cutCells = partition.cutCells,
                     .partOfCell = partition.partOfCell};
    CappedDiagnostics found;
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
        append(pieces[piece], shapes);
        const ShrunkPiece& left = pieces[piece];
        if (left.rings.empty()) {
            found.add(DiagnosticCode::VanishedPiece,
                      [&] { return vanishedReport(partition, piece, pieceArea(partition, piece)); });
        }
        if (left.isDisconnected) found.add(disconnectedReport(partition, piece, left));
    }
    shapes.diagnostics = std::move(found).list();
    std::ranges::stable_sort(shapes.diagnostics, {},
                             [](const Diagnostic& diagnostic) { return diagnostic.place.seed; });
    return shapes;
}

}  // namespace rubble
