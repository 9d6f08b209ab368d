#include "core/physics/Spin.h"

namespace rubble {
namespace {

constexpr float kSpinnerAngle = 0.02f;   // rad a step
constexpr float kFlyingAngle = 0.0002f;  // the same where nothing is near that would stop what a slow turn gains
constexpr int kMidpointRounds = 6;       // each gains as many digits as the angle of a sub-step is small

/// q turned on by half * 2 of spin w, to first order, then made a unit again.
Quatf turnedOn(const Quatf& q, Vec3f w, float half) {
    const Vec3f t = w * half;
    return Quatf{q.x + t.x * q.w + t.y * q.z - t.z * q.y, q.y - t.x * q.z + t.y * q.w + t.z * q.x,
                 q.z + t.x * q.y - t.y * q.x + t.z * q.w, q.w - t.x * q.x - t.y * q.y - t.z * q.z}
        .normalized();
}

Vec3f spinOf(const Body& body, const Quatf& turn, Vec3f momentum) {
    const Mat3f matrix = turn.matrix();
    return matrix * (body.inverseInertia * matrix.transposedTimes(momentum));
}

}  // namespace

Vec3f angularMomentum(const WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    const Mat3f turn = state.places[number].turn.matrix();
    return body.momentum + turn * (body.inertia * turn.transposedTimes(state.motions[number].spin - body.spinThen));
}

bool isSpinner(const WorldState& state, std::uint32_t body, float dt) {
    const float least = state.bodies[body].firstContact == kNone ? kFlyingAngle : kSpinnerAngle;
    return state.bodies[body].isDynamic() && lengthSquared(state.motions[body].spin) * dt * dt > least * least;
}

Quatf turnedBySpin(const WorldState& state, std::uint32_t number, float h) {
    const Body& body = state.bodies[number];
    const BodyPlace& place = state.places[number];
    const BodyMotion& motion = state.motions[number];
    const Vec3f held = angularMomentum(state, number);
    const Quatf start = motion.turned;
    Quatf end = turnedOn(start, spinOf(body, start * place.turn, held), 0.5f * h);
    for (int round = 0; round < kMidpointRounds; ++round) {
        const Quatf middle = Quatf{start.x + end.x, start.y + end.y, start.z + end.z, start.w + end.w}.normalized();
        end = turnedOn(start, spinOf(body, middle * place.turn, held), 0.5f * h);
    }
    return end;
}

void takeTurn(WorldState& state, std::uint32_t number) {
    Body& body = state.bodies[number];
    BodyPlace& place = state.places[number];
    BodyMotion& motion = state.motions[number];
    const Quatf turn = (motion.turned * place.turn).normalized();
    if (body.isDynamic()) {
        body.momentum = angularMomentum(state, number);
        body.spinThen = motion.spin = spinOf(body, turn, body.momentum);
        place.inverseInertia = rotated(body.inverseInertia, turn.matrix());
    }
    place.turn = turn;
}

}  // namespace rubble
