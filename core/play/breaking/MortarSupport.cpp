#include "core/play/breaking/MortarSupport.h"

#include "core/play/scene/JoinedSupport.h"

#include <algorithm>

namespace rubble {
namespace {

/// The structures of instances as they are at the start.
std::map<Id, JoinedStructure> structuresAtStart(const SessionParts& parts, const std::set<Id>& instances) {
    std::map<Id, JoinedStructure> joined;
    for (const Id instance : instances) {
        const std::shared_ptr<const PlayStructure>& structure = parts.scene().structures.at(instance);
        const Pose pose = poseOf(*findInstance(parts.scene().project, instance));
        joined[instance] = joinedAtStart(*structure, upIn(pose, parts.world().gravity()));
    }
    return joined;
}

/// Their held bodies, by instance.
std::map<Id, std::vector<const PlayBody*>> heldBodies(const SessionParts& parts,
                                                      const std::map<Id, JoinedStructure>& joined) {
    std::map<Id, std::vector<const PlayBody*>> held;
    for (const PlayBody& body : parts.state().bodies) {
        const Id instance = parts.state().origins[body.origin].instance;
        if (body.isHeld && joined.contains(instance)) held[instance].push_back(&body);
    }
    return held;
}

/// Whether all structures know their limits against the present gravity.
bool areLimitsKnown(const std::map<Id, JoinedStructure>& joined) {
    return std::ranges::all_of(joined, [](const auto& entry) {
        const JoinedStructure& one = entry.second;
        return !one.structure->hasSpan() || (!one.structure->supportLimits.empty() && one.structure->up == one.up);
    });
}

NodeFractions limitsOf(const std::map<Id, JoinedStructure>& atStart) {
    if (!areLimitsKnown(atStart)) return joinedSupportLimits(atStart);
    NodeFractions limits;
    for (const auto& [instance, one] : atStart) {
        if (one.structure->hasSpan()) limits[instance] = one.structure->supportLimits;
    }
    return limits;
}

/// Makes structures as they are at the start those of a moment.
void setMoment(const SessionParts& parts, const std::map<Id, std::vector<const PlayBody*>>& held,
               std::map<Id, JoinedStructure>& joined) {
    for (auto& [instance, one] : joined) {
        const auto bodies = held.find(instance);
        const std::vector<std::uint32_t> all = std::exchange(one.held, {});
        if (bodies == held.end()) continue;
        for (const PlayBody* body : bodies->second) {
            if (body->structure != kNone) one.damage = parts.state().structures[body->structure].damage;
            const std::vector<std::uint32_t>& nodes = body->structure != kNone ? body->nodes : all;
            one.held.insert(one.held.end(), nodes.begin(), nodes.end());
        }
        std::ranges::sort(one.held);
    }
}

}  // namespace

UnsupportedNodes unsupportedByMortar(const SessionParts& parts, const std::set<Id>& instances) {
    const std::set<Id> connected = joinedInstances(parts.scene().structures, instances);
    const auto hasSpan = [&](Id instance) { return parts.scene().structures.at(instance)->span > 0.0; };
    if (parts.world().gravity() == Vec3(0.0) || std::ranges::none_of(connected, hasSpan)) return {};
    std::map<Id, JoinedStructure> joined = structuresAtStart(parts, connected);
    const NodeFractions limits = limitsOf(joined);
    const std::map<Id, std::vector<const PlayBody*>> held = heldBodies(parts, joined);
    setMoment(parts, held, joined);
    const NodeFractions fractions = supportFractions(joined, limits);
    UnsupportedNodes all;
    for (const auto& [instance, bodies] : held) {
        const JoinedStructure& one = joined.at(instance);
        if (!one.structure->hasSpan()) continue;
        const std::vector<double>&limit = limits.at(instance), &fraction = fractions.at(instance);
        for (const PlayBody* body : bodies) {
            std::vector<std::uint32_t> nodes = body->structure != kNone ? body->nodes : one.held;
            std::erase_if(nodes, [&](std::uint32_t node) { return !(fraction[node] > limit[node]); });
            if (!nodes.empty()) all[body->number] = std::move(nodes);
        }
    }
    return all;
}

}  // namespace rubble
