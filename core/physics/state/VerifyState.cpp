#include "core/physics/state/VerifyState.h"

#include "core/physics/state/VerifyBody.h"
#include "core/physics/state/VerifyContacts.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

using Place = std::optional<std::string>;

bool isUnit(const Quatf& q) {
    const float square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
    return std::abs(square - 1.0f) <= static_cast<float>(2.0 * kUnitTolerance);
}

bool isZero(Vec3f v) { return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f; }

/// The placeholder in empty lanes must never move.
Place verifyPlaceholder(const WorldState& state) {
    const Body& body = state.bodies[0];
    const BodyMotion& motion = state.motions[0];
    const bool isPlain = body.shape == nullptr && body.kind == BodyKind::Static && !body.isAwake;
    if (!isPlain || motion.inverseMass != 0.0f || !isZero(motion.velocity) || !isZero(motion.angularVelocity)) {
        return "bodies[0]";
    }
    return std::nullopt;
}

/// The field of a living body that is out of range.
const char* faultyField(const WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    const BodyPose& pose = state.poses[number];
    const BodyMotion& motion = state.motions[number];
    if (body.kind > BodyKind::Dynamic) return "kind";
    if (body.isDynamic() ? body.mass <= 0.0f || motion.inverseMass != 1.0f / body.mass
                         : body.mass != 0.0f || motion.inverseMass != 0.0f) {
        return "mass";
    }
    if (body.friction < 0.0f) return "friction";
    if (body.restitution < 0.0f || body.restitution > 1.0f) return "restitution";
    if (body.kind == BodyKind::Static && body.isAwake) return "isAwake";
    if (body.kind == BodyKind::Kinematic && !body.isAwake) return "isAwake";
    if ((body.isDynamic() && !body.isAwake) != (body.sleepingIsland != kNone)) return "sleepingIsland";
    if (!isUnit(pose.rotation) || !isUnit(body.stayRotation)) return "rotation";
    if (!isWithin(toDouble(pose.centre), kMaxCoordinate)) return "centre";
    if (pose.boundingRadius != body.shape->boundingRadius) return "boundingRadius";
    return nullptr;
}

Place verifyBodies(const WorldState& state) {
    const std::size_t count = state.bodies.size();
    if (count == 0) return "bodies";
    if (state.motions.size() != count) return "motions";
    if (state.poses.size() != count) return "poses";
    if (state.predictedTravel.size() != count) return "predictedTravel";
    if (state.predictions.size() != count) return "predictions";
    if (state.obstacleSizes.size() != count) return "obstacleSizes";
    if (Place fault = verifyPlaceholder(state)) return fault;
    std::vector<bool> isFree(count, false);
    std::size_t bouncy = 0, compound = 0;
    for (std::uint32_t number = 1; number < count; ++number) {
        const Body& body = state.bodies[number];
        isFree[number] = body.shape == nullptr;
        if (isFree[number]) {
            const bool isEmpty = body.kind == BodyKind::Static && !body.isAwake && body.firstContact == kNone &&
                                 body.firstProxy == kNone && body.sleepingIsland == kNone;
            if (!isEmpty) return placeIn("bodies", number);
            continue;
        }
        if (const char* field = faultyField(state, number)) return placeIn("bodies", number, field);
        bouncy += body.restitution > 0.0f ? 1 : 0;
        compound += body.shape->hulls.size() > 1 ? 1 : 0;
    }
    if (bouncy != state.bouncyBodies) return "bouncyBodies";
    if (compound != state.compoundBodies) return "compoundBodies";
    return verifyFree("freeBodies", state.freeBodies, isFree);
}

/// Bodies that are awake must be in the list of those, or in that of those that woke since.
Place verifyAwake(const WorldState& state) {
    const bool isCurrent = state.woken.empty() && !state.hasRemovedAwake;
    std::vector<bool> isListed(state.bodies.size(), false);
    for (std::size_t k = 0; k < state.awake.size(); ++k) {
        const std::uint32_t body = state.awake[k];
        const bool isThere = body > 0 && body < state.bodies.size();
        if (!isThere || (k > 0 && state.awake[k - 1] >= body)) return placeIn("awake", k);
        if (isCurrent && !state.bodies[body].isAwake) return placeIn("awake", k);
        isListed[body] = true;
    }
    for (std::size_t k = 0; k < state.woken.size(); ++k) {
        const std::uint32_t body = state.woken[k];
        if (body == 0 || body >= state.bodies.size()) return placeIn("woken", k);
        isListed[body] = true;
    }
    for (std::size_t body = 1; body < state.bodies.size(); ++body) {
        if (state.bodies[body].isAwake && !isListed[body]) return placeIn("bodies", body, "isAwake");
    }
    for (std::size_t k = 0; k < state.rebox.size(); ++k) {
        if (state.rebox[k] == 0 || state.rebox[k] >= state.bodies.size()) return placeIn("rebox", k);
    }
    return std::nullopt;
}

/// Each body has a proxy for each of its hulls.
Place verifyProxies(const WorldState& state) {
    std::vector<bool> isFree(state.proxies.size(), true);
    std::vector<std::uint32_t> leafOf(state.proxies.size(), kNone);
    for (std::uint32_t number = 1; number < state.bodies.size(); ++number) {
        const Body& body = state.bodies[number];
        if (body.shape == nullptr) continue;
        std::vector<bool> hasProxy(body.shape->hulls.size(), false);
        std::size_t count = 0;
        for (std::uint32_t k = body.firstProxy; k != kNone; k = state.proxies[k].next) {
            if (k >= state.proxies.size() || !isFree[k]) return placeIn("bodies", number, "firstProxy");
            const Proxy& proxy = state.proxies[k];
            if (proxy.body != number) return placeIn("proxies", k, "body");
            if (proxy.hull >= hasProxy.size() || hasProxy[proxy.hull]) return placeIn("proxies", k, "hull");
            if (proxy.leaf == kNone) return placeIn("proxies", k, "leaf");
            hasProxy[proxy.hull] = true;
            isFree[k] = false;
            leafOf[k] = proxy.leaf;
            ++count;
        }
        if (count != hasProxy.size()) return placeIn("bodies", number, "firstProxy");
    }
    for (std::size_t k = 0; k < isFree.size(); ++k) {
        const auto& [body, hull, leaf, next] = state.proxies[k];
        if (isFree[k] && (body != kNone || hull != 0 || leaf != kNone || next != kNone)) return placeIn("proxies", k);
    }
    if (Place fault = verifyFree("freeProxies", state.freeProxies, isFree)) return fault;
    const Place fault = state.tree.verifyTree(leafOf);
    return fault ? "tree." + *fault : fault;
}

Place verifyGrab(const WorldState& state) {
    const std::uint32_t body = state.grabbed.index;
    if (body == 0) return std::nullopt;
    const bool isThere = body < state.bodies.size() && state.bodies[body].isDynamic() &&
                         state.bodies[body].generation == state.grabbed.generation;
    return isThere && state.grabForce >= 0.0f ? Place() : Place("grabbed");
}

}  // namespace

Place verifyState(const WorldState& state) {
    if (!isWithin(toDouble(state.gravity), kMaxSpeed)) return "gravity";
    for (const auto verify : {verifyBodies, verifyAwake, verifyProxies, verifyGrab, verifyContacts}) {
        if (Place fault = verify(state)) return fault;
    }
    return std::nullopt;
}

}  // namespace rubble
