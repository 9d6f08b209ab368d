#include "core/physics/FastBodies.h"

#include "core/physics/Contacts.h"
#include "core/physics/HullRay.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr float kFarShare = 0.5f;  // of a body's breadth: what moves less cannot get to another's far side
// Of a body's breadth: how far before the surface its centre stays. On the surface, the way out through the far side would be
// as short as that back.
constexpr float kDistanceShare = 0.25f;

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
        const HullEntry entry = entryOf(hullOf(state, proxy), way.from, way.way);
        if (entry.fraction > 1.0f) return;
        const float distance = kDistanceShare * state.bodies[body].shape->breadth;
        const float fraction = std::max(0.0f, entry.fraction + distance / dot(entry.normal, way.way));
        // Where it entered, as that place has moved by the end of the step.
        const Vec3f kept = endTurn(state, other) * (way.from + way.way * fraction);
        state.motions[body].moved =
            state.places[other].centre - state.places[body].centre + state.motions[other].moved + kept;
    });
}

}  // namespace

void holdBackFastBodies(WorldState& state, WorkerTeam& team, const Regions& regions,
                        std::vector<std::vector<std::uint32_t>>& byRegion) {
    byRegion.resize(regions.count());
    regions.forEach(team, [&](std::size_t region) {
        byRegion[region].clear();
        for (std::uint32_t number : regions.bodies(region)) {
            const Body& body = state.bodies[number];
            const float far = kFarShare * body.shape->breadth;
            const bool isFast = lengthSquared(state.motions[number].moved) > far * far;
            if (isFast && body.isDynamic()) byRegion[region].push_back(number);
        }
    });
    std::vector<std::uint32_t>& fast = mergedAscending(byRegion);
    for (std::uint32_t body : fast) holdBack(state, body);
}

}  // namespace rubble
