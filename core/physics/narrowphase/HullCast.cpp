#include "core/physics/narrowphase/HullCast.h"

#include "core/physics/narrowphase/Manifold.h"

namespace rubble {
namespace {

// Corners within this distance of the first to impact belong to the contact: those of a face impacting flat, up to
// rounding.
constexpr float kContactDepth = 1e-3f;  // m

Vec3f centroidOf(const Manifold& manifold) {
    Vec3f sum(0.0f);
    for (int i = 0; i < manifold.count; ++i) sum += manifold.points[i].position;
    return sum * (1.0f / static_cast<float>(manifold.count));
}

}  // namespace

HullCastHit castHull(const Hull& first, const Hull& second, const RelativePose& pose, Vec3f displacement) {
    TimeOfImpact impact{separatingAxis(first, second, pose, 0.0f, {}), 0.0f};
    if (impact.axis.separation > 0.0f) impact = timeOfImpact(first, second, pose, displacement * -1.0f);
    if (impact.axis.kind == AxisKind::None) return {};
    const RelativePose poseAtImpact{pose.rotation, pose.offset - displacement * impact.fraction};
    const Manifold manifold =
        touchingManifold(impact.axis, first, second, poseAtImpact, impact.axis.separation + kContactDepth);
    return {impact.fraction, centroidOf(manifold), impact.axis.normal * -1.0f};
}

}  // namespace rubble
