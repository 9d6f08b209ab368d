#include "core/physics/narrowphase/HullCollision.h"

#include <algorithm>

namespace rubble {
namespace {

/// Collides along one face. True if no other axis has to be tested: the face separates the hulls, or a point of one
/// lies so near above the face that no other axis can separate them by clearly more, and the hulls have been tested
/// before (`isKnown`) or do not overlap along it.
bool collideAlongFace(const SeparatingAxis& face, const Hull& first, const Hull& second, const RelativePose& pose,
                      float margin, Vec3f turn, bool isKnown, HullCollision& collision) {
    constexpr float kClearly = 2.0f * kAxisPreference;
    collision.axis = face;
    collision.manifold = {};
    if (face.separation > margin) return true;
    collision.manifold = manifoldAlong(face, first, second, pose, margin, turn);
    const float enough = face.separation + kClearly;
    const auto isNear = [&](const Manifold::Point& point) { return point.separation <= enough; };
    return (isKnown || face.separation >= -kTouchingOverlap) && enough >= 0.0f &&
           std::any_of(collision.manifold.points.begin(), collision.manifold.points.begin() + collision.manifold.count,
                       isNear);
}

bool isSameFace(const SeparatingAxis& a, const SeparatingAxis& b) {
    return a.kind == b.kind && a.first == b.first && a.second == b.second;
}

/// Gives hulls that overlap a point as deep as they do, where their axis leads to none: along a face that is preferred
/// to crossing edges, these need not lie over it.
void addMissingPoint(HullCollision& collision, const Hull& first, const Hull& second, const RelativePose& pose,
                     float margin) {
    constexpr float kNoticeable = 0.0005f;  // m
    if (collision.axis.separation > -kNoticeable || isReached(collision.manifold, collision.axis.separation)) return;
    if (collision.axis.isFace()) {
        const SeparatingAxis edges = bestEdgeAxis(collision.axis, first, second, pose, margin, 0.0f);
        if (edges.kind == AxisKind::Edges) {
            collision.axis = edges;
            collision.manifold = manifoldAlong(edges, first, second, pose, margin);
        }
    }
    Manifold& manifold = collision.manifold;
    if (isReached(manifold, collision.axis.separation)) return;
    Manifold::Point point = supportingCorner(collision.axis, first, second, pose);
    point.separation = collision.axis.separation;
    manifold.normal = collision.axis.normal;
    manifold.count = std::min(manifold.count + 1, kMaxManifoldPoints);
    manifold.points[static_cast<std::size_t>(manifold.count - 1)] = point;
}

}  // namespace

HullCollision collideHulls(const Hull& first, const Hull& second, const RelativePose& pose, float margin,
                           const SeparatingAxis& guess, Vec3f turn) {
    HullCollision collision;
    collision.offset = pose.offset;
    const bool isKnown = guess.kind != AxisKind::None;
    collision.axis = guess.kind == AxisKind::None ? initialGuess(first, second, pose) : guess;
    if (collision.axis.isFace() && collideAlongFace(faceAxis(collision.axis, first, second, pose), first, second, pose,
                                                    margin, turn, isKnown, collision)) {
        return collision;
    }
    const SeparatingAxis face = bestFaceAxis(first, second, pose, margin, collision.axis);
    if (!isSameFace(face, collision.axis) &&
        collideAlongFace(face, first, second, pose, margin, turn, isKnown, collision))
        return collision;
    collision.axis = bestEdgeAxis(face, first, second, pose, margin);
    if (collision.axis.kind == AxisKind::Edges) {
        const bool isNear = collision.axis.separation <= margin;
        collision.manifold = isNear ? manifoldAlong(collision.axis, first, second, pose, margin) : Manifold{};
    }
    addMissingPoint(collision, first, second, pose, margin);
    return collision;
}

}  // namespace rubble
