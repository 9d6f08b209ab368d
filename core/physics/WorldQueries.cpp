#include "core/physics/Bodies.h"
#include "core/physics/BroadPhase.h"
#include "core/physics/HullCast.h"
#include "core/physics/HullRay.h"
#include "core/physics/NarrowPhase.h"
#include "core/physics/SeparatingAxis.h"
#include "core/physics/World.h"
#include "core/physics/WorldState.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

/// Whether the first `end` of a segment meets a box.
bool meetsSegment(const Box& box, Vec3f from, Vec3f way, float end) {
    float begin = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0.0f) {
            if (from[axis] < box.low[axis] || from[axis] > box.high[axis]) return false;
            continue;
        }
        float near = (box.low[axis] - from[axis]) / way[axis], far = (box.high[axis] - from[axis]) / way[axis];
        if (near > far) std::swap(near, far);
        begin = std::max(begin, near);
        end = std::min(end, far);
    }
    return begin <= end;
}

/// A convex polytope that bodies are held against.
struct Probe {
    Hull hull;
    BodyPlace place;
};

Result<Probe> probeOf(const Polytope& polytope, const Pose& pose) {
    if (const std::optional<std::string> fault = faultOf(pose, "the hull")) return Error{ErrorCode::BadInput, *fault};
    Result<Hull> hull = makeHull(polytope, Vec3(0.0));
    if (!hull) return hull.error();
    const Quat& q = pose.orientation;
    const Quatf turn{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                     static_cast<float>(q.w)};
    return Probe{std::move(*hull), {.centre = toFloat(pose.position), .turn = turn.normalized()}};
}

constexpr double kNowhere = 2.0;  // CastHit::fraction of what meets nothing

/// Of bodies that are met at once, the one with the lowest index is taken.
bool comesBefore(float fraction, BodyId body, const CastHit& best) {
    return fraction <= 1.0f && (fraction < best.fraction || (fraction == best.fraction && body < best.body));
}

float endOf(const CastHit& best) { return std::min(1.0f, static_cast<float>(best.fraction)); }

std::optional<CastHit> hitOrNothing(const CastHit& best) {
    return best.fraction == kNowhere ? std::nullopt : std::optional(best);
}

}  // namespace

std::optional<CastHit> World::castRay(Vec3 from, Vec3 to) const {
    const WorldState& state = *m_state;
    const Vec3f start = toFloat(from), way = toFloat(to - from);
    CastHit best{.fraction = kNowhere};
    state.tree.visitWhere([&](const Box& box) { return meetsSegment(box, start, way, endOf(best)); },
                          [&](std::uint32_t number, const Box&) {
                              const Proxy& proxy = state.proxies[number];
                              const BodyPlace& place = state.places[proxy.body];
                              const Mat3f turn = place.turn.matrix();
                              const HullEntry hit =
                                  entryOf(hullOf(state, proxy), turn.transposedTimes(start - place.centre),
                                          turn.transposedTimes(way));
                              if (!comesBefore(hit.fraction, state.idOf(proxy.body), best)) return;
                              best = {state.idOf(proxy.body), from + (to - from) * static_cast<double>(hit.fraction),
                                      toDouble(turn * hit.normal), hit.fraction};
                          });
    return hitOrNothing(best);
}

Result<std::optional<CastHit>> World::castHull(const Polytope& polytope, const Pose& pose, Vec3 way) const {
    if (!isWithin(way, 2.0 * kFarthest)) {
        return Error{ErrorCode::BadInput,
                     "The way of the hull must be finite and at most 200 km long along each axis."};
    }
    const Result<Probe> probe = probeOf(polytope, pose);
    if (!probe) return probe.error();
    const WorldState& state = *m_state;
    const Mat3f turn = probe->place.turn.matrix();
    const Vec3f wayWorld = toFloat(way), wayLocal = turn.transposedTimes(wayWorld);
    const Box box = tightBox(probe->hull, probe->place);
    const Vec3f half = (box.high - box.low) * 0.5f;
    CastHit best{.fraction = kNowhere};
    state.tree.visitWhere(
        [&](const Box& other) {
            return meetsSegment({other.low - half, other.high + half}, box.middle(), wayWorld, endOf(best));
        },
        [&](std::uint32_t number, const Box&) {
            const Proxy& proxy = state.proxies[number];
            const HullMeeting met = meetingOf(probe->hull, hullOf(state, proxy),
                                              relativePlace(probe->place, state.places[proxy.body]), wayLocal);
            if (!comesBefore(met.fraction, state.idOf(proxy.body), best)) return;
            const auto fraction = static_cast<double>(met.fraction);
            best = {state.idOf(proxy.body), pose.position + way * fraction + toDouble(turn * met.point),
                    toDouble(turn * met.normal), fraction};
        });
    return hitOrNothing(best);
}

Result<std::vector<BodyId>> World::overlapping(const Polytope& polytope, const Pose& pose) const {
    const Result<Probe> probe = probeOf(polytope, pose);
    if (!probe) return probe.error();
    const WorldState& state = *m_state;
    std::vector<BodyId> found;
    state.tree.visitOverlapping(tightBox(probe->hull, probe->place), [&](std::uint32_t number, const Box&) {
        const Proxy& proxy = state.proxies[number];
        const RelativePlace place = relativePlace(probe->place, state.places[proxy.body]);
        if (separatingAxis(probe->hull, hullOf(state, proxy), place, 0.0f, {}).separation <= 0.0f)
            found.push_back(state.idOf(proxy.body));
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace rubble
