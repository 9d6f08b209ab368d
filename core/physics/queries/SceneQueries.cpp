#include "core/physics/queries/SceneQueries.h"

#include "core/physics/narrowphase/HullCast.h"
#include "core/physics/narrowphase/HullRay.h"
#include "core/physics/narrowphase/SeparatingAxis.h"
#include "core/physics/state/VerifyBody.h"
#include "core/physics/step/BroadPhase.h"
#include "core/physics/step/NarrowPhase.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

/// Whether the part of a segment up to the fraction `end` intersects a box.
bool intersectsSegment(const Box& box, Vec3f from, Vec3f displacement, float end) {
    float begin = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        if (displacement[axis] == 0.0f) {
            if (from[axis] < box.low[axis] || from[axis] > box.high[axis]) return false;
            continue;
        }
        float near = (box.low[axis] - from[axis]) / displacement[axis],
              far = (box.high[axis] - from[axis]) / displacement[axis];
        if (near > far) std::swap(near, far);
        begin = std::max(begin, near);
        end = std::min(end, far);
    }
    return begin <= end;
}

/// The polytope of a query.
struct QueryHull {
    Hull hull;
    BodyPose pose;
};

Result<QueryHull> makeQueryHull(const Polytope& polytope, const Pose& pose) {
    if (const std::optional<std::string> fault = verifyPose(pose, "the hull"))
        return Error{ErrorCode::BadInput, *fault};
    Result<Hull> hull = makeHull(polytope, Vec3(0.0));
    if (!hull) return hull.error();
    return QueryHull{std::move(*hull), {.centre = toFloat(pose.position), .rotation = toFloat(pose.orientation)}};
}

constexpr double kNoHit = 2.0;  // CastHit::fraction of a miss

/// Of bodies hit at the same fraction, the one with the lowest index is first.
bool isBefore(float fraction, BodyId body, const CastHit& best) {
    return fraction <= 1.0f && (fraction < best.fraction || (fraction == best.fraction && body < best.body));
}

float endOf(const CastHit& best) { return std::min(1.0f, static_cast<float>(best.fraction)); }

std::optional<CastHit> hitOrNothing(const CastHit& best) {
    return best.fraction == kNoHit ? std::nullopt : std::optional(best);
}

}  // namespace

std::optional<CastHit> castRay(const WorldState& state, Vec3 from, Vec3 to) {
    const Vec3f start = toFloat(from), displacement = toFloat(to - from);
    CastHit best{.fraction = kNoHit};
    state.tree.visitIf([&](const Box& box) { return intersectsSegment(box, start, displacement, endOf(best)); },
                       [&](std::uint32_t number, const Box&) {
                           const Proxy& proxy = state.proxies[number];
                           const BodyPose& pose = state.poses[proxy.body];
                           const Mat3f rotation = pose.rotation.matrix();
                           const PlacedHull& placed = placedHullOf(state, proxy);
                           const HullRayHit hit =
                               castRay(*placed.hull, rotation.transposedTimes(start - pose.centre) - placed.offset,
                                       rotation.transposedTimes(displacement));
                           if (!isBefore(hit.fraction, state.idOf(proxy.body), best)) return;
                           best = {state.idOf(proxy.body), from + (to - from) * static_cast<double>(hit.fraction),
                                   toDouble(rotation * hit.normal), hit.fraction};
                       });
    return hitOrNothing(best);
}

Result<std::optional<CastHit>> castHull(const WorldState& state, const Polytope& polytope, const Pose& pose,
                                        Vec3 displacement) {
    if (!isWithin(displacement, 2.0 * kMaxCoordinate)) {
        return Error{ErrorCode::BadInput,
                     "The displacement of the hull must be finite and at most 200 km long along each axis."};
    }
    const Result<QueryHull> query = makeQueryHull(polytope, pose);
    if (!query) return query.error();
    const Mat3f rotation = query->pose.rotation.matrix();
    const Vec3f displacementWorld = toFloat(displacement),
                displacementLocal = rotation.transposedTimes(displacementWorld);
    const Box box = tightBox({&query->hull}, query->pose);
    const Vec3f half = (box.high - box.low) * 0.5f;
    CastHit best{.fraction = kNoHit};
    state.tree.visitIf(
        [&](const Box& other) {
            return intersectsSegment({other.low - half, other.high + half}, box.middle(), displacementWorld,
                                     endOf(best));
        },
        [&](std::uint32_t number, const Box&) {
            const Proxy& proxy = state.proxies[number];
            const PlacedHull& placed = placedHullOf(state, proxy);
            const RelativePose relative = relativePose(query->pose, {}, state.poses[proxy.body], placed.offset);
            const HullCastHit cast = castHull(query->hull, *placed.hull, relative, displacementLocal);
            if (!isBefore(cast.fraction, state.idOf(proxy.body), best)) return;
            const auto fraction = static_cast<double>(cast.fraction);
            best = {state.idOf(proxy.body), pose.position + displacement * fraction + toDouble(rotation * cast.point),
                    toDouble(rotation * cast.normal), fraction};
        });
    return hitOrNothing(best);
}

Result<std::vector<BodyId>> overlappingBodies(const WorldState& state, const Polytope& polytope, const Pose& pose) {
    const Result<QueryHull> query = makeQueryHull(polytope, pose);
    if (!query) return query.error();
    std::vector<BodyId> found;
    state.tree.visitOverlapping(tightBox({&query->hull}, query->pose), [&](std::uint32_t number, const Box&) {
        const Proxy& proxy = state.proxies[number];
        const PlacedHull& placed = placedHullOf(state, proxy);
        const RelativePose relative = relativePose(query->pose, {}, state.poses[proxy.body], placed.offset);
        if (separatingAxis(query->hull, *placed.hull, relative, 0.0f, {}).separation <= 0.0f)
            found.push_back(state.idOf(proxy.body));
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace rubble
