#include "core/physics/Manifold.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

/// Of two points that span nearly as much, the earlier is kept: it is the one that was kept before.
constexpr float kClearlyMore = 1.05f;
constexpr float kLeastSpread = 1e-6f;  // m^2: points nearer than a millimetre serve as one
constexpr int kMostClipped = 2 * kMostHullCorners;
constexpr std::uint32_t kCutByEdge = 1u << 31;
constexpr std::uint32_t kOnSecondsFace = 1u << 30;

/// Without values of its own: hundreds of them lie on the stack for a few that are used.
struct Clipped {
    Vec3f place;
    float height;             // over the reference face
    std::uint16_t edgeAfter;  // which edge leaves it: of the clipped face, or of the face it is clipped to
    std::uint32_t feature;
};

/// A face of one hull in the other's frame.
int placedFace(const Hull& hull, int face, const RelativePlace& place, const HullPlane& reference, Clipped* out) {
    const std::span<const std::uint16_t> loop = hull.face(face);
    int count = 0;
    for (std::uint16_t corner : loop) {
        const Vec3f at = place.turn * hull.corner(corner) + place.offset;
        out[count++] = {at, dot(reference.normal, at) - reference.offset, corner, corner};
    }
    return count;
}

/// How far points lie in front of a plane. True where any does.
bool heightsOver(const HullPlane& plane, const Clipped* points, int count, float* heights) {
    float highest = -1.0f;
    for (int i = 0; i < count; ++i) {
        heights[i] = dot(plane.normal, points[i].place) - plane.offset;
        highest = std::max(highest, heights[i]);
    }
    return highest > 0.0f;
}

/// Keeps what lies behind a plane through a side of the reference face; `heights` are those over it.
int clippedBy(const float* heights, std::uint16_t side, const Clipped* in, int count, Clipped* out) {
    int kept = 0;
    float before = heights[count - 1];
    for (int i = 0; i < count; ++i) {
        const Clipped& from = in[i == 0 ? count - 1 : i - 1];
        const Clipped& to = in[i];
        const float after = heights[i];
        if ((before <= 0.0f) != (after <= 0.0f)) {
            const float share = before / (before - after);
            const std::uint32_t feature =
                kCutByEdge | static_cast<std::uint32_t>(from.edgeAfter) << 12 | side | (before <= 0.0f ? 1u << 24 : 0u);
            const Vec3f at = from.place + (to.place - from.place) * share;
            out[kept++] = {at, from.height + (to.height - from.height) * share,
                           before <= 0.0f ? static_cast<std::uint16_t>(side | 0x800u) : from.edgeAfter, feature};
        }
        if (after <= 0.0f) out[kept++] = to;
        before = after;
    }
    return kept;
}

/// Positive where a, b, c turn left seen against the normal, m^2.
float twiceArea(Vec3f normal, Vec3f a, Vec3f b, Vec3f c) { return dot(normal, cross(b - a, c - a)); }

/// The place in the list of what scores most; the earlier one of nearly equals, -1 where none is above `least`.
template <class Score>
int bestOf(const Clipped* points, int count, float least, const Score& score) {
    int best = -1;
    float most = least;
    for (int i = 0; i < count; ++i) {
        const float value = score(points[i]);
        if (value > most) {
            most = value * kClearlyMore;
            best = i;
        }
    }
    return best;
}

/// Moves the four points that matter to the front: the deepest, the one farthest from it, the one that spans the largest triangle
/// with both, and the one that lies farthest outside of that.
int reduced(Clipped* points, int count, Vec3f normal) {
    if (count <= kMostManifoldPoints) return count;
    const auto take = [&](int place, int found) { std::swap(points[place], points[found]); };
    float deepest = points[0].height;
    for (int i = 1; i < count; ++i) deepest = std::min(deepest, points[i].height);
    // Depths that differ by less than a millimetre are as good as equal.
    take(0, bestOf(points, count, 0.0f, [&](const Clipped& p) { return 0.001f / (p.height - deepest + 0.001f); }));
    const Vec3f a = points[0].place;
    int found =
        bestOf(points + 1, count - 1, kLeastSpread, [&](const Clipped& p) { return lengthSquared(p.place - a); });
    if (found < 0) return 1;
    take(1, 1 + found);
    const Vec3f b = points[1].place;
    found = bestOf(points + 2, count - 2, kLeastSpread,
                   [&](const Clipped& p) { return std::abs(twiceArea(normal, a, b, p.place)); });
    if (found < 0) return 2;
    take(2, 2 + found);
    const Vec3f c = points[2].place;
    const float inwards = twiceArea(normal, a, b, c) > 0.0f ? 1.0f : -1.0f;
    found = bestOf(points + 3, count - 3, kLeastSpread, [&](const Clipped& p) {
        const float least =
            std::min(inwards * twiceArea(normal, a, b, p.place),
                     std::min(inwards * twiceArea(normal, b, c, p.place), inwards * twiceArea(normal, c, a, p.place)));
        return -least;
    });
    if (found < 0) return 3;
    take(3, 3 + found);
    return 4;
}

