#include "core/fracture/PieceShrinking.h"

#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/fracture/LeftTurns.h"
#include "core/geometry/PolygonDifference.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kFarthestAlong = 4.0;  // margins: how far along the outline a cut edge beside it counts
constexpr double kBehind = 1.0 / 64.0;  // margins
constexpr double kOnEdge = 0x1p-40;     // of the piece's reach: a point that near to an edge lies on it

Ring placesOf(const ShrunkRing& ring) {
    Ring places;
    for (const ShrunkCorner& corner : ring) places.push_back(corner.place);
    return places;
}

std::vector<ShrunkRing> ringsOf(const Partition& partition, std::uint32_t piece) {
    std::vector<ShrunkRing> rings;
    for (std::uint32_t ring = partition.ringsOfPiece[piece]; ring < partition.ringsOfPiece[piece + 1]; ++ring) {
        ShrunkRing& corners = rings.emplace_back();
        for (std::uint32_t corner = partition.cornersOfRing[ring]; corner < partition.cornersOfRing[ring + 1];
             ++corner) {
            corners.push_back({partition.points[partition.corners[corner]], partition.across[corner]});
        }
    }
    return rings;
}

/// The two edges at a corner, as unit vectors, and how they turn.
struct Turn {
    Vec2 in, out;
    double sine;  // > 0: to the left, the piece is convex there
    double cosine;
};

Turn turnAt(const ShrunkRing& ring, std::size_t corner) {
    const std::size_t size = ring.size();
    const Vec2 here = ring[corner].place;
    Turn turn{glm::normalize(here - ring[(corner + size - 1) % size].place),
              glm::normalize(ring[(corner + 1) % size].place - here), 0.0, 0.0};
    turn.sine = cross(turn.in, turn.out);
    turn.cosine = glm::dot(turn.in, turn.out);
    return turn;
}

/// Whether a strip along the outline beside a cut edge ends before their lines meet: they are nearly one line.
bool isNearlyStraight(const Turn& turn) { return turn.cosine > 0.0 && turn.sine * kFarthestAlong < 1.0; }

/// A convex piece of which each cut edge takes a strip as wide as its line does.
bool isPlain(const std::vector<ShrunkRing>& rings) {
    if (rings.size() != 1 || !turnsLeft(placesOf(rings[0]))) return false;
    const ShrunkRing& ring = rings[0];
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const bool isCutBefore = ring[(k + ring.size() - 1) % ring.size()].across != kNone;
        if (isCutBefore != (ring[k].across != kNone) && isNearlyStraight(turnAt(ring, k))) return false;
    }
    return true;
}

double distanceToEdge(Vec2 point, Vec2 from, Vec2 to) {
    const Vec2 edge = to - from;
    const double along = std::clamp(glm::dot(point - from, edge) / glm::dot(edge, edge), 0.0, 1.0);
    return glm::distance(point, from + along * edge);
}

/// Whether a corner goes away: it is one with that before, or the ring turns back there along the way that it came, up to `width`,
/// as rounding leaves it beside strips. `before` takes over what the edge that stays is.
bool isNeedle(ShrunkCorner& before, const ShrunkCorner& corner, const ShrunkCorner& after, double width) {
    const bool isDouble = glm::distance(before.place, corner.place) <= width;
    const bool turnsBack = glm::dot(before.place - corner.place, after.place - corner.place) > 0.0;
    const bool isShorterAfter = turnsBack && distanceToEdge(after.place, corner.place, before.place) <= width;
    const bool isShorterBefore = turnsBack && distanceToEdge(before.place, corner.place, after.place) <= width;
    if (isDouble || (isShorterBefore && !isShorterAfter)) before.across = corner.across;
    return isDouble || isShorterAfter || isShorterBefore;
}

ShrunkRing withoutNeedles(ShrunkRing ring, double width) {
    for (std::size_t k = 0, seen = 0; ring.size() >= 3 && seen < ring.size();) {
        const std::size_t size = ring.size();
        k %= size;
        if (isNeedle(ring[(k + size - 1) % size], ring[k], ring[(k + 1) % size], width)) {
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
            k += size - 2;  // the one before may be one now
            seen = 0;
        } else {
            ++k;
            ++seen;
        }
    }
    return ring.size() < 3 ? ShrunkRing{} : ring;
}

/// How near to each other points of a piece are one.
double onePointOf(const ShrunkRing& outer) {
    const Box2 box = boundsOf(placesOf(outer));
    return kOnEdge * std::max(glm::length(box.min), glm::length(box.max));
}

