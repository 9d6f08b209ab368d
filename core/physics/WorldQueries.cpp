#include "core/physics/HullRay.h"
#include "core/physics/SeparatingAxis.h"
#include "core/physics/Spin.h"
#include "core/physics/World.h"
#include "core/physics/WorldState.h"

#include <algorithm>
#include <cstring>

namespace rubble {
namespace {

bool meetsSegment(const Box& box, Vec3f from, Vec3f way) {
    float begin = 0.0f, end = 1.0f;
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

void addBits(Hasher& hasher, float a, float b) {
    std::uint32_t bits[2];
    const float values[2] = {a + 0.0f, b + 0.0f};  // one zero only
    std::memcpy(bits, values, sizeof bits);
    hasher.add(static_cast<std::uint64_t>(bits[0]) << 32 | bits[1]);
}

}  // namespace

std::optional<RayHit> World::castRay(Vec3 from, Vec3 to) const {
    const WorldState& state = *m_state;
    const Vec3f start = toFloat(from), way = toFloat(to - from);
    RayHit best;
    best.fraction = 2.0;
    state.tree.visitWhere(
        [&](const Box& box) { return meetsSegment(box, start, way); },
        [&](std::uint32_t number) {
            const Proxy& proxy = state.proxies[number];
            const BodyPlace& place = state.places[proxy.body];
            const Mat3f turn = place.turn.matrix();
            const HullEntry hit = entryOf(state.bodies[proxy.body].shape->hulls[proxy.hull],
                                          turn.transposedTimes(start - place.centre), turn.transposedTimes(way));
            const bool isNearer =
                hit.fraction < best.fraction || (hit.fraction == best.fraction && state.idOf(proxy.body) < best.body);
            if (hit.fraction > 1.0f || !isNearer) return;
            best = {state.idOf(proxy.body), from + (to - from) * static_cast<double>(hit.fraction),
                    toDouble(turn * hit.normal), hit.fraction};
        });
    if (best.fraction > 1.0) return std::nullopt;
    return best;
}

Result<std::vector<BodyId>> World::overlapping(const Polytope& polytope, const Pose& pose) const {
    const Result<Hull> hull = makeHull(polytope, Vec3(0.0));
    if (!hull) return hull.error();
    const WorldState& state = *m_state;
    const Quat q = glm::normalize(pose.orientation);
    const Mat3f turn =
        Quatf{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)}
            .matrix();
    const Vec3f centre = toFloat(pose.position), middle = centre + turn * hull->middle;
    const Vec3f half = magnitudes(turn.x) * hull->extents.x + magnitudes(turn.y) * hull->extents.y +
                       magnitudes(turn.z) * hull->extents.z;
    std::vector<BodyId> found;
    state.tree.visitOverlapping({middle - half, middle + half}, [&](std::uint32_t number) {
        const Proxy& proxy = state.proxies[number];
        const BodyPlace& place = state.places[proxy.body];
        const Mat3f other = place.turn.matrix();
        const RelativePlace relative{turn.transposed() * other, turn.transposedTimes(place.centre - centre)};
        const Hull& otherHull = state.bodies[proxy.body].shape->hulls[proxy.hull];
        if (separatingAxis(*hull, otherHull, relative, 0.0f, {}).separation <= 0.0f)
            found.push_back(state.idOf(proxy.body));
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

ContentHash World::hash() const {
    Hasher hasher;
    for (BodyId body : bodies()) {
        const BodyPlace& place = m_state->places[body.index];
        const BodyMotion& motion = m_state->motions[body.index];
        hasher.add(static_cast<std::uint64_t>(body.index) << 1 | (m_state->bodies[body.index].isAwake ? 1u : 0u));
        addBits(hasher, place.centre.x, place.centre.y);
        addBits(hasher, place.centre.z, place.turn.x);
        addBits(hasher, place.turn.y, place.turn.z);
        addBits(hasher, place.turn.w, motion.velocity.x);
        addBits(hasher, motion.velocity.y, motion.velocity.z);
        addBits(hasher, motion.spin.x, motion.spin.y);
        addBits(hasher, motion.spin.z, 0.0f);
    }
    return hasher.digest();
}

Momenta World::momenta() const {
    Momenta sum;
    for (BodyId id : bodies()) {
        const Body& body = m_state->bodies[id.index];
        if (!body.isDynamic()) continue;
        const BodyPlace& place = m_state->places[id.index];
        const BodyMotion& motion = m_state->motions[id.index];
        const Vec3 spin = toDouble(motion.spin), velocity = toDouble(motion.velocity),
                   centre = toDouble(place.centre) + toDouble(body.centreRest);
        const Vec3 turning = toDouble(angularMomentum(*m_state, id.index));
        const double mass = body.mass;
        sum.linear += mass * velocity;
        sum.angular += turning + mass * glm::cross(centre, velocity);
        sum.kinetic += 0.5 * mass * glm::dot(velocity, velocity) + 0.5 * glm::dot(spin, turning);
        sum.potential -= mass * glm::dot(toDouble(m_state->gravity), centre);
    }
    return sum;
}

}  // namespace rubble