/// The manifold over a face of `owner`, in its frame.
Manifold overFace(const Hull& owner, int face, const Hull& other, const RelativePlace& place, float margin) {
    Clipped buffers[2][kMostClipped];
    const HullPlane& reference = owner.planes[face];
    const int facing = other.facing(place.turn.transposedTimes(reference.normal) * -1.0f);
    Clipped *in = buffers[0], *out = buffers[1];
    int count = placedFace(other, facing, place, reference, in);
    const std::span<const std::uint16_t> loop = owner.face(face);
    const std::span<const HullPlane> sides = owner.sidesOf(face);
    float heights[kMostClipped];
    for (std::size_t i = 0; i < loop.size() && count > 0; ++i) {
        if (!heightsOver(sides[i], in, count, heights)) continue;
        count = clippedBy(heights, loop[i], in, count, out);
        std::swap(in, out);
    }
    const Clipped* end = std::remove_if(in, in + count, [&](const Clipped& p) { return p.height > margin; });
    count = reduced(in, static_cast<int>(end - in), reference.normal);
    Manifold manifold;
    manifold.normal = reference.normal;
    manifold.count = count;
    for (int i = 0; i < count; ++i) {
        manifold.points[i] = {in[i].place - reference.normal * (0.5f * in[i].height), in[i].height, in[i].feature};
    }
    return manifold;
}

Manifold overSecondsFace(const Hull& first, const Hull& second, int face, const RelativePlace& place, float margin) {
    const RelativePlace firstInSecond{place.turn.transposed(), place.turn.transposedTimes(place.offset) * -1.0f};
    Manifold manifold = overFace(second, face, first, firstInSecond, margin);
    manifold.normal = place.turn * manifold.normal * -1.0f;
    for (int i = 0; i < manifold.count; ++i) {
        Manifold::Point& point = manifold.points[i];
        point.place = place.turn * point.place + place.offset;
        point.feature |= kOnSecondsFace;
    }
    return manifold;
}

/// The point between the lines of two edges.
Manifold betweenEdges(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePlace& place,
                      float margin) {
    const HullEdge &edgeA = first.edges[axis.first], &edgeB = second.edges[axis.second];
    const Vec3f a = first.corner(edgeA.from), u = first.corner(edgeA.to) - a;
    const Vec3f b = place.turn * second.corner(edgeB.from) + place.offset;
    const Vec3f v = place.turn * second.corner(edgeB.to) + place.offset - b;
    const Vec3f way = b - a;
    const float uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
    Manifold manifold;
    manifold.normal = axis.normal;
    if (determinant <= 0.0f) return manifold;
    const float s = (dot(u, way) * vv - dot(v, way) * uv) / determinant;
    const float t = (dot(u, way) * uv - dot(v, way) * uu) / determinant;
    const float separation = dot(axis.normal, way);
    if (s < 0.0f || s > 1.0f || t < 0.0f || t > 1.0f || separation > margin) return manifold;
    manifold.count = 1;
    manifold.points[0] = {(a + u * s + b + v * t) * 0.5f, separation,
                          kCutByEdge | kOnSecondsFace | static_cast<std::uint32_t>(axis.first) << 12 | axis.second};
    return manifold;
}

/// The corner that lies farthest along the axis: the first hull's where it touches a face of the second, else the second's.
Manifold::Point cornerAlong(const SeparatingAxis& axis, const Hull& first, const Hull& second,
                            const RelativePlace& place) {
    if (axis.kind == AxisKind::SecondFace) {
        const int corner = first.farthest(axis.normal);
        return {first.corner(corner), 0.0f, kOnSecondsFace | static_cast<std::uint32_t>(corner)};
    }
    const int corner = second.farthest(place.turn.transposedTimes(axis.normal) * -1.0f);
    return {place.turn * second.corner(corner) + place.offset, 0.0f, static_cast<std::uint32_t>(corner)};
}

}  // namespace

Manifold manifoldAlong(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePlace& place,
                       float margin) {
    switch (axis.kind) {
        case AxisKind::FirstFace: return overFace(first, axis.first, second, place, margin);
        case AxisKind::SecondFace: return overSecondsFace(first, second, axis.second, place, margin);
        case AxisKind::Edges: return betweenEdges(axis, first, second, place, margin);
        case AxisKind::None: break;
    }
    return {};
}

Manifold touchingAlong(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePlace& place,
                       float margin) {
    Manifold manifold = manifoldAlong(axis, first, second, place, margin);
    manifold.normal = axis.normal;
    if (manifold.count == 0) {
        manifold.count = 1;
        manifold.points[0] = cornerAlong(axis, first, second, place);
    }
    return manifold;
}

}  // namespace rubble
