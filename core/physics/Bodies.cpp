#include "core/physics/Bodies.h"

#include "core/physics/BroadPhase.h"
#include "core/physics/Contacts.h"
#include "core/physics/Sleeping.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace rubble {
namespace {

constexpr double kUnitTolerance = 1e-3;  // of a rotation's length: it is made a unit

SymMat3f toFloat(const Mat3& m, double scale) {
    const auto at = [&](int column, int row) { return static_cast<float>(m[column][row] * scale); };
    return {at(0, 0), at(1, 0), at(2, 0), at(1, 1), at(2, 1), at(2, 2)};
}

Quatf toFloat(const Quat& q) {
    return Quatf{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)}
        .normalized();
}

Quat toDouble(const Quatf& q) { return Quat(q.w, q.x, q.y, q.z); }

std::uint32_t newBody(WorldState& state) {
    if (state.freeBodies.empty()) {
        state.bodies.emplace_back();
        state.motions.emplace_back();
        state.places.emplace_back();
        state.ahead.emplace_back();
        state.colours.resizeBodies(state.bodies.size());
        return static_cast<std::uint32_t>(state.bodies.size() - 1);
    }
    const std::uint32_t number = state.freeBodies.back();
    state.freeBodies.pop_back();
    return number;
}

/// All that giveMaterial() does but for what depends on the place.
void setMaterial(WorldState& state, std::uint32_t number, const BodyMaterial& material) {
    Body& body = state.bodies[number];
    body.friction = static_cast<float>(material.friction);
    if (body.restitution > 0.0f) --state.bouncyBodies;
    body.restitution = static_cast<float>(material.restitution);
    if (body.restitution > 0.0f) ++state.bouncyBodies;
    if (!body.isDynamic()) return;
    const Shape& shape = *body.shape;
    body.mass = static_cast<float>(shape.mass.volume * material.density);
    body.inertia = toFloat(shape.mass.inertia, material.density);
    body.inverseInertia = toFloat(shape.inverseInertia, 1.0 / material.density);
    body.momentum = body.spinThen = Vec3f(0.0f);  // it is its inertia times its spin again
    state.motions[number].inverseMass = 1.0f / body.mass;
}

}  // namespace

bool isWithin(Vec3 v, double most) {
    return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;  // false for nan
}

std::optional<std::string> faultOf(const Pose& pose, std::string_view what) {
    if (!isWithin(pose.position, kFarthest)) {
        return "The position of " + std::string(what) + " must be within 100 km of the origin.";
    }
    const Quat& turn = pose.orientation;
    const double size = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z + turn.w * turn.w);
    if (!(std::abs(size - 1.0) <= kUnitTolerance)) {
        return "The orientation of " + std::string(what) + " must be a quaternion of length 1.";
    }
    return std::nullopt;
}

std::optional<std::string> faultOf(const BodyDefinition& definition) {
    const auto isNegative = [](double value) { return !(value >= 0.0 && std::isfinite(value)); };
    if (definition.shape == nullptr) return "A body needs a shape.";
    if (const auto fault = faultOf(definition.pose, "a body")) return fault;
    if (!isWithin(definition.velocity, kFastest)) return "The velocity of a body must be below 10 km/s.";
    if (!isWithin(definition.angularVelocity, kFastest))
        return "The angular velocity of a body must be below 10,000 rad/s.";
    if (!(definition.density > 0.0 && std::isfinite(definition.density)))
        return "The density of a body must be positive.";
    if (isNegative(definition.friction)) return "The friction of a body must not be negative.";
    if (!(definition.restitution >= 0.0 && definition.restitution <= 1.0)) {
        return "The restitution of a body must lie between 0 and 1.";
    }
    if (isNegative(definition.linearDamping) || isNegative(definition.angularDamping)) {
        return "The damping of a body must not be negative.";
    }
    return std::nullopt;
}

std::uint32_t addBody(WorldState& state, const BodyDefinition& definition) {
    const std::uint32_t number = newBody(state);
    Body& body = state.bodies[number];
    body = {.shape = definition.shape, .generation = body.generation + 1, .kind = definition.kind};
    body.tag = definition.tag;
    BodyMotion& motion = state.motions[number] = {};
    state.places[number] = {};
    state.ahead[number] = 0.0f;
    state.places[number].reach = definition.shape->reach;
    setMaterial(state, number, definition.material());
    if (definition.kind != BodyKind::Static) {
        motion.velocity = toFloat(definition.velocity);
        motion.spin = toFloat(definition.angularVelocity);
        motion.linearDamping = static_cast<float>(definition.linearDamping);
        motion.angularDamping = static_cast<float>(definition.angularDamping);
    }
    placeBody(state, number, definition.pose);
    addProxies(state, number);
    wakeBody(state, number);
    return number;
}

void giveMaterial(WorldState& state, std::uint32_t number, const BodyMaterial& material) {
    setMaterial(state, number, material);
    BodyPlace& place = state.places[number];
    place.inverseInertia = rotated(state.bodies[number].inverseInertia, place.turn.matrix());
}

void removeBody(WorldState& state, std::uint32_t number) {
    wakeBody(state, number);
    wakeNeighbours(state, number);
    visitContacts(state, number, [&](std::uint32_t contact, std::uint32_t) { removeContact(state, contact); });
    removeProxies(state, number);
    if (state.bodies[number].isAwake) {
        state.awake.erase(std::lower_bound(state.awake.begin(), state.awake.end(), number));
    }
    if (state.grabbed.index == number) state.grabbed = {};
    if (state.bodies[number].restitution > 0.0f) --state.bouncyBodies;
    state.bodies[number] = {.generation = state.bodies[number].generation};
    state.motions[number] = {};
    state.places[number] = {};
    state.freeBodies.push_back(number);
}

void placeBody(WorldState& state, std::uint32_t number, const Pose& pose) {
    const Body& body = state.bodies[number];
    BodyPlace& place = state.places[number];
    const glm::dquat turn = glm::normalize(pose.orientation);
    place.turn = toFloat(turn);
    place.centre = toFloat(pose.position + turn * body.shape->mass.centre);
    place.inverseInertia = rotated(body.inverseInertia, place.turn.matrix());
}

Pose poseOf(const WorldState& state, std::uint32_t number) {
    const BodyPlace& place = state.places[number];
    const Quat turn = glm::normalize(toDouble(place.turn));
    return {toDouble(place.centre) - turn * state.bodies[number].shape->mass.centre, turn};
}

}  // namespace rubble
