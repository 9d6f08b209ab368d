#include "core/play/breaking/MortarSupport.h"

#include "core/play/scene/JoinedSupport.h"
#include "core/play/state/BegunStructures.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>

namespace rubble {
namespace {

/// The structures of instances as they are at the start.
std::map<Id, JoinedStructure> structuresAtStart(const SessionParts& parts, const std::vector<Id>& group) {
    std::map<Id, JoinedStructure> joined;
    for (const Id instance : group) {
        const std::shared_ptr<const PlayStructure>& structure = parts.scene().structures.at(instance);
        const Pose pose = poseOf(*findInstance(parts.scene().project, instance));
        joined[instance] = joinedAtStart(*structure, upIn(pose, parts.world().gravity()));
    }
    return joined;
}

/// The support of a group with a span, computed anew against the present gravity. What is no longer held counts as if
/// it were: nothing unbroken joins it with what is.
KeptSupport supportAnew(const SessionParts& parts, const BegunStructures& begun, const std::vector<Id>& group) {
    std::map<Id, JoinedStructure> joined = structuresAtStart(parts, group);
    const NodeFractions limits = joinedSupportLimits(joined);
    for (auto& [instance, one] : joined) {
        if (const StructureState* state = begun.find(instance)) one.damage = state->damage;
    }
    KeptSupport support{.spread = std::make_unique<SupportSpread>(joined, limits)};
    for (const auto& [instance, one] : joined) {
        if (!one.structure->hasSpan()) continue;
        const std::vector<double> fractions = support.spread->fractionsOf(instance);
        const std::vector<double>& limit = limits.at(instance);
        for (std::uint32_t node = 0; node < fractions.size(); ++node)
            if (fractions[node] > limit[node]) support.unsupported.push_back({instance, node});
    }
    return support;
}

/// Brings the support of a group up to date. False if something was mended in it.
bool update(const SessionState& state, const JoinedGroups::mapped_type& group, KeptSupport& support) {
    std::uint32_t begun = 0;
    for (const StructureState& one : state.structures) {
        if (one.parent != kNone || one.structure->joined != group) continue;
        const Id instance = state.origins[one.origin].instance;
        if (support.spread->isMended(instance, one.damage)) return false;
        support.spread->setDamage(instance, one.damage);
        ++begun;
    }
    if (begun < support.begun) return false;
    support.begun = begun;
    const std::vector<InstanceNode> lost = support.spread->spread();
    const auto before = static_cast<std::ptrdiff_t>(support.unsupported.size());
    support.unsupported.insert(support.unsupported.end(), lost.begin(), lost.end());
    std::inplace_merge(support.unsupported.begin(), support.unsupported.begin() + before, support.unsupported.end());
    return true;
}

/// Whether gravity points as at the start: the structures know their limits of support.
bool isUpAsAtStart(const SessionParts& parts) {
    return upIn({}, parts.world().gravity()) == upIn({}, parts.scene().project.gravity);
}

/// The bodies of nodes.
class NodeBodies {
public:
    NodeBodies(const SessionState& state, const BegunStructures& begun) : m_state(state), m_begun(begun) {}

    /// Null: the node is in none, or alone.
    const PlayBody* bodyOf(const InstanceNode& one) {
        if (const StructureState* structure = m_begun.find(one.instance))
            return findBody(m_state, structure->bodyOfNode[one.node]);
        if (m_instance != one.instance) {
            const auto isIts = [&](const PlayBody& body) {
                return body.role == PlayRole::Instance && m_state.origins[body.origin].instance == one.instance;
            };
            const auto found = std::ranges::find_if(m_state.bodies, isIts);
            m_intact = found != m_state.bodies.end() ? &*found : nullptr;
            m_instance = one.instance;
        }
        return m_intact;
    }

private:
    const SessionState& m_state;
    const BegunStructures& m_begun;
    Id m_instance = 0;  // whose body is known
    const PlayBody* m_intact = nullptr;
};

/// Adds the unsupported nodes by their bodies, and forgets those that are not held any more.
void addByBody(const SessionState& state, const BegunStructures& begun, KeptSupport& support, UnsupportedNodes& all) {
    NodeBodies bodies(state, begun);
    std::erase_if(support.unsupported, [&](const InstanceNode& one) {
        const PlayBody* body = bodies.bodyOf(one);
        if (body == nullptr || !body->isHeld) return true;
        all[body->number].push_back(one.node);
        return false;
    });
}

}  // namespace

UnsupportedNodes unsupportedByMortar(SessionParts& parts, const JoinedGroups& groups) {
    UnsupportedNodes all;
    if (groups.empty() || parts.world().gravity() == Vec3(0.0)) return all;
    SessionState& state = parts.state();
    const BegunStructures begun(state);
    const bool isUpKnown = isUpAsAtStart(parts);
    const auto hasSpan = [&](Id instance) { return parts.scene().structures.at(instance)->hasSpan(); };
    for (const auto& [first, group] : groups) {
        const SupportSpread* atStart = parts.scene().structures.at(first)->supportAtStart.get();
        if (!isUpKnown && std::ranges::any_of(*group, hasSpan)) {
            KeptSupport support = supportAnew(parts, begun, *group);
            addByBody(state, begun, support, all);
        } else if (isUpKnown && atStart != nullptr) {
            KeptSupport& kept = state.keptSupports.groups[first];
            if (kept.spread == nullptr || !update(state, group, kept)) {
                kept = {.spread = std::make_unique<SupportSpread>(*atStart)};
                update(state, group, kept);
            }
            addByBody(state, begun, kept, all);
        }
    }
    return all;
}

}  // namespace rubble
