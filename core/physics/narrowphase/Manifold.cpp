#include "core/physics/narrowphase/Manifold.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace rubble {
namespace {

/// Of two points that span nearly as much, the earlier is kept, for coherence with the last manifold.
constexpr float kHysteresis = 1.05f;
constexpr float kMinSpread = 1e-6f;       // m²: points within a millimetre count as one
constexpr float kAlignedCosine = 0.8f;    // of the angle between an edge axis and a face normal that stands for it
constexpr float kMissedDepth = 0.0005f;   // m: a pair of edges that much deeper than the clipped points is one, too
constexpr float kParallelCosine = 0.98f;  // of the angle between faces that both serve as the reference
constexpr float kNearHeight = 0.004f;     // m: corners of nearly parallel faces above the deepest point
constexpr float kNearFraction = 0.05f;    // of the width, at most: the far side of a splinter is none of them
constexpr int kMaxClippedPoints = 2 * kMaxHullCorners;
constexpr std::uint32_t kCutByEdge = 1u << 31;
constexpr std::uint32_t kOnSecondFace = 1u << 30;

/// A vertex of the clipped incident face. Left uninitialized: hundreds lie on the stack, of which few are used.
struct ClippedPoint {
    Vec3f position;
    float height;             // above the reference face
    std::uint16_t edgeAfter;  // the edge that starts here: of the incident face, or a side of the reference face
    std::uint32_t feature;
};

/// Transforms the incident face into the reference hull's frame.
int transformFace(const Hull& hull, int face, const RelativePose& pose, const HullPlane& reference, ClippedPoint* out) {
    const std::span<const std::uint16_t> loop = hull.face(face);
    int count = 0;
    for (std::uint16_t corner : loop) {
        const Vec3f at = pose.rotation * hull.corner(corner) + pose.offset;
        out[count++] = {at, dot(reference.normal, at) - reference.offset, corner, corner};
    }
    return count;
}

/// Computes the heights of points above a plane. True if any is positive.
bool computeHeights(const HullPlane& plane, const ClippedPoint* points, int count, float* heights) {
    float highest = -1.0f;
    for (int i = 0; i < count; ++i) {
        heights[i] = dot(plane.normal, points[i].position) - plane.offset;
        highest = std::max(highest, heights[i]);
    }
    return highest > 0.0f;
}

/// Sutherland-Hodgman: clips by the plane of a side of the reference face; `heights` are those above the plane.
int clip(const float* heights, std::uint16_t side, const ClippedPoint* in, int count, ClippedPoint* out) {
    int kept = 0;
    float before = heights[count - 1];
    for (int i = 0; i < count; ++i) {
        const ClippedPoint& from = in[i == 0 ? count - 1 : i - 1];
        const ClippedPoint& to = in[i];
        const float after = heights[i];
        if ((before <= 0.0f) != (after <= 0.0f)) {
            const float fraction = before / (before - after);
            const std::uint32_t feature =
                kCutByEdge | static_cast<std::uint32_t>(from.edgeAfter) << 12 | side | (before <= 0.0f ? 1u << 24 : 0u);
            const Vec3f at = from.position + (to.position - from.position) * fraction;
            out[kept++] = {at, from.height + (to.height - from.height) * fraction,
                           before <= 0.0f ? static_cast<std::uint16_t>(side | 0x800u) : from.edgeAfter, feature};
        }
        if (after <= 0.0f) out[kept++] = to;
        before = after;
    }
    return kept;
}

/// Twice the signed area of a, b, c; positive if counter-clockwise seen against the normal, m².
float twiceArea(Vec3f normal, Vec3f a, Vec3f b, Vec3f c) { return dot(normal, cross(b - a, c - a)); }

/// The index of the point with the highest score; the earliest of nearly equal ones, -1 if none is above `least`.
template <class Score>
int bestOf(const ClippedPoint* points, int count, float least, const Score& score) {
    int best = -1;
    float most = least;
    for (int i = 0; i < count; ++i) {
        const float value = score(points[i]);
        if (value > most) {
            most = value * kHysteresis;
            best = i;
        }
    }
    return best;
}

float deepestOf(const ClippedPoint* points, int count) {
    float deepest = points[0].height;
    for (int i = 1; i < count; ++i) deepest = std::min(deepest, points[i].height);
    return deepest;
}

/// 1 for the deepest point, half for one a millimetre above it.
float depthWeight(const ClippedPoint& point, float deepest) { return 0.001f / (point.height - deepest + 0.001f); }

/// Reduces the manifold to four points, moved to the front: the deepest, the one farthest from it, the one that spans
/// the largest triangle with both, and the one farthest outside that triangle. `weigh(point)` scales what a point
/// spans.
template <class Weigh>
int reduce(ClippedPoint* points, int count, Vec3f normal, const Weigh& weigh) {
    if (count <= kMaxManifoldPoints) return count;
    const auto moveTo = [&](int index, int found) { std::swap(points[index], points[found]); };
    const float deepest = deepestOf(points, count);
    moveTo(0, bestOf(points, count, 0.0f, [&](const ClippedPoint& p) { return depthWeight(p, deepest); }));
    const Vec3f a = points[0].position;
    int found = bestOf(points + 1, count - 1, kMinSpread,
                       [&](const ClippedPoint& p) { return lengthSquared(p.position - a) * weigh(p); });
    if (found < 0) return 1;
    moveTo(1, 1 + found);
    const Vec3f b = points[1].position;
    found = bestOf(points + 2, count - 2, kMinSpread,
                   [&](const ClippedPoint& p) { return std::abs(twiceArea(normal, a, b, p.position)) * weigh(p); });
    if (found < 0) return 2;
    moveTo(2, 2 + found);
    const Vec3f c = points[2].position;
    const float inwards = twiceArea(normal, a, b, c) > 0.0f ? 1.0f : -1.0f;
    found = bestOf(points + 3, count - 3, kMinSpread, [&](const ClippedPoint& p) {
        const float least = std::min(
            inwards * twiceArea(normal, a, b, p.position),
            std::min(inwards * twiceArea(normal, b, c, p.position), inwards * twiceArea(normal, c, a, p.position)));
        return -least * weigh(p);
    });
    if (found < 0) return 3;
    moveTo(3, 3 + found);
    return 4;
}

/// A reference face and an incident face, and the normal along which their separation is measured.
struct FacePair {
    int reference = 0;
    int incident = 0;
    Vec3f normal;                  // from the owner of the reference face to the other hull, in the owner's frame
    float minSeparation = -1e30f;  // m, of the hulls along the normal
};

/// Measures the heights of points above the reference face along the normal of the pair.
void measureAlong(const FacePair& faces, Vec3f referenceNormal, ClippedPoint* points, int count) {
    const float scale = 1.0f / dot(faces.normal, referenceNormal);
    for (int i = 0; i < count; ++i) points[i].height = std::max(points[i].height * scale, faces.minSeparation);
}

/// Adds the point of two edges where no clipped one is as deep. Returns the number of points.
int addEdgePoint(const Manifold::Point& edges, Vec3f normal, ClippedPoint* points, int count) {
    for (int i = 0; i < count; ++i) {
        if (points[i].height <= edges.separation + kMissedDepth) return count;
    }
    points[count] = {edges.position + normal * (0.5f * edges.separation), edges.separation, 0, edges.feature};
    return count + 1;
}

bool liesOver(const Hull& owner, int face, Vec3f point) {
    return std::ranges::all_of(owner.sidesOf(face),
                               [&](const HullPlane& side) { return dot(side.normal, point) <= side.offset; });
}

/// Adds the other corners of a rounded hull that lie over the reference face and hardly above the deepest point: of
/// its faces that are nearly in one plane only one is clipped. Returns the number of points.
int addNearCorners(const Hull& owner, const Hull& other, const RelativePose& pose, const FacePair& faces,
                   ClippedPoint* points, int count) {
    const HullPlane& reference = owner.planes[faces.reference];
    const Vec3f down = pose.rotation.transposedTimes(faces.normal);
    const Vec3f lowest = pose.rotation * other.corner(other.farthest(down * -1.0f)) + pose.offset;
    const float scale = 1.0f / dot(faces.normal, reference.normal);
    const auto heightOf = [&](Vec3f at) { return (dot(reference.normal, at) - reference.offset) * scale; };
    const float highest =
        std::max(heightOf(lowest), faces.minSeparation) + std::min(kNearHeight, kNearFraction * other.minWidth);
    const int clipped = count;
    for (int i = 0; i < other.cornerCount && count < kMaxClippedPoints; ++i) {
        const Vec3f at = pose.rotation * other.corner(i) + pose.offset;
        const float height = std::max(heightOf(at), faces.minSeparation);
        if (height > highest || !liesOver(owner, faces.reference, at)) continue;
        const auto feature = static_cast<std::uint32_t>(i);
        const bool isThere =
            std::any_of(points, points + clipped, [&](const ClippedPoint& p) { return p.feature == feature; });
        if (!isThere) points[count++] = {at, height, 0, feature};
    }
    return count;
}

/// The manifold of two faces, in the frame of the reference face's owner. `edges`: the point of two edges, or null.
Manifold clippedManifold(const Hull& owner, const Hull& other, const RelativePose& pose, const FacePair& faces,
                         const Manifold::Point* edges, float margin) {
    ClippedPoint buffers[2][kMaxClippedPoints + 1];
    const HullPlane& reference = owner.planes[faces.reference];
    ClippedPoint *in = buffers[0], *out = buffers[1];
    int count = transformFace(other, faces.incident, pose, reference, in);
    const std::span<const std::uint16_t> loop = owner.face(faces.reference);
    const std::span<const HullPlane> sides = owner.sidesOf(faces.reference);
    float heights[kMaxClippedPoints];
    for (std::size_t i = 0; i < loop.size() && count > 0; ++i) {
        if (!computeHeights(sides[i], in, count, heights)) continue;
        count = clip(heights, loop[i], in, count, out);
        std::swap(in, out);
    }
    measureAlong(faces, reference.normal, in, count);
    if (edges != nullptr) count = addEdgePoint(*edges, faces.normal, in, count);
    if (other.minTurn < kSharpTurn) count = addNearCorners(owner, other, pose, faces, in, count);
    const ClippedPoint* end = std::remove_if(in, in + count, [&](const ClippedPoint& p) { return p.height > margin; });
    count = static_cast<int>(end - in);
    if (other.minTurn < kSharpTurn && count > 0) {
        const float deepest = deepestOf(in, count);
        count = reduce(in, count, faces.normal, [&](const ClippedPoint& p) { return depthWeight(p, deepest); });
    } else {
        count = reduce(in, count, faces.normal, [](const ClippedPoint&) { return 1.0f; });
    }
    Manifold manifold;
    manifold.normal = faces.normal;
    manifold.count = count;
    for (int i = 0; i < count; ++i) {
        manifold.points[i] = {in[i].position - faces.normal * (0.5f * in[i].height), in[i].height, in[i].feature};
    }
    return manifold;
}

RelativePose inverse(const RelativePose& pose) {
    return {pose.rotation.transposed(), pose.rotation.transposedTimes(pose.offset) * -1.0f};
}

/// A manifold of the second hull's face, from the second hull's frame into the first's.
Manifold fromSecond(Manifold manifold, const RelativePose& pose) {
    manifold.normal = pose.rotation * manifold.normal * -1.0f;
    for (int i = 0; i < manifold.count; ++i) {
        Manifold::Point& point = manifold.points[i];
        point.position = pose.rotation * point.position + pose.offset;
        point.feature |= kOnSecondFace;
    }
    return manifold;
}

/// The face at a corner that is most along a direction.
int faceAt(const Hull& hull, int corner, Vec3f direction) {
    int best = -1;
    float most = -2.0f;
    for (int face = 0; face < static_cast<int>(hull.planes.size()); ++face) {
        const float along = dot(direction, hull.planes[face].normal);
        if (along <= most || std::ranges::find(hull.face(face), corner) == hull.face(face).end()) continue;
        most = along;
        best = face;
    }
    return best;
}

/// The manifold of two faces for the normal of the first, in its owner's frame. The second is the reference where it
/// is nearly parallel and the first is of the rounder hull, whose faces nearly in its plane count as well.
Manifold manifoldOf(const Hull& owner, const Hull& other, const RelativePose& pose, const FacePair& faces,
                    float margin) {
    const Vec3f opposed = pose.rotation.transposedTimes(faces.normal) * -1.0f;
    const bool isRounder = owner.minTurn < std::min(other.minTurn, kSharpTurn);
    if (!isRounder || dot(opposed, other.planes[faces.incident].normal) < kParallelCosine)
        return clippedManifold(owner, other, pose, faces, nullptr, margin);
    const FacePair swapped{.reference = faces.incident, .incident = faces.reference, .normal = opposed};
    return fromSecond(clippedManifold(other, owner, inverse(pose), swapped, nullptr, margin), pose);
}

/// The manifold for a reference face of `owner`, in its frame: with the other's face that is most opposed to it, or,
/// where that is elsewhere than the other's deepest corner and this lies over the reference face, with the most opposed
/// one at that corner.
Manifold faceManifold(const Hull& owner, int face, const Hull& other, const RelativePose& pose, float margin,
                      Vec3f turn) {
    const HullPlane& plane = owner.planes[face];
    const Vec3f opposed = pose.rotation.transposedTimes(plane.normal) * -1.0f;
    Vec3f soon = opposed;
    if (other.minTurn < kSharpTurn) soon = pose.rotation.transposedTimes(cross(turn, plane.normal) - plane.normal);
    FacePair faces{.reference = face, .incident = other.faceAlong(soon), .normal = plane.normal};
    const Manifold manifold = manifoldOf(owner, other, pose, faces, margin);
    const int deepest = other.farthest(opposed);
    const Vec3f corner = pose.rotation * other.corner(deepest) + pose.offset;
    const float depth = dot(plane.normal, corner) - plane.offset;
    if (depth > margin || isReached(manifold, depth) || !liesOver(owner, face, corner)) return manifold;
    faces.incident = faceAt(other, deepest, opposed);
    return clippedManifold(owner, other, pose, faces, nullptr, margin);
}

/// The point halfway between the closest points of two edges; nothing if these lie beyond the ends, or too far apart.
std::optional<Manifold::Point> edgePoint(const SeparatingAxis& axis, const Hull& first, const Hull& second,
                                         const RelativePose& pose, float margin) {
    const HullEdge &edgeA = first.edges[axis.first], &edgeB = second.edges[axis.second];
    const Vec3f a = first.corner(edgeA.from), u = first.corner(edgeA.to) - a;
    const Vec3f b = pose.rotation * second.corner(edgeB.from) + pose.offset;
    const Vec3f v = pose.rotation * second.corner(edgeB.to) + pose.offset - b;
    const Vec3f displacement = b - a;
    const float uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
    if (determinant <= 0.0f) return std::nullopt;
    const float s = (dot(u, displacement) * vv - dot(v, displacement) * uv) / determinant;
    const float t = (dot(u, displacement) * uv - dot(v, displacement) * uu) / determinant;
    const float separation = dot(axis.normal, displacement);
    if (s < 0.0f || s > 1.0f || t < 0.0f || t > 1.0f || separation > margin) return std::nullopt;
    return Manifold::Point{(a + u * s + b + v * t) * 0.5f, separation,
                           kCutByEdge | kOnSecondFace | static_cast<std::uint32_t>(axis.first) << 12 | axis.second};
}

/// The manifold of the faces that are nearly perpendicular to an axis of two edges, none if no face is. Where slender
/// bodies cross, the deepest pair of edges changes from step to step, but the faces and the points of their clip do
/// not: impulses stay with their points, and the bodies come to rest.
Manifold facesAlongEdges(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePose& pose,
                         const std::optional<Manifold::Point>& edges, float margin) {
    const Vec3f inSecond = pose.rotation.transposedTimes(axis.normal) * -1.0f;
    const int faceA = first.faceAlong(axis.normal), faceB = second.faceAlong(inSecond);
    const float alongA = dot(axis.normal, first.planes[faceA].normal);
    const float alongB = dot(inSecond, second.planes[faceB].normal);
    if (std::max(alongA, alongB) < kAlignedCosine) return {};
    if (alongA * kHysteresis >= alongB) {
        return clippedManifold(first, second, pose, {faceA, faceB, axis.normal, axis.separation},
                               edges ? &*edges : nullptr, margin);
    }
    Manifold::Point point;
    if (edges) {
        point = *edges;
        point.position = pose.rotation.transposedTimes(point.position - pose.offset);
    }
    return fromSecond(clippedManifold(second, first, inverse(pose), {faceB, faceA, inSecond, axis.separation},
                                      edges ? &point : nullptr, margin),
                      pose);
}

Manifold edgeManifold(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePose& pose,
                      float margin) {
    const std::optional<Manifold::Point> edges = edgePoint(axis, first, second, pose, margin);
    Manifold manifold = facesAlongEdges(axis, first, second, pose, edges, margin);
    manifold.normal = axis.normal;
    if (manifold.count == 0 && edges) {
        manifold.count = 1;
        manifold.points[0] = *edges;
    }
    return manifold;
}

}  // namespace

