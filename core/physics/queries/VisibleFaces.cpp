#include "core/physics/queries/VisibleFaces.h"

#include "core/physics/broadphase/DynamicBoxTree.h"
#include "core/physics/state/WorldState.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rubble {
namespace {

constexpr float kBoxMargin = 1e-4f;  // m: of boxes, for rounding

/// A hull as seen from the viewpoint.
struct SeenHull {
    std::uint32_t body = 0;
    ShadowVolume volume;
};

Box boxOf(const FacePolygon& polygon) {
    Box box{toFloat(polygon[0]), toFloat(polygon[0])};
    for (Vec3 corner : polygon) box = joined(box, {toFloat(corner), toFloat(corner)});
    return box;
}

/// The box of the faces turned to the viewpoint: a line of sight enters the hull through one of them.
Box boxOf(const ShadowVolume& volume) {
    Box box = boxOf(volume.faces[0]);
    for (const FacePolygon& face : volume.faces) box = joined(box, boxOf(face));
    return widened(box, kBoxMargin);
}

/// Whether a line of sight to a point of `target` may pass through `box`: whether `target`, shrunk towards the
/// viewpoint, overlaps it at any scale.
bool isBefore(const Box& box, const Box& target) {
    float least = 0.0f, most = 1.0f;
    const auto require = [&](float slope, float limit) {  // scale * slope <= limit
        if (slope > 0.0f) most = std::min(most, limit / slope);
        if (slope < 0.0f) least = std::max(least, limit / slope);
        if (slope == 0.0f && limit < 0.0f) most = -1.0f;
    };
    for (int axis = 0; axis < 3; ++axis) {
        require(target.low[axis], box.high[axis]);
        require(-target.high[axis], -box.low[axis]);
    }
    return least <= most;
}

Vec3 centroidOf(const FacePolygon& polygon) {
    Vec3 sum(0.0);
    for (Vec3 corner : polygon) sum += corner;
    return sum / static_cast<double>(polygon.size());
}

/// The plane through the middle of a box, across its longest side.
Plane middlePlane(const Box& box) {
    const Vec3f sides = box.high - box.low;
    int axis = sides.x >= sides.y ? 0 : 1;
    if (sides.z > sides[axis]) axis = 2;
    Vec3 normal(0.0);
    normal[axis] = 1.0;
    return {normal, static_cast<double>(box.middle()[axis])};
}

/// The part of a face within the cube around the viewpoint that contains all within the radius. The ground is large.
FacePolygon clippedToCube(FacePolygon face, double radius) {
    for (int side = 0; side < 6 && face.size() >= 3; ++side) {
        Vec3 normal(0.0);
        normal[side % 3] = side < 3 ? 1.0 : -1.0;
        const auto isOutside = [&](Vec3 corner) { return glm::dot(normal, corner) > radius; };
        if (std::ranges::any_of(face, isOutside)) face = split(face, {normal, radius}).behind;
    }
    return face;
}

class VisibleFaces {
public:
    VisibleFaces(const WorldState& state, Vec3 viewpoint, double radius) : m_radius(radius) {
        for (std::uint32_t body = 1; body < state.bodies.size(); ++body) {
            if (state.bodies[body].shape) addBody(state, body, viewpoint, radius);
        }
        m_tree.update();
    }

    std::size_t comparisons() const { return m_comparisons; }

    void visit(const VisitVisiblePart& visit) {
        for (std::uint32_t hull = 0; hull < m_hulls.size(); ++hull) {
            for (const FacePolygon& face : m_hulls[hull].volume.faces) {
                const FacePolygon near = clippedToCube(face, m_radius);
                if (near.size() >= 3) visitFace(hull, near, 0, visit);
            }
        }
    }

private:
    void addBody(const WorldState& state, std::uint32_t body, Vec3 viewpoint, double radius) {
        const Shape& shape = *state.bodies[body].shape;
        const Vec3 centre = toDouble(state.poses[body].centre) - viewpoint;
        if (glm::length(centre) > radius + static_cast<double>(shape.boundingRadius)) return;
        const Mat3 rotation = glm::mat3_cast(glm::normalize(toDouble(state.poses[body].rotation)));
        for (const PlacedHull& hull : shape.hulls) {
            ShadowVolume volume = shadowVolumeOf(*hull.hull, rotation, centre + rotation * toDouble(hull.offset));
            if (volume.faces.empty()) continue;
            m_tree.insert(boxOf(volume), static_cast<std::uint32_t>(m_hulls.size()));
            m_hulls.push_back({body, std::move(volume)});
        }
    }

    void visitFace(std::uint32_t hull, const FacePolygon& face, int halvings, const VisitVisiblePart& visit) {
        m_isLast = halvings == kMaxHalvings;
        findVisibleParts(hull, face);
        if (m_parts.size() <= kMaxVisibleParts || halvings == kMaxHalvings) {
            for (const FacePolygon& part : m_parts) visit(m_hulls[hull].body, part);
            return;
        }
        const SplitPolygon halves = split(face, middlePlane(boxOf(face)));
        for (const FacePolygon* half : {&halves.front, &halves.behind}) {
            if (half->size() >= 3) visitFace(hull, *half, halvings + 1, visit);
        }
    }

    /// In heaps most hidden faces are hidden by one hull alone, which is found without dividing them.
    void findVisibleParts(std::uint32_t hull, const FacePolygon& face) {
        m_parts.assign(1, face);
        const Box target = boxOf(face);
        visitHullsBefore(hull, target, [&](const ShadowVolume& volume) {
            if (isHidden(volume, face)) m_parts.clear();
        });
        visitHullsBefore(hull, target, [&](const ShadowVolume& volume) { hideBehind(volume); });
    }

    /// Visits the hulls that may hide a face of a hull, until all of it is hidden or it must be halved.
    template <class Visit>
    void visitHullsBefore(std::uint32_t hull, const Box& target, const Visit& visit) {
        m_tree.visitIf([&](const Box& box) { return !isDone() && isBefore(box, target); },
                       [&](std::uint32_t other, const Box&) {
                           if (other == hull) return;
                           ++m_comparisons;
                           visit(m_hulls[other].volume);
                       });
    }

    bool isDone() const { return m_parts.empty() || (m_parts.size() > kMaxVisibleParts && !m_isLast); }

    void hideBehind(const ShadowVolume& volume) {
        m_left.clear();
        const bool isDivided = m_parts.size() > kMaxVisibleParts;
        for (FacePolygon& part : m_parts) {
            const bool isWhole =
                isDivided ? !isHidden(volume, centroidOf(part)) : !subtractShadow(part, volume, m_left);
            if (isWhole) m_left.push_back(std::move(part));
        }
        std::swap(m_parts, m_left);
    }

    double m_radius;
    std::vector<SeenHull> m_hulls;
    std::size_t m_comparisons = 0;
    bool m_isLast = false;             // whether the current face is not to be halved
    DynamicBoxTree m_tree;             // of the hulls
    std::vector<FacePolygon> m_parts;  // visible ones of the current face
    std::vector<FacePolygon> m_left;   // scratch of hideBehind()
};

}  // namespace

std::size_t visitVisibleFaces(const WorldState& state, Vec3 viewpoint, double radius, const VisitVisiblePart& visit) {
    VisibleFaces faces(state, viewpoint, radius);
    faces.visit(visit);
    return faces.comparisons();
}

}  // namespace rubble
