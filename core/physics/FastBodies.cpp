#include "core/physics/FastBodies.h"

#include "core/physics/Contacts.h"
#include "core/physics/HullRay.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr float kFarShare = 0.5f;  // of a body's breadth: what moves less cannot get to another's far side
constexpr float kKept = 0.99f;     // of the way to the surface

/// A point that moves in the world, in the frame of a body at the begin of the step and at its end.
struct RelativeWay {
    Vec3f from;
    Vec3f way;
};

Mat3f endTurn(const WorldState& state, std::uint32_t body) {
    return (state.motions[body].turned * state.places[body].turn).matrix();
}

RelativeWay wayPast(const WorldState& state, std::uint32_t body, std::uint32_t other) {
    const BodyPlace& place = state.places[other];
    const Vec3f before = state.places[body].centre - place.centre;
    const Vec3f after = before + state.motions[body].moved - state.motions[other].moved;
    const Vec3f from = place.turn.matrix().transposedTimes(before);
    return {from, endTurn(state, other).transposedTimes(after) - from};
}

void holdBack(WorldState& state, std::uint32_t body) {
    visitContacts(state, body, [&](std::uint32_t number, std::uint32_t other) {
        const Contact& contact = state.contacts[number];
        const Proxy& proxy = state.proxies[contact.proxies[contact.bodies[0] == other ? 0 : 1]];
        const RelativeWay way = wayPast(state, body, other);
        const HullEntry entry = entryOf(state.bodies[other].shape->hulls[proxy.hull], way.from, way.way);
        if (entry.fraction > 1.0f) return;
        // Where it entered, as that place has moved by the end of the step.
        const Vec3f kept = endTurn(state, other) * (way.from + way.way * (kKept * entry.fraction));
        state.motions[body].moved =
            state.places[other].centre - state.places[body].centre + state.motions[other].moved + kept;
    });
}

}  // namespace

void holdBackFastBodies(WorldState& state) {
    for (std::uint32_t number : state.awake) {
        const Body& body = state.bodies[number];
        const float far = kFarShare * body.shape->breadth;
        if (body.isDynamic() && lengthSquared(state.motions[number].moved) > far * far) holdBack(state, number);
    }
}

}  // namespace rubble