bool isReached(const Manifold& manifold, float separation) {
    return std::any_of(manifold.points.begin(), manifold.points.begin() + manifold.count,
                       [&](const Manifold::Point& point) { return point.separation <= separation + kMissedDepth; });
}

Manifold::Point supportingCorner(const SeparatingAxis& axis, const Hull& first, const Hull& second,
                                 const RelativePose& pose) {
    if (axis.kind == AxisKind::SecondFace) {
        const int corner = first.farthest(axis.normal);
        return {first.corner(corner), 0.0f, kOnSecondFace | static_cast<std::uint32_t>(corner)};
    }
    const int corner = second.farthest(pose.rotation.transposedTimes(axis.normal) * -1.0f);
    return {pose.rotation * second.corner(corner) + pose.offset, 0.0f, static_cast<std::uint32_t>(corner)};
}

Manifold manifoldAlong(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePose& pose,
                       float margin, Vec3f turn) {
    switch (axis.kind) {
        case AxisKind::FirstFace: return faceManifold(first, axis.first, second, pose, margin, turn);
        case AxisKind::SecondFace: {
            const Vec3f back = pose.rotation.transposedTimes(turn) * -1.0f;
            return fromSecond(faceManifold(second, axis.second, first, inverse(pose), margin, back), pose);
        }
        case AxisKind::Edges: return edgeManifold(axis, first, second, pose, margin);
        case AxisKind::None: break;
    }
    return {};
}

Manifold touchingManifold(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePose& pose,
                          float margin) {
    Manifold manifold = manifoldAlong(axis, first, second, pose, margin);
    manifold.normal = axis.normal;
    if (manifold.count == 0) {
        manifold.count = 1;
        manifold.points[0] = supportingCorner(axis, first, second, pose);
    }
    return manifold;
}

}  // namespace rubble
