#include "core/physics/SeparatingAxis.h"

#include "core/physics/LaneMath.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

constexpr int kLanes = 4;
using Four = Floats<kLanes>;
using FourVec3 = WideVec3<kLanes>;

constexpr float kTouching = 1e-4f;           // m: what counts as lying in a plane, or over a face
constexpr float kDeep = 0.002f;              // m: of boxes that overlap more, no side is likely to part what is in them
constexpr float kParallelSquared = 2.5e-5f;  // of the sine between edges that count as parallel, 0.005

FourVec3 splat(Vec3f v) { return {all<kLanes>(v.x), all<kLanes>(v.y), all<kLanes>(v.z)}; }
FourVec3 four(const VectorRows& rows, int first) {
    return {loaded<kLanes>(&rows.x[first]), loaded<kLanes>(&rows.y[first]), loaded<kLanes>(&rows.z[first])};
}

/// How far the corners of a hull reach along a direction.
float reachAlong(const Hull& hull, Vec3f direction) {
    const FourVec3 wide = splat(direction);
    Four most = dot<kLanes>(four(hull.corners, 0), wide);
    const int padded = static_cast<int>(hull.corners.x.size());
    for (int i = kLanes; i < padded; i += kLanes)
        most = greater<kLanes>(most, dot<kLanes>(four(hull.corners, i), wide));
    const float left = most[0] > most[1] ? most[0] : most[1], right = most[2] > most[3] ? most[2] : most[3];
    return left > right ? left : right;
}

float faceSeparation(const Hull& owner, int face, const Hull& other, const RelativePlace& otherInOwner) {
    const HullPlane& plane = owner.planes[face];
    const Vec3f inOther = otherInOwner.turn.transposedTimes(plane.normal) * -1.0f;
    return dot(plane.normal, otherInOwner.offset) - reachAlong(other, inOther) - plane.offset;
}

/// faceSeparation() is no more than this: the other hull reaches at least to a ball within it.
float mostSeparation(const Hull& owner, int face, const Hull& other, const RelativePlace& otherInOwner) {
    const HullPlane& plane = owner.planes[face];
    return dot(plane.normal, otherInOwner.offset) - other.inner - plane.offset;
}

struct BestFace {
    int face = 0;
    float separation = -1e30f;
};

/// The face along which the hulls are farthest apart; the first beyond the margin, `start` first of all.
BestFace bestFace(const Hull& owner, const Hull& other, const RelativePlace& otherInOwner, float margin, int start) {
    BestFace best{start, faceSeparation(owner, start, other, otherInOwner)};
    const int count = static_cast<int>(owner.planes.size());
    for (int face = 0; face < count && best.separation <= margin; ++face) {
        if (face == start || mostSeparation(owner, face, other, otherInOwner) <= best.separation) continue;
        const float separation = faceSeparation(owner, face, other, otherInOwner);
        if (separation > best.separation) best = {face, separation};
    }
    return best;
}

/// Whether a point over a face lies over the face itself and not beside it, by less than `tolerance`.
bool isOver(const Hull& owner, int face, Vec3f point, float tolerance) {
    for (const HullPlane& side : owner.sidesOf(face)) {
        if (dot(side.normal, point) - side.offset > tolerance) return false;
    }
    return true;
}

/// No axis separates the hulls by more than this: how far a corner is from a face that it lies over; a large number where none
/// of the corners nearest to it does.
float distanceOver(const Hull& owner, const BestFace& best, const Hull& other, const RelativePlace& otherInOwner) {
    const HullPlane& plane = owner.planes[best.face];
    const Vec3f down = otherInOwner.turn.transposedTimes(plane.normal);
    const float offset = dot(plane.normal, otherInOwner.offset) - plane.offset;
    for (int i = 0; i < other.cornerCount; ++i) {
        const float height = dot(down, other.corner(i)) + offset;
        if (height > best.separation + kTouching) continue;
        const Vec3f point = otherInOwner.turn * other.corner(i) + otherInOwner.offset;
        if (isOver(owner, best.face, point, kTouching)) return std::max(height, 0.0f) + kTouching;
    }
    return 1e30f;
}

struct BestEdges {
    int first = -1;
    int second = -1;
    float separation = -1e30f;
    Vec3f normal{0.0f, 1.0f, 0.0f};
};

/// An edge of the second hull in the first's frame.
struct PlacedEdge {
    Vec3f vector;
    Vec3f corner;
    Vec3f firstNormal;
    Vec3f secondNormal;
};

