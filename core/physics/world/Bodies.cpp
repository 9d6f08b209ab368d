#include "core/physics/world/Bodies.h"

#include "core/base/Assert.h"
#include "core/physics/islands/Sleeping.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/state/VerifyBody.h"
#include "core/physics/step/BroadPhase.h"

#include <algorithm>

namespace rubble {
namespace {

std::uint32_t newBody(WorldState& state) {
    if (state.freeBodies.empty()) {
        state.bodies.emplace_back();
        state.motions.emplace_back();
        state.poses.emplace_back();
        state.predictedTravel.emplace_back();
        state.predictions.emplace_back();
        state.obstacleSizes.emplace_back();
        state.colours.resizeBodies(state.bodies.size());
        return static_cast<std::uint32_t>(state.bodies.size() - 1);
    }
    const std::uint32_t number = state.freeBodies.back();
    state.freeBodies.pop_back();
    return number;
}

/// setMaterial() without what depends on the pose.
void assignMaterial(WorldState& state, std::uint32_t number, const BodyMaterial& material) {
    Body& body = state.bodies[number];
    body.friction = static_cast<float>(material.friction);
    if (body.restitution > 0.0f) --state.bouncyBodies;
    body.restitution = static_cast<float>(material.restitution);
    if (body.restitution > 0.0f) ++state.bouncyBodies;
    if (!body.isDynamic()) return;
    const Shape& shape = *body.shape;
    body.mass = static_cast<float>(shape.mass.volume * material.density);
    body.inertia = toFloat(shape.inertia * material.density);
    body.inverseInertia = toFloat(shape.inverseInertia * (1.0 / material.density));
    body.angularMomentum = body.referenceAngularVelocity = Vec3f(0.0f);  // computed from the angular velocity again
    state.motions[number].inverseMass = 1.0f / body.mass;
}

}  // namespace

std::uint32_t addBody(WorldState& state, const BodyDefinition& definition) {
    const std::uint32_t number = addUnplacedBody(state, definition);
    setPose(state, number, definition.pose);
    addProxies(state, number);
    return number;
}

std::uint32_t addUnplacedBody(WorldState& state, const BodyDefinition& definition) {
    RUBBLE_ASSERT(!verifyBodyDefinition(definition));
    const std::uint32_t number = newBody(state);
    Body& body = state.bodies[number];
    body = {.shape = definition.shape, .generation = body.generation + 1, .kind = definition.kind};
    body.tag = definition.tag;
    body.isBullet = definition.isBullet;
    if (body.shape->hulls.size() > 1) ++state.compoundBodies;
    BodyMotion& motion = state.motions[number] = {};
    state.poses[number] = {};
    state.predictedTravel[number] = 0.0f;
    state.predictions[number] = {};
    state.obstacleSizes[number] = kStands;
    state.poses[number].boundingRadius = definition.shape->boundingRadius;
    assignMaterial(state, number, definition.material());
    if (definition.kind != BodyKind::Static) {
        motion.velocity = toFloat(definition.velocity);
        motion.angularVelocity = toFloat(definition.angularVelocity);
        motion.linearDamping = static_cast<float>(definition.linearDamping);
        motion.angularDamping = static_cast<float>(definition.angularDamping);
    }
    wakeBody(state, number);
    return number;
}

void setMaterial(WorldState& state, std::uint32_t number, const BodyMaterial& material) {
    RUBBLE_ASSERT(!verifyMaterial(material, *state.bodies[number].shape, state.bodies[number].kind));
    assignMaterial(state, number, material);
    BodyPose& pose = state.poses[number];
    pose.inverseInertia = rotated(state.bodies[number].inverseInertia, pose.rotation.matrix());
}

void removeBody(WorldState& state, std::uint32_t number) {
    wakeBody(state, number);
    wakeNeighbours(state, number);
    visitContacts(state, number, [&](std::uint32_t contact, std::uint32_t) { removeContact(state, contact); });
    removeProxies(state, number);
    if (state.bodies[number].isAwake) state.hasRemovedAwake = true;
    if (state.grabbed.index == number) state.grabbed = {};
    if (state.bodies[number].restitution > 0.0f) --state.bouncyBodies;
    if (state.bodies[number].shape->hulls.size() > 1) --state.compoundBodies;
    state.bodies[number] = {.generation = state.bodies[number].generation};
    state.motions[number] = {};
    state.poses[number] = {};
    state.freeBodies.push_back(number);
}

void setPose(WorldState& state, std::uint32_t number, const Pose& pose) {
    const Body& body = state.bodies[number];
    BodyPose& bodyPose = state.poses[number];
    const glm::dquat rotation = glm::normalize(pose.orientation);
    bodyPose.rotation = toFloat(rotation);
    bodyPose.centre = toFloat(pose.position + rotation * body.shape->mass.centre);
    bodyPose.inverseInertia = rotated(body.inverseInertia, bodyPose.rotation.matrix());
}

Pose poseOf(const WorldState& state, std::uint32_t number) {
    const BodyPose& pose = state.poses[number];
    const Quat rotation = glm::normalize(toDouble(pose.rotation));
    return {toDouble(pose.centre) - rotation * state.bodies[number].shape->mass.centre, rotation};
}

}  // namespace rubble
