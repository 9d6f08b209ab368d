#include "core/play/queries/PartsRemoved.h"

#include "core/play/breaking/Collapsing.h"
#include "core/play/breaking/MortarBreaking.h"
#include "core/play/breaking/PartRemoval.h"
#include "core/play/breaking/Splitting.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <map>
#include <set>

namespace rubble {
namespace {

std::vector<std::uint32_t> nodesOf(const PlayBody& body, std::span<const std::uint32_t> fragments) {
    std::vector<std::uint32_t> nodes(fragments.begin(), fragments.end());
    for (std::uint32_t& node : nodes) node -= body.bondedFracture()->first;
    return nodes;
}

/// The bodies that a removal made, and the body of the session that each was of.
class Sources {
public:
    explicit Sources(const Session& session) : m_session(session) {}

    void add(std::uint32_t made, std::uint32_t from) {
        if (m_session.body(made) == nullptr) m_sources[made] = of(from);
    }
    std::uint32_t of(std::uint32_t number) const {
        const auto made = m_sources.find(number);
        return made != m_sources.end() ? made->second : number;
    }
    bool contains(std::uint32_t made) const { return m_sources.contains(made); }

private:
    const Session& m_session;
    std::map<std::uint32_t, std::uint32_t> m_sources;
};

/// Breaks the mortar that holds no longer, and lets come off at once what has lost its support by that. `changed`: the
/// instances of which parts are removed.
void settle(SessionParts& parts, const std::set<Id>& changed, const Session& session, Sources& sources) {
    parts.state().events = {};
    splitBodies(parts, brokenMortar(parts, changed));
    planMortarCollapse(parts, changed);
    for (PlayBody& body : parts.state().bodies) {
        const PlayBody* before = session.body(body.number);
        const bool wasPlanned = before != nullptr && before->collapseStep != PlayBody::kNever;
        if (body.collapseStep != PlayBody::kNever && !wasPlanned) body.collapseStep = parts.state().step + 1;
    }
    splitBodies(parts, brokenByCollapse(parts));
    for (const PlaySplit& split : parts.state().events.splits)
        for (const std::uint32_t freed : split.freed) sources.add(freed, split.body.number);
    for (const PlayBody& body : parts.state().bodies) {  // what anchors hold in several pieces
        if (session.body(body.number) != nullptr || sources.contains(body.number)) continue;
        sources.add(body.number, std::ranges::find(session.bodies(), body.origin, &PlayBody::origin)->number);
    }
}

}  // namespace

PartsRemoved withoutParts(const Session& session, std::span<const BodyPart> parts,
                          std::span<const std::uint32_t> gone) {
    const std::shared_ptr<const SessionSnapshot> start = session.snapshot();
    SessionState state = start->state;
    PartsRemoved removed{.world = World({.gravity = session.world().gravity()})};
    removed.world.restore(*start->world);
    const SessionSettings settings{.dt = session.stepLength(), .sleeping = session.isSleeping()};
    SessionParts copy{session.scene(), settings, state, removed.world};
    Sources sources(session);
    std::set<Id> changed;
    const auto change = [&](std::uint32_t number) {
        changed.insert(session.origins()[session.body(number)->origin].instance);
    };
    for (const BodyPart& part : parts) {
        change(part.body);
        const std::uint32_t next = state.nextNumber;
        removeNodes(copy, part.body, nodesOf(*session.body(part.body), part.fragments));
        for (std::uint32_t made = next; made < state.nextNumber; ++made) sources.add(made, part.body);
        removed.reduced.push_back(part.body);
    }
    for (const std::uint32_t number : gone) {
        change(number);
        breakMortarOf(copy, number);
    }
    settle(copy, changed, session, sources);
    removed.world.collide(settings.dt);
    removed.bodies = std::move(state.bodies);
    const std::size_t present = session.bodies().size();
    for (std::uint32_t k = 0; k < removed.bodies.size(); ++k) {
        const std::uint32_t number = sources.of(removed.bodies[k].number);
        if (k >= present) {
            removed.splitOff.push_back(number);
            removed.reduced.push_back(number);
        }
        if (session.body(number)->isHeld && !removed.bodies[k].isHeld) removed.cameOff.push_back(k);
    }
    std::ranges::sort(removed.reduced);
    removed.reduced.erase(std::unique(removed.reduced.begin(), removed.reduced.end()), removed.reduced.end());
    return removed;
}

}  // namespace rubble