PlacedEdge placedEdge(const Hull& hull, int edge, const RelativePlace& place) {
    const auto at = [&](const VectorRows& rows) { return Vec3f(rows.x[edge], rows.y[edge], rows.z[edge]); };
    return {place.turn * at(hull.edgeVectors), place.turn * at(hull.edgeCorners) + place.offset,
            place.turn * at(hull.edgeFirstNormals), place.turn * at(hull.edgeSecondNormals)};
}

/// Four edges of the first hull against one of the second: they make a face of the hulls' difference where the arcs between
/// their faces' normals cross on the sphere.
void takeBetter(BestEdges& best, const Hull& first, int firstEdge, const PlacedEdge& edge, int secondEdge) {
    const FourVec3 u = four(first.edgeVectors, firstEdge), v = splat(edge.vector);
    const FourVec3 normalA = four(first.edgeFirstNormals, firstEdge),
                   normalB = four(first.edgeSecondNormals, firstEdge);
    const Four cba = -dot<kLanes>(splat(edge.firstNormal), u), dba = -dot<kLanes>(splat(edge.secondNormal), u);
    const Four adc = dot<kLanes>(normalA, v), bdc = dot<kLanes>(normalB, v);
    const Four none{};
    // The cross product of the second edge's normals runs along it or against it: the sign of the third test decides
    // whether both arcs lie on one half of the sphere.
    auto crosses = (cba * dba < none) & (adc * bdc < none) & (cba * bdc > none);
    if (bitsOf<kLanes>(crosses) == 0) return;
    FourVec3 axis = cross<kLanes>(u, v);
    const Four size = dot<kLanes>(axis, axis);
    crosses &= size > kParallelSquared * dot<kLanes>(u, u) * dot<kLanes>(v, v);
    if (bitsOf<kLanes>(crosses) == 0) return;
    const Four scale = 1.0f / squareRoot<kLanes>(select<kLanes>(crosses, size, all<kLanes>(1.0f)));
    const Four outwards = dot<kLanes>(axis, normalA + normalB);
    axis = axis * select<kLanes>(outwards < none, -scale, scale);
    const FourVec3 way = splat(edge.corner) - four(first.edgeCorners, firstEdge);
    const Four separation = select<kLanes>(crosses, dot<kLanes>(axis, way), all<kLanes>(-1e30f));
    for (int lane = 0; lane < kLanes; ++lane) {
        if (separation[lane] > best.separation) {
            best = {firstEdge + lane, secondEdge, separation[lane], Vec3f(axis.x[lane], axis.y[lane], axis.z[lane])};
        }
    }
}

/// Which fours of a hull's edges have one with a face that looks along a direction.
std::uint64_t foursFacing(const Hull& hull, Vec3f direction) {
    const FourVec3 wide = splat(direction);
    const Four none{};
    std::uint64_t fours = 0;
    const int count = std::min(static_cast<int>(hull.edgeVectors.x.size()), 64 * kLanes);
    for (int i = 0; i < count; i += kLanes) {
        const auto faces = (dot<kLanes>(four(hull.edgeFirstNormals, i), wide) > none) |
                           (dot<kLanes>(four(hull.edgeSecondNormals, i), wide) > none);
        fours |= static_cast<std::uint64_t>(bitsOf<kLanes>(faces) != 0) << (i / kLanes);
    }
    return fours;
}

/// The best pair of edges that separates the hulls by more than `least`.
BestEdges bestEdges(const Hull& first, const Hull& second, const RelativePlace& place, float least, float margin) {
    BestEdges best;
    best.separation = least;
    const int padded = static_cast<int>(first.edgeVectors.x.size()), count = static_cast<int>(second.edges.size());
    // An axis that separates them by more than balls within them overlap leads from one centre towards the other, and so does
    // the normal of a face at each of its edges.
    const bool leadsAcross = first.inner + second.inner + least > 0.0f;
    const std::uint64_t fours = leadsAcross ? foursFacing(first, place.offset) : ~std::uint64_t{0};
    for (int j = 0; j < count && (best.first < 0 || best.separation <= margin); ++j) {
        const PlacedEdge edge = placedEdge(second, j, place);
        if (leadsAcross && dot(edge.firstNormal, place.offset) >= 0.0f && dot(edge.secondNormal, place.offset) >= 0.0f)
            continue;
        for (int i = 0; i < padded; i += kLanes) {
            if (i >= 64 * kLanes || (fours >> (i / kLanes) & 1u) != 0) takeBetter(best, first, i, edge, j);
        }
    }
    return best;
}

