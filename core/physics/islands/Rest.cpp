#include "core/physics/islands/Rest.h"

#include "core/base/Assert.h"

#include <algorithm>

namespace rubble {
namespace {

// Distances are fractions of a fall from rest, g t² / 2: what accelerates by a larger fraction of gravity moves
// farther, whatever its size, and without gravity only what does not move is at rest.
constexpr float kRestTime = 0.5f;        // s
constexpr float kRestSpeed = 0.05f;      // m/s, of any point of a body at rest
constexpr float kRestFraction = 0.001f;  // of a fall, within which a body at rest stays: 1.2 mm on earth
constexpr float kStaySpeed = 1.0f;       // m/s, of any point of a body that stays in one place
constexpr float kStayDistance = 0.02f;   // m, from that place
// Of a fall, within which it stays: 2 cm in 1.28 s on earth. What turns back in the middle of that time moves a quarter
// of what it falls in all of it.
constexpr float kStayFraction = 0.0025f;
constexpr float kSizeFraction = 0.1f;  // of the bounding radius: the largest distance of both
constexpr float kRounding = 1.2e-7f;   // of coordinates, and so of the displacements by contacts
// The stay of what drifts begins again whenever its distance d has grown. What slows down, turns, and accelerates back
// through where it was, goes (growth - 1) d + 2 growth d = 2.3 d before that.
constexpr float kGrowth = 1.1f;
constexpr float kMinToAndFro = 2.4f;  // path of a body that rattles, relative to its distance

/// An upper bound of the length of w × r for the points r of a body, both in its axes. The extents count along each
/// axis: a needle that rolls about its length hardly moves.
float largestArc(Vec3f w, Vec3f extents) {
    const Vec3f a = componentAbs(w), r = extents;
    return length(Vec3f(a.y * r.z + a.z * r.y, a.z * r.x + a.x * r.z, a.x * r.y + a.y * r.x));
}

/// An upper bound of how far a rotation, a vector in world axes, moves the points of a body relative to its centre.
float arcOf(const WorldState& state, std::uint32_t number, Vec3f rotation) {
    const BodyPose& pose = state.poses[number];
    return largestArc(pose.rotation.matrix().transposedTimes(rotation), state.bodies[number].shape->extents);
}

/// Whether both a displacement and a rotation, of a body or per second, move its points by no more than a limit.
bool isWithin(const WorldState& state, std::uint32_t number, Vec3f displacement, Vec3f rotation, float limit) {
    const float radius = state.poses[number].boundingRadius, squared = limit * limit;
    if (lengthSquared(displacement) > squared) return false;
    return lengthSquared(rotation) * radius * radius <= squared || arcOf(state, number, rotation) <= limit;
}

/// Whether no point of a body moves faster than `speed`, m/s.
bool isSlower(const WorldState& state, std::uint32_t number, float speed) {
    const BodyMotion& motion = state.motions[number];
    return isWithin(state, number, motion.velocity, motion.angularVelocity, speed);
}

/// How far a body falls from rest in a time, s.
float fallDistance(const WorldState& state, float time) { return 0.5f * length(state.gravity) * time * time; }

/// The farthest that a body may move in a time, s, which is within a fraction of a fall, and be in the same place.
float maxDistance(const WorldState& state, std::uint32_t number, float time, float fraction) {
    const BodyPose& pose = state.poses[number];
    const Vec3f size = componentAbs(pose.centre);
    const bool isTouching = state.bodies[number].firstContact != kNone;
    const float rounding = isTouching ? kRounding * std::max(size.x, std::max(size.y, size.z)) : 0.0f;
    return std::min(kSizeFraction * pose.boundingRadius, fraction * fallDistance(state, time) + rounding);
}

void beginRest(Body& body) {
    body.restTime = 0.0f;
    body.restDisplacement = body.restRotation = Vec3f(0.0f);
}

void beginStay(Body& body, const BodyPose& pose) {
    body.stayTime = body.stayReach = body.stayPath = 0.0f;
    body.stayCentre = pose.centre;
    body.stayRotation = pose.rotation;
}

void updateRest(WorldState& state, std::uint32_t number, const StepMovement& movement, float dt) {
    Body& body = state.bodies[number];
    if (!isSlower(state, number, kRestSpeed)) return beginRest(body);
    body.restTime += dt;
    body.restDisplacement += movement.displacement;
    body.restRotation += movement.rotation;
    const float limit = maxDistance(state, number, kRestTime, kRestFraction);
    if (!isWithin(state, number, body.restDisplacement, body.restRotation, limit)) beginRest(body);
}

void updateStay(WorldState& state, std::uint32_t number, const StepMovement& movement, float dt) {
    Body& body = state.bodies[number];
    const BodyPose& pose = state.poses[number];
    if (!isSlower(state, number, kStaySpeed)) return beginStay(body, pose);
    const Vec3f rotated = (body.stayRotation.conjugate() * pose.rotation).vector() * 2.0f;  // in its axes
    const float distance = std::max(length(pose.centre - body.stayCentre), largestArc(rotated, body.shape->extents));
    if (distance > std::min(kStayDistance, kSizeFraction * pose.boundingRadius)) return beginStay(body, pose);
    if (distance > kGrowth * body.stayReach) {
        body.stayTime = body.stayPath = 0.0f;
        body.stayReach = distance;
    }
    body.stayTime += dt;
    body.stayPath += std::max(length(movement.displacement), arcOf(state, number, movement.rotation));
}

/// Whether a body goes to and fro in one place: the path of one that drifts is as long as its distance.
bool rattles(const WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    return body.stayTime >= kRestTime && body.stayReach > 0.0f && body.stayPath >= kMinToAndFro * body.stayReach &&
           body.stayReach <= maxDistance(state, number, body.stayTime, kStayFraction);
}

}  // namespace

StepMovement movementOf(const BodyMotion& motion) {
    return {motion.deltaPosition, motion.deltaRotation.vector() * 2.0f};
}

void updateRestTime(WorldState& state, std::uint32_t number, const StepMovement& movement, float dt) {
    const Body& body = state.bodies[number];
    RUBBLE_ASSERT(body.isAwake);
    if (!body.isDynamic()) return;
    updateRest(state, number, movement, dt);
    if (body.restTime < kRestTime) updateStay(state, number, movement, dt);
}

void restartRest(WorldState& state, std::uint32_t number) {
    beginRest(state.bodies[number]);
    beginStay(state.bodies[number], state.poses[number]);
}

void interruptRest(WorldState& state, std::uint32_t number) { beginRest(state.bodies[number]); }

void setAtRest(WorldState& state, std::uint32_t number) { state.bodies[number].restTime = kRestTime; }

bool isAtRest(const WorldState& state, std::uint32_t number) {
    return state.bodies[number].restTime >= kRestTime || rattles(state, number);
}

}  // namespace rubble