/// The part of a convex ring that is at least `margin` to the left of an edge's line; the new edge is that edge.
ShrunkRing clipped(const ShrunkRing& ring, Vec2 from, Vec2 to, std::uint32_t across, double margin) {
    const Vec2 inward = perpendicular(glm::normalize(to - from));
    const auto room = [&](Vec2 point) { return glm::dot(inward, point - from) - margin; };
    ShrunkRing left;
    const auto add = [&](Vec2 place, std::uint32_t behind) {
        if (!left.empty() && left.back().place == place) left.pop_back();
        left.push_back({place, behind});
    };
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 a = ring[k].place, b = ring[k + 1 < ring.size() ? k + 1 : 0].place;
        const double roomA = room(a), roomB = room(b);
        if (roomA >= 0.0) add(a, roomA == 0.0 && roomB < 0.0 ? across : ring[k].across);
        if (roomA > 0.0 && roomB < 0.0) add(a + roomA / (roomA - roomB) * (b - a), across);
        if (roomA < 0.0 && roomB > 0.0) add(b + roomB / (roomB - roomA) * (a - b), ring[k].across);
    }
    while (left.size() > 1 && left.front().place == left.back().place) left.pop_back();
    return left.size() < 3 ? ShrunkRing{} : left;
}

ShrunkPiece shrunkPlain(const ShrunkRing& ring, double margin) {
    ShrunkRing left = ring;
    for (std::size_t k = 0; k < ring.size() && !left.empty(); ++k) {
        if (ring[k].across == kNone) continue;
        left = clipped(left, ring[k].place, ring[k + 1 < ring.size() ? k + 1 : 0].place, ring[k].across, margin);
    }
    left = withoutNeedles(std::move(left), onePointOf(ring));
    if (left.empty()) return {};
    return {{std::move(left)}, false};
}

/// The end of a strip: from outside the piece, where it begins a little behind its edge so that no two lines fall together, past
/// the edge's end as far as the next edge wants it, to the margin.
void addEnd(Vec2 end, Vec2 along, Vec2 next, double sine, double cosine, bool isNextCut, double margin, Ring& strip) {
    const Vec2 inward = perpendicular(along) * margin;
    strip.push_back(end - kBehind * inward);
    if (sine <= 0.0 && isNextCut) {
        const double halfTangent = cosine > -1.0 ? -sine / (1.0 + cosine) : 1.0;  // of half the turn
        const Vec2 beyond = std::min(halfTangent, 1.0) * margin * along;
        strip.insert(strip.end(), {end + beyond, end + beyond + inward});
    } else if (sine <= 0.0 || isNextCut || cosine <= 0.0) {
        strip.push_back(end + inward);
    } else if (sine * kFarthestAlong < 1.0) {
        const Vec2 far = kFarthestAlong * margin * next;
        const Vec2 outward = -kBehind * margin * perpendicular(next);
        strip.insert(strip.end(), {end + far + outward, end + glm::dot(far, along) * along + inward});
    } else {
        strip.push_back(end + margin / sine * next + kBehind * margin * along);
    }
}

/// The strip along the edge that a corner begins, with what lies past its ends.
Ring stripAt(const ShrunkRing& ring, std::size_t corner, double margin) {
    const std::size_t size = ring.size(), next = (corner + 1) % size;
    const Turn before = turnAt(ring, corner), behind = turnAt(ring, next);
    Ring end, start;
    addEnd(ring[next].place, behind.in, behind.out, behind.sine, behind.cosine, ring[next].across != kNone, margin,
           end);
    // The other end is this one in a mirror.
    const auto mirrored = [](Vec2 vector) { return Vec2(-vector.x, vector.y); };
    addEnd(mirrored(ring[corner].place), mirrored(-before.out), mirrored(-before.in), before.sine, before.cosine,
           ring[(corner + size - 1) % size].across != kNone, margin, start);
    for (std::size_t k = start.size(); k-- > 0;) end.push_back(mirrored(start[k]));
    return end;
}

/// What is taken around a corner of the outline where a cut edge meets it and the piece does not end: as much on all sides.
Ring squareAround(Vec2 corner, Vec2 along, double margin) {
    const Vec2 ahead = margin * along, left = perpendicular(ahead);
    return {corner - ahead - left, corner + ahead - left, corner + ahead + left, corner - ahead + left};
}