RelativePlace inverse(const RelativePlace& place) {
    return {place.turn.transposed(), place.turn.transposedTimes(place.offset) * -1.0f};
}

SeparatingAxis firstFaceAxis(const Hull& first, const BestFace& best) {
    return {AxisKind::FirstFace, static_cast<std::uint16_t>(best.face), 0, best.separation,
            first.planes[best.face].normal};
}

SeparatingAxis secondFaceAxis(const Hull& second, const RelativePlace& place, const BestFace& best) {
    return {AxisKind::SecondFace, 0, static_cast<std::uint16_t>(best.face), best.separation,
            place.turn * second.planes[best.face].normal * -1.0f};
}

}  // namespace

SeparatingAxis axisOfFace(const SeparatingAxis& face, const Hull& first, const Hull& second,
                          const RelativePlace& place) {
    if (face.kind == AxisKind::FirstFace) {
        return firstFaceAxis(first, {face.first, faceSeparation(first, face.first, second, place)});
    }
    return secondFaceAxis(second, place, {face.second, faceSeparation(second, face.second, first, inverse(place))});
}

SeparatingAxis likelyFace(const Hull& first, const Hull& second, const RelativePlace& place) {
    const Vec3f way = place.offset + place.turn * second.middle - first.middle;
    const Vec3f extents = first.extents + magnitudes(place.turn.x) * second.extents.x +
                          magnitudes(place.turn.y) * second.extents.y + magnitudes(place.turn.z) * second.extents.z;
    const Vec3f gaps = magnitudes(way) - extents;
    if (std::max({gaps.x, gaps.y, gaps.z}) < -kDeep) return {};
    Vec3f side(0.0f);
    if (gaps.x >= gaps.y && gaps.x >= gaps.z) {
        side.x = way.x;
    } else if (gaps.y >= gaps.z) {
        side.y = way.y;
    } else {
        side.z = way.z;
    }
    return firstFaceAxis(first, {first.facing(side), 0.0f});
}

SeparatingAxis bestFaceAxis(const Hull& first, const Hull& second, const RelativePlace& place, float margin,
                            const SeparatingAxis& guess) {
    const RelativePlace firstInSecond = inverse(place);
    const int startFirst = guess.kind == AxisKind::FirstFace ? guess.first : 0;
    const int startSecond = guess.kind == AxisKind::SecondFace ? guess.second : 0;
    if (guess.kind == AxisKind::SecondFace) {
        const SeparatingAxis before = axisOfFace(guess, first, second, place);
        if (before.separation > margin) return before;
    }
    const BestFace ofFirst = bestFace(first, second, place, margin, startFirst);
    if (ofFirst.separation > margin) return firstFaceAxis(first, ofFirst);
    const BestFace ofSecond = bestFace(second, first, firstInSecond, margin, startSecond);
    const bool isSecond = ofSecond.separation > ofFirst.separation + kAxisPreference;
    return isSecond ? secondFaceAxis(second, place, ofSecond) : firstFaceAxis(first, ofFirst);
}

SeparatingAxis bestEdgesOr(const SeparatingAxis& face, const Hull& first, const Hull& second,
                           const RelativePlace& place, float margin) {
    // What lies on a face needs no look at its edges: they cannot be farther apart.
    const float enough = face.separation + kAxisPreference;
    const float distance = face.kind == AxisKind::FirstFace
                               ? distanceOver(first, {face.first, face.separation}, second, place)
                               : distanceOver(second, {face.second, face.separation}, first, inverse(place));
    if (distance <= enough) return face;
    const BestEdges edges = bestEdges(first, second, place, enough, margin);
    if (edges.first < 0) return face;
    return {AxisKind::Edges, static_cast<std::uint16_t>(edges.first), static_cast<std::uint16_t>(edges.second),
            edges.separation, edges.normal};
}

SeparatingAxis separatingAxis(const Hull& first, const Hull& second, const RelativePlace& place, float margin,
                              const SeparatingAxis& guess) {
    const SeparatingAxis face = bestFaceAxis(first, second, place, margin, guess);
    return face.separation > margin ? face : bestEdgesOr(face, first, second, place, margin);
}

}  // namespace rubble
