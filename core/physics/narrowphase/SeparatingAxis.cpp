#include "core/physics/narrowphase/SeparatingAxis.h"

#include "core/base/Assert.h"
#include "core/physics/math/LaneMath.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

constexpr int kLanes = 4;
using Four = Floats<kLanes>;
using FourVec3 = WideVec3<kLanes>;

constexpr float kTouching = 1e-4f;  // m: tolerance of lying in a plane, or above a face
constexpr float kDeepOverlap =
    0.002f;  // m: overlap of bounding boxes beyond which no face is likely to separate the hulls
constexpr float kParallelSquared = 2.5e-5f;  // squared sine, 0.005, of the angle below which edges count as parallel

FourVec3 splat(Vec3f v) { return {all<kLanes>(v.x), all<kLanes>(v.y), all<kLanes>(v.z)}; }
FourVec3 four(const VectorRows& rows, int first) {
    return {loaded<kLanes>(&rows.x[first]), loaded<kLanes>(&rows.y[first]), loaded<kLanes>(&rows.z[first])};
}

/// The largest extent of a hull's corners along a direction.
float supportDistance(const Hull& hull, Vec3f direction) {
    const FourVec3 wide = splat(direction);
    Four most = dot<kLanes>(four(hull.corners, 0), wide);
    const int padded = static_cast<int>(hull.corners.x.size());
    for (int i = kLanes; i < padded; i += kLanes)
        most = greater<kLanes>(most, dot<kLanes>(four(hull.corners, i), wide));
    const float left = most[0] > most[1] ? most[0] : most[1], right = most[2] > most[3] ? most[2] : most[3];
    return left > right ? left : right;
}

float faceSeparation(const Hull& owner, int face, const Hull& other, const RelativePose& otherInOwner) {
    const HullPlane& plane = owner.planes[face];
    const Vec3f inOther = otherInOwner.rotation.transposedTimes(plane.normal) * -1.0f;
    return dot(plane.normal, otherInOwner.offset) - supportDistance(other, inOther) - plane.offset;
}

/// An upper bound of faceSeparation(), from the other hull's inscribed sphere.
float maxFaceSeparation(const Hull& owner, int face, const Hull& other, const RelativePose& otherInOwner) {
    const HullPlane& plane = owner.planes[face];
    return dot(plane.normal, otherInOwner.offset) - other.innerRadius - plane.offset;
}

struct BestFace {
    int face = 0;
    float separation = -1e30f;
};

/// The face along which the hulls are farthest apart, or the first found beyond the margin; tests `start` first.
BestFace bestFace(const Hull& owner, const Hull& other, const RelativePose& otherInOwner, float margin, int start) {
    BestFace best{start, faceSeparation(owner, start, other, otherInOwner)};
    const int count = static_cast<int>(owner.planes.size());
    for (int face = 0; face < count && best.separation <= margin; ++face) {
        if (face == start || maxFaceSeparation(owner, face, other, otherInOwner) <= best.separation) continue;
        const float separation = faceSeparation(owner, face, other, otherInOwner);
        if (separation > best.separation) best = {face, separation};
    }
    return best;
}

/// Whether a point projects onto a face, with a tolerance.
bool projectsOnto(const Hull& owner, int face, Vec3f point, float tolerance) {
    for (const HullPlane& side : owner.sidesOf(face)) {
        if (dot(side.normal, point) - side.offset > tolerance) return false;
    }
    return true;
}

