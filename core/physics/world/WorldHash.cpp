#include "core/physics/state/WorldState.h"
#include "core/physics/world/World.h"

#include <cstring>

namespace rubble {
namespace {

void addBits(Hasher& hasher, float a, float b) {
    std::uint32_t bits[2];
    const float values[2] = {a + 0.0f, b + 0.0f};  // makes -0 positive
    std::memcpy(bits, values, sizeof bits);
    hasher.add(static_cast<std::uint64_t>(bits[0]) << 32 | bits[1]);
}

}  // namespace

ContentHash World::hash() const {
    Hasher hasher;
    for (BodyId body : bodies()) {
        const BodyPose& pose = m_state->poses[body.index];
        const BodyMotion& motion = m_state->motions[body.index];
        hasher.add(static_cast<std::uint64_t>(body.index) << 1 | (m_state->bodies[body.index].isAwake ? 1u : 0u));
        addBits(hasher, pose.centre.x, pose.centre.y);
        addBits(hasher, pose.centre.z, pose.rotation.x);
        addBits(hasher, pose.rotation.y, pose.rotation.z);
        addBits(hasher, pose.rotation.w, motion.velocity.x);
        addBits(hasher, motion.velocity.y, motion.velocity.z);
        addBits(hasher, motion.angularVelocity.x, motion.angularVelocity.y);
        addBits(hasher, motion.angularVelocity.z, 0.0f);
    }
    return hasher.digest();
}

}  // namespace rubble
