#include "core/play/queries/PartsRemoved.h"

#include "core/play/breaking/Splitting.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>

namespace rubble {
namespace {

std::vector<std::uint32_t> nodesOf(const PlayBody& body, std::span<const std::uint32_t> fragments) {
    std::vector<std::uint32_t> nodes(fragments.begin(), fragments.end());
    for (std::uint32_t& node : nodes) node -= body.bondedFracture()->first;
    return nodes;
}

}  // namespace

PartsRemoved withoutParts(const Session& session, std::span<const BodyPart> parts) {
    const std::shared_ptr<const SessionSnapshot> start = session.snapshot();
    SessionState state = start->state;
    PartsRemoved removed{.world = World({.gravity = session.world().gravity()})};
    removed.world.restore(*start->world);
    const SessionSettings settings{.dt = session.stepLength(), .sleeping = session.isSleeping()};
    const SessionParts copy{session.scene(), settings, state, removed.world};
    for (const BodyPart& part : parts) {
        removeNodes(copy, part.body, nodesOf(*session.body(part.body), part.fragments));
        removed.splitOff.resize(state.bodies.size() - session.bodies().size(), part.body);
        removed.reduced.push_back(part.body);
    }
    removed.world.collide(settings.dt);
    removed.bodies = std::move(state.bodies);
    for (std::uint32_t k = 0; k < removed.bodies.size(); ++k) {
        const PlayBody& body = removed.bodies[k];
        const std::size_t present = session.bodies().size();
        const bool wasHeld =
            k < present ? session.bodies()[k].isHeld : session.body(removed.splitOff[k - present])->isHeld;
        if (wasHeld && !body.isHeld) removed.cameOff.push_back(k);
    }
    return removed;
}

}  // namespace rubble