/// An upper bound of the separation along any axis: the height of a nearest corner that projects onto the face; a large
/// number if none does.
float separationBound(const Hull& owner, const BestFace& best, const Hull& other, const RelativePose& otherInOwner) {
    const HullPlane& plane = owner.planes[best.face];
    const Vec3f down = otherInOwner.rotation.transposedTimes(plane.normal);
    const float offset = dot(plane.normal, otherInOwner.offset) - plane.offset;
    for (int i = 0; i < other.cornerCount; ++i) {
        const float height = dot(down, other.corner(i)) + offset;
        if (height > best.separation + kTouching) continue;
        const Vec3f point = otherInOwner.rotation * other.corner(i) + otherInOwner.offset;
        if (projectsOnto(owner, best.face, point, kTouching)) return std::max(height, 0.0f) + kTouching;
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
struct TransformedEdge {
    Vec3f vector;
    Vec3f corner;
    Vec3f firstNormal;
    Vec3f secondNormal;
};

TransformedEdge transformEdge(const Hull& hull, int edge, const RelativePose& pose) {
    const auto at = [&](const VectorRows& rows) { return Vec3f(rows.x[edge], rows.y[edge], rows.z[edge]); };
    return {pose.rotation * at(hull.edgeVectors), pose.rotation * at(hull.edgeCorners) + pose.offset,
            pose.rotation * at(hull.edgeFirstNormals), pose.rotation * at(hull.edgeSecondNormals)};
}

/// The separation of hulls along a direction from the first to the second, in the first's frame.
float separationAlong(Vec3f normal, const Hull& first, const Hull& second, const RelativePose& pose) {
    const Vec3f back = pose.rotation.transposedTimes(normal) * -1.0f;
    return dot(normal, pose.offset) - supportDistance(second, back) - supportDistance(first, normal);
}

/// Tests four edges of the first hull against one of the second. A pair forms a face of the Minkowski difference if the
/// arcs between the normals of its faces cross on the Gauss map. Arcs of merged faces, which are not quite flat, may
/// cross where others are farther out: then the separation along the axis is what counts.
void improve(BestEdges& best, const Hull& first, int firstEdge, const TransformedEdge& edge, int secondEdge,
             const Hull& second, const RelativePose& pose) {
    const FourVec3 u = four(first.edgeVectors, firstEdge), v = splat(edge.vector);
    const FourVec3 normalA = four(first.edgeFirstNormals, firstEdge),
                   normalB = four(first.edgeSecondNormals, firstEdge);
    const Four cba = -dot<kLanes>(splat(edge.firstNormal), u), dba = -dot<kLanes>(splat(edge.secondNormal), u);
    const Four adc = dot<kLanes>(normalA, v), bdc = dot<kLanes>(normalB, v);
    const Four none{};
    // The sign of the third test decides whether both arcs lie on one hemisphere.
    auto crosses = (cba * dba < none) & (adc * bdc < none) & (cba * bdc > none);
    if (bitsOf<kLanes>(crosses) == 0) return;
    FourVec3 axis = cross<kLanes>(u, v);
    const Four size = dot<kLanes>(axis, axis);
    crosses &= size > kParallelSquared * dot<kLanes>(u, u) * dot<kLanes>(v, v);
    if (bitsOf<kLanes>(crosses) == 0) return;
    const Four scale = 1.0f / squareRoot<kLanes>(select<kLanes>(crosses, size, all<kLanes>(1.0f)));
    const Four outwards = dot<kLanes>(axis, normalA + normalB);
    axis = axis * select<kLanes>(outwards < none, -scale, scale);
    const FourVec3 displacement = splat(edge.corner) - four(first.edgeCorners, firstEdge);
    const Four separation = select<kLanes>(crosses, dot<kLanes>(axis, displacement), all<kLanes>(-1e30f));
    for (int lane = 0; lane < kLanes; ++lane) {
        if (!(separation[lane] > best.separation)) continue;
        const Vec3f normal(axis.x[lane], axis.y[lane], axis.z[lane]);
        const float ofHulls = separationAlong(normal, first, second, pose);
        const float certain = ofHulls < separation[lane] - kTouching ? ofHulls : separation[lane];
        if (certain > best.separation) best = {firstEdge + lane, secondEdge, certain, normal};
    }
}

/// One bit per group of four edges: set if one of them has a face with a normal along `direction`.
std::uint64_t edgeGroupsFacing(const Hull& hull, Vec3f direction) {
    const FourVec3 wide = splat(direction);
    const Four none{};
    std::uint64_t groups = 0;
    const int count = std::min(static_cast<int>(hull.edgeVectors.x.size()), 64 * kLanes);
    for (int i = 0; i < count; i += kLanes) {
        const auto faces = (dot<kLanes>(four(hull.edgeFirstNormals, i), wide) > none) |
                           (dot<kLanes>(four(hull.edgeSecondNormals, i), wide) > none);
        groups |= static_cast<std::uint64_t>(bitsOf<kLanes>(faces) != 0) << (i / kLanes);
    }
    return groups;
}

/// The best edge pair that separates the hulls by more than `least`.
BestEdges bestEdges(const Hull& first, const Hull& second, const RelativePose& pose, float least, float margin) {
    BestEdges best;
    best.separation = least;
    const int padded = static_cast<int>(first.edgeVectors.x.size()), count = static_cast<int>(second.edges.size());
    // An axis with more separation than the inscribed spheres' points from the first centre to the second, and so does
    // the normal of a face at each of its edges.
    const bool pointsAcross = first.innerRadius + second.innerRadius + least > 0.0f;
    const std::uint64_t groups = pointsAcross ? edgeGroupsFacing(first, pose.offset) : ~std::uint64_t{0};
    for (int j = 0; j < count && (best.first < 0 || best.separation <= margin); ++j) {
        const TransformedEdge edge = transformEdge(second, j, pose);
        if (pointsAcross && dot(edge.firstNormal, pose.offset) >= 0.0f && dot(edge.secondNormal, pose.offset) >= 0.0f)
            continue;
        for (int i = 0; i < padded; i += kLanes) {
            if (i >= 64 * kLanes || (groups >> (i / kLanes) & 1u) != 0) improve(best, first, i, edge, j, second, pose);
        }
    }
    return best;
}

RelativePose inverse(const RelativePose& pose) {
    return {pose.rotation.transposed(), pose.rotation.transposedTimes(pose.offset) * -1.0f};
}

SeparatingAxis firstFaceAxis(const Hull& first, const BestFace& best) {
    return {AxisKind::FirstFace, static_cast<std::uint16_t>(best.face), 0, best.separation,
            first.planes[best.face].normal};
}

/// Whether an axis shows that hulls only touch that overlap along another, preferred one.
bool showsApart(float separation, float preferred) {
    return preferred < -kTouchingOverlap && separation >= -kTouchingOverlap;
}

SeparatingAxis secondFaceAxis(const Hull& second, const RelativePose& pose, const BestFace& best) {
    return {AxisKind::SecondFace, 0, static_cast<std::uint16_t>(best.face), best.separation,
            pose.rotation * second.planes[best.face].normal * -1.0f};
}

}  // namespace

SeparatingAxis faceAxis(const SeparatingAxis& face, const Hull& first, const Hull& second, const RelativePose& pose) {
    RUBBLE_ASSERT(face.isFace());
    if (face.kind == AxisKind::FirstFace) {
        return firstFaceAxis(first, {face.first, faceSeparation(first, face.first, second, pose)});
    }
    return secondFaceAxis(second, pose, {face.second, faceSeparation(second, face.second, first, inverse(pose))});
}

SeparatingAxis initialGuess(const Hull& first, const Hull& second, const RelativePose& pose) {
    const Vec3f displacement = pose.offset + pose.rotation * second.middle - first.middle;
    const Vec3f extents = first.extents + componentAbs(pose.rotation.x) * second.extents.x +
                          componentAbs(pose.rotation.y) * second.extents.y +
                          componentAbs(pose.rotation.z) * second.extents.z;
    const Vec3f gaps = componentAbs(displacement) - extents;
    if (std::max({gaps.x, gaps.y, gaps.z}) < -kDeepOverlap) return {};
    Vec3f side(0.0f);
    if (gaps.x >= gaps.y && gaps.x >= gaps.z) {
        side.x = displacement.x;
    } else if (gaps.y >= gaps.z) {
        side.y = displacement.y;
    } else {
        side.z = displacement.z;
    }
    return firstFaceAxis(first, {first.faceAlong(side), 0.0f});
}

SeparatingAxis bestFaceAxis(const Hull& first, const Hull& second, const RelativePose& pose, float margin,
                            const SeparatingAxis& guess) {
    const RelativePose firstInSecond = inverse(pose);
    const int startFirst = guess.kind == AxisKind::FirstFace ? guess.first : 0;
    const int startSecond = guess.kind == AxisKind::SecondFace ? guess.second : 0;
    if (guess.kind == AxisKind::SecondFace) {
        const SeparatingAxis before = faceAxis(guess, first, second, pose);
        if (before.separation > margin) return before;
    }
    const BestFace ofFirst = bestFace(first, second, pose, margin, startFirst);
    if (ofFirst.separation > margin) return firstFaceAxis(first, ofFirst);
    const BestFace ofSecond = bestFace(second, first, firstInSecond, margin, startSecond);
    const bool isSecond = ofSecond.separation > ofFirst.separation + kAxisPreference ||
                          showsApart(ofSecond.separation, ofFirst.separation);
    return isSecond ? secondFaceAxis(second, pose, ofSecond) : firstFaceAxis(first, ofFirst);
}

SeparatingAxis bestEdgeAxis(const SeparatingAxis& face, const Hull& first, const Hull& second, const RelativePose& pose,
                            float margin, float preference) {
    RUBBLE_ASSERT(face.isFace());
    // Edges cannot separate more than the bound given by a corner above the face.
    const float enough = face.separation + preference;
    const float distance = face.kind == AxisKind::FirstFace
                               ? separationBound(first, {face.first, face.separation}, second, pose)
                               : separationBound(second, {face.second, face.separation}, first, inverse(pose));
    if (distance <= enough) return face;
    const float least = face.separation < -kTouchingOverlap ? std::min(enough, -kTouchingOverlap) : enough;
    const BestEdges edges = bestEdges(first, second, pose, least, margin);
    if (edges.first < 0) return face;
    return {AxisKind::Edges, static_cast<std::uint16_t>(edges.first), static_cast<std::uint16_t>(edges.second),
            edges.separation, edges.normal};
}

SeparatingAxis separatingAxis(const Hull& first, const Hull& second, const RelativePose& pose, float margin,
                              const SeparatingAxis& guess) {
    const SeparatingAxis face = bestFaceAxis(first, second, pose, margin, guess);
    return face.separation > margin ? face : bestEdgeAxis(face, first, second, pose, margin);
}

}  // namespace rubble
