// Only what lost support collapses: what is beyond its span from the start stays, as long as nothing near it breaks.
#include "core/structure/graph/Support.h"
#include "tests/soak/Moment.h"

#include <algorithm>
#include <limits>
#include <map>

namespace rubble::soak {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

/// How far sideways the nodes of a structure are from an anchor, m. `isLeftOut`, if not empty, takes nodes away.
/// Source: Bellman, Ford 1958.
std::vector<double> sidewaysDistances(const PlayStructure& structure, const std::vector<BondDamage>& damage, Vec3 up,
                                      const std::vector<bool>& isLeftOut) {
    const BondGraph& graph = structure.graph;
    std::vector<double> distances(graph.nodeCount(), kUnreached);
    const auto isGone = [&](std::uint32_t node) { return !isLeftOut.empty() && isLeftOut[node]; };
    for (std::uint32_t bond = 0; bond < graph.bondCount(); ++bond) {
        const bool isAnchor = graph.bonds[bond].second == kNone && damage[bond] != kBroken;
        if (isAnchor && !isGone(graph.bonds[bond].first)) distances[graph.bonds[bond].first] = 0.0;
    }
    for (bool isChanged = true; isChanged;) {
        isChanged = false;
        for (std::uint32_t node = 0; node < graph.nodeCount(); ++node) {
            for (const BondLink& link : graph.linksOf(node)) {
                if (link.node == kNone || damage[link.bond] == kBroken || isGone(link.node)) continue;
                const double reached = distances[node] + sidewaysStep(graph, node, link, up);
                if (!(reached < distances[link.node])) continue;
                distances[link.node] = reached;
                isChanged = true;
            }
        }
    }
    return distances;
}

/// Bonds without strength hold nothing.
std::vector<BondDamage> intactBonds(const PlayStructure& structure) {
    std::vector<BondDamage> damage;
    for (const double capacity : structure.capacities) damage.push_back(capacity > 0.0 ? kIntact : kBroken);
    return damage;
}

class SupportLost : public Invariant {
public:
    const char* name() const override { return "support lost"; }
    std::optional<Fault> check(const StepFacts& step) override {
        for (const PlaySplit& split : step.events.splits) {
            if (std::optional<Fault> fault = faultOf(step, split)) return fault;
        }
        m_damage.clear();
        for (const StructureState& state : step.session.structures()) m_damage.push_back(state.damage);
        return std::nullopt;
    }

private:
    /// Of the fragments that a collapse frees: nothing broke on the way from those to their anchors.
    std::optional<Fault> faultOf(const StepFacts& step, const PlaySplit& split) const {
        const bool isCollapse = split.body.isHeld && split.impactorNumber == kNone && split.impulse == 0.0;
        const bool isActedOn = step.hasInput<RemoveInput>() || step.hasInput<ShotInput>() ||
                               step.hasInput<BreakInput>() || step.hasInput<GravityInput>() ||
                               step.before.gravity == Vec3(0.0);
        if (!isCollapse || isActedOn || split.body.structure >= m_damage.size()) return std::nullopt;
        const StructureState& state = step.session.structures()[split.body.structure];
        const PlayStructure& structure = *state.structure;
        if (!structure.mortar.empty() || !structure.clusterLevels.empty() || structure.span <= 0.0) return std::nullopt;
        const BodyFacts* const body = step.before.find(split.body.number);
        if (body == nullptr || !body->body.isHeld || body->body.structure != split.body.structure) return std::nullopt;
        const Vec3 up = glm::conjugate(body->state.pose.orientation) * -glm::normalize(step.before.gravity);
        const std::vector<BondDamage>& damage = m_damage[split.body.structure];
        const std::vector<double> first = sidewaysDistances(structure, intactBonds(structure), up, {});
        const std::vector<double> now = sidewaysDistances(structure, damage, up, {});
        std::vector<bool> lost(first.size());
        for (std::size_t node = 0; node < first.size(); ++node) lost[node] = now[node] > first[node] + 1e-9;
        const std::vector<double> left = sidewaysDistances(structure, damage, up, lost);
        return freedFault(step, split, first, left);
    }

    static std::optional<Fault> freedFault(const StepFacts& step, const PlaySplit& split,
                                           const std::vector<double>& first, const std::vector<double>& left) {
        const PlayStructure& structure = *step.session.structures()[split.body.structure].structure;
        for (const std::uint32_t number : split.freed) {
            const BodyFacts* const freed = step.after.find(number);
            if (freed == nullptr) continue;
            std::vector<std::uint32_t> nodes = freed->body.nodes;
            if (nodes.empty()) nodes = {freed->body.fragment - structure.fracture().first};
            for (const std::uint32_t node : nodes) {
                if (!(left[node] <= first[node] + 1e-9) || left[node] == kUnreached) continue;
                return Fault{step.session.nameOf(freed->body),
                             "it falls, " + textOf(first[node]) + " m sideways of an anchor with a span of " +
                                 textOf(structure.span) + " m, though it lost no support"};
            }
        }
        return std::nullopt;
    }

    std::vector<std::vector<BondDamage>> m_damage;  // before the step
};

}  // namespace

std::unique_ptr<Invariant> supportLost() { return std::make_unique<SupportLost>(); }

}  // namespace rubble::soak