/// What was behind the edge of a piece that an edge of what is left runs along, or is the margin of.
std::uint32_t acrossOf(const std::vector<ShrunkRing>& rings, Vec2 from, Vec2 to, double onEdge) {
    std::uint32_t nearest = kNone;
    double least = 0.0;
    for (const ShrunkRing& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2 a = ring[k].place, b = ring[k + 1 < ring.size() ? k + 1 : 0].place;
            if (ring[k].across == kNone) {
                if (distanceToEdge(from, a, b) <= onEdge && distanceToEdge(to, a, b) <= onEdge) return kNone;
                continue;
            }
            const double distance = distanceToEdge((from + to) / 2.0, a, b);
            if (nearest != kNone && distance >= least) continue;
            nearest = ring[k].across;
            least = distance;
        }
    }
    return nearest;
}

ShrunkPiece shrunkConcave(const std::vector<ShrunkRing>& rings, double margin) {
    Polygon polygon{placesOf(rings[0]), {}};
    std::vector<Ring> strips;
    for (const ShrunkRing& ring : rings) {
        if (&ring != rings.data()) polygon.holes.push_back(placesOf(ring));
        for (std::size_t k = 0; k < ring.size(); ++k) {
            if (ring[k].across != kNone) strips.push_back(stripAt(ring, k, margin));
            const Turn turn = turnAt(ring, k);
            const bool isCutBefore = ring[(k + ring.size() - 1) % ring.size()].across != kNone;
            if (isCutBefore == (ring[k].across != kNone) || turn.sine > 0.0) continue;
            strips.push_back(squareAround(ring[k].place, isCutBefore ? turn.in : turn.out, margin));
        }
    }
    const std::vector<Polygon> parts = difference(polygon, strips);
    const double onEdge = onePointOf(rings[0]);
    const auto isWide = [&](const Polygon& part) { return area(part) > onEdge * perimeter(part); };
    if (parts.empty() || !isWide(parts[0])) return {};
    ShrunkPiece shrunk{{}, parts.size() > 1 && isWide(parts[1])};
    const auto take = [&](const Ring& ring) {
        ShrunkRing taken;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            taken.push_back({ring[k], acrossOf(rings, ring[k], ring[k + 1 < ring.size() ? k + 1 : 0], onEdge)});
        }
        taken = withoutNeedles(std::move(taken), onEdge);
        if (!taken.empty()) shrunk.rings.push_back(std::move(taken));
    };
    take(parts[0].outer);
    for (const Ring& hole : parts[0].holes) take(hole);
    return shrunk;
}

std::string cellOf(const Partition& partition, std::uint32_t piece) {
    return "the cell of seed " + std::to_string(partition.seedOfPiece[piece]);
}

Report cutApartReport(const Partition& partition, std::uint32_t piece, const ShrunkPiece& left) {
    double lost = pieceArea(partition, piece);
    for (const ShrunkRing& ring : left.rings) lost -= signedArea(placesOf(ring));
    return {ReportCode::VanishedPiece, partition.seedOfPiece[piece], kNone, lost,
            "The gap between pieces cuts a piece of " + cellOf(partition, piece) +
                " apart; its largest part stays, and " + messageText(lost) + " m^2 are left out."};
}

void append(const ShrunkPiece& piece, Partition& shapes) {
    for (const ShrunkRing& ring : piece.rings) {
        for (const ShrunkCorner& corner : ring) {
            shapes.corners.push_back(static_cast<std::uint32_t>(shapes.points.size()));
            shapes.points.push_back(corner.place);
            shapes.across.push_back(corner.across);
        }
        shapes.cornersOfRing.push_back(static_cast<std::uint32_t>(shapes.corners.size()));
    }
    shapes.ringsOfPiece.push_back(static_cast<std::uint32_t>(shapes.cornersOfRing.size() - 1));
}

}  // namespace

ShrunkPiece shrunkPiece(const Partition& partition, std::uint32_t piece, double margin) {
    const std::vector<ShrunkRing> rings = ringsOf(partition, piece);
    return isPlain(rings) ? shrunkPlain(rings[0], margin) : shrunkConcave(rings, margin);
}

Report vanishedReport(const Partition& partition, std::uint32_t piece, double lost) {
    return {ReportCode::VanishedPiece, partition.seedOfPiece[piece], kNone, lost,
            "A piece of " + cellOf(partition, piece) +
                " is narrower than the gap between pieces; it is left out, with " + messageText(lost) + " m^2."};
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
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
        append(pieces[piece], shapes);
        const ShrunkPiece& left = pieces[piece];
        if (left.rings.empty()) shapes.reports.push_back(vanishedReport(partition, piece, pieceArea(partition, piece)));
        if (left.isCutApart) shapes.reports.push_back(cutApartReport(partition, piece, left));
    }
    std::ranges::stable_sort(shapes.reports, {}, &Report::seed);
    return shapes;
}

}  // namespace rubble
