#include "core/physics/step/RollingResistance.h"

#include "core/physics/state/Contacts.h"

#include <algorithm>

namespace rubble {
namespace {

/// The torque against rolling, relative to the force at the contact and the radius: that of stones on hard ground.
constexpr float kCoefficient = 0.02f;

/// The sum of the normal impulses of a contact in the step, N·s.
float impulseOf(const ContactBlock& block, std::size_t lane) {
    float sum = 0.0f;
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) sum += block.points[i].stepImpulse[lane];
    return sum;
}

/// Slows the bodies of a contact about the axes in its plane, at most until they roll no more.
void resist(WorldState& state, const ContactBlock& block, std::size_t lane) {
    const std::uint32_t first = block.first[lane], second = block.second[lane];
    BodyMotion &a = state.motions[first], &b = state.motions[second];
    const Vec3f normal = block.normal.at(lane), spin = b.angularVelocity - a.angularVelocity;
    const Vec3f rolling = spin - normal * dot(normal, spin);
    const float speed = length(rolling);
    if (speed == 0.0f) return;
    const Vec3f axis = rolling * (1.0f / speed);
    const Vec3f slowsA = state.poses[first].inverseInertia * axis, slowsB = state.poses[second].inverseInertia * axis;
    const float radius = std::min(state.poses[first].boundingRadius, state.poses[second].boundingRadius);
    const float impulse =
        std::min(kCoefficient * radius * impulseOf(block, lane), speed / (dot(axis, slowsA) + dot(axis, slowsB)));
    a.angularVelocity += slowsA * impulse;
    b.angularVelocity -= slowsB * impulse;
}

}  // namespace

void resistRolling(WorldState& state) {
    for (const std::uint32_t body : state.awake) {
        if (!state.bodies[body].isDynamic() || !isRounded(*state.bodies[body].shape)) continue;
        visitContacts(state, body, [&](std::uint32_t number, std::uint32_t other) {
            const Contact& contact = state.contacts[number];
            const bool isVisitedBefore =
                other < body && state.bodies[other].isDynamic() && isRounded(*state.bodies[other].shape);
            if (!contact.slot.isSet() || isVisitedBefore) return;
            resist(state, state.colours.block(contact.slot),
                   static_cast<std::size_t>(ContactColours::laneOf(contact.slot)));
        });
    }
}

}  // namespace rubble
