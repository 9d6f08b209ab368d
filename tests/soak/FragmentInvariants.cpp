// What bodies consist of: each fragment is in one body, those of a body are bonded, and no mass is lost.
#include "core/base/DisjointSets.h"
#include "tests/soak/Moment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace rubble::soak {
namespace {

/// Joins the nodes of a structure that unbroken bonds connect; those without strength hold nothing. Without `damage`,
/// all others hold.
DisjointSets joinedNodes(const PlayStructure& structure, const std::vector<BondDamage>& damage) {
    DisjointSets sets(structure.nodeCount());
    const std::vector<Bond>& bonds = structure.graph.bonds;
    for (std::uint32_t bond = 0; bond < bonds.size(); ++bond) {
        const bool isBroken = structure.capacities[bond] <= 0.0 || (!damage.empty() && damage[bond] == kBroken);
        if (bonds[bond].second != kNone && !isBroken) sets.merge(bonds[bond].first, bonds[bond].second);
    }
    return sets;
}

class OneComponent : public Invariant {
public:
    const char* name() const override { return "one component"; }
    std::optional<Fault> check(const StepFacts& step) override {
        std::vector<DisjointSets> sets;
        BodyOfRoot bodyOfRoot;
        for (const StructureState& state : step.session.structures()) {
            sets.push_back(joinedNodes(*state.structure, state.damage));
        }
        for (const BodyFacts& one : step.after.bodies) {
            const bool isIntact = one.body.structure == kNone;
            std::optional<Fault> fault = isIntact ? intactFault(step, one.body)
                                                  : partFault(step, one.body, sets[one.body.structure], bodyOfRoot);
            if (fault) return fault;
        }
        return std::nullopt;
    }

private:
    using BodyOfRoot = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;  // by structure and root

    /// Of a body of which no bond was hit.
    static std::optional<Fault> intactFault(const StepFacts& step, const PlayBody& body) {
        if (body.bondedFracture() == nullptr) return std::nullopt;
        const auto structure = structureIn(step.session.scene(), step.session.origins()[body.origin], body.fragment);
        if (structure == nullptr) return std::nullopt;
        DisjointSets joined = joinedNodes(*structure, {});
        for (std::uint32_t node = 0; node < structure->nodeCount(); ++node) {
            if (joined.rootOf(node) == 0) continue;
            return Fault{step.session.nameOf(body),
                         "no bond with any strength joins its node " + std::to_string(node) + " to the others"};
        }
        return std::nullopt;
    }

    static std::optional<Fault> partFault(const StepFacts& step, const PlayBody& body, DisjointSets& joined,
                                          BodyOfRoot& bodyOfRoot) {
        const std::uint32_t root = joined.rootOf(body.nodes.front());
        for (const std::uint32_t node : body.nodes) {
            if (joined.rootOf(node) == root) continue;
            return Fault{step.session.nameOf(body),
                         "its node " + std::to_string(node) + " has no unbroken bond to the others"};
        }
        const auto [known, isNew] = bodyOfRoot.emplace(std::pair(body.structure, root), body.number);
        if (isNew) return std::nullopt;
        return Fault{step.session.nameOf(body), "an unbroken bond joins it to body " + std::to_string(known->second)};
    }
};

/// The fragments of a body of an asset that do not break further themselves.
void addLeaves(const PlayAsset& asset, std::uint32_t fragment, std::vector<std::uint32_t>& leaves) {
    const PlayFracture* const fracture = asset.fractureOf(fragment);
    if (fracture == nullptr) return leaves.push_back(fragment);
    for (std::uint32_t k = 0; k < fracture->count; ++k) addLeaves(asset, fracture->first + k, leaves);
}

std::vector<std::uint32_t> leavesOf(const PlayBody& body) {
    std::vector<std::uint32_t> leaves;
    if (body.nodes.empty()) addLeaves(*body.asset, body.fragment, leaves);
    for (const std::uint32_t fragment : fragmentsOf(body)) addLeaves(*body.asset, fragment, leaves);
    return leaves;
}

double totalMass(const Moment& moment) {
    double mass = 0.0;
    for (const BodyFacts& one : moment.bodies) mass += one.mass;
    return mass;
}

class NothingLost : public Invariant {
public:
    const char* name() const override { return "nothing lost"; }
    std::optional<Fault> check(const StepFacts& step) override {
        if (std::optional<Fault> fault = checkNodes(step)) return fault;
        if (std::optional<Fault> fault = checkLeaves(step)) return fault;
        return checkMass(step);
    }

private:
    /// bodyOfNode must lead to the body that has the node.
    std::optional<Fault> checkNodes(const StepFacts& step) const {
        for (std::uint32_t index = 0; index < step.session.structures().size(); ++index) {
            const StructureState& state = step.session.structures()[index];
            for (std::uint32_t node = 0; node < state.bodyOfNode.size(); ++node) {
                if (state.bodyOfNode[node] == kNone) continue;
                const BodyFacts* const body = step.after.find(state.bodyOfNode[node]);
                const bool isThere = body != nullptr && body->body.structure == index &&
                                     std::ranges::binary_search(body->body.nodes, node);
                // A body that was removed as debris leaves its nodes behind.
                if (!isThere && body != nullptr) {
                    return Fault{step.session.nameOf(body->body), "it does not have its node " + std::to_string(node)};
                }
            }
        }
        for (const BodyFacts& one : step.after.bodies) {
            if (one.body.structure == kNone) continue;
            for (const std::uint32_t node : one.body.nodes) {
                if (step.session.structures()[one.body.structure].bodyOfNode[node] != one.body.number) {
                    return Fault{step.session.nameOf(one.body),
                                 "its node " + std::to_string(node) + " is said to be another body's"};
                }
            }
        }
        return std::nullopt;
    }

    std::optional<Fault> checkLeaves(const StepFacts& step) const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> owners;  // by origin and leaf
        for (const BodyFacts& one : step.after.bodies) {
            if (one.body.asset == nullptr) continue;
            for (const std::uint32_t leaf : leavesOf(one.body)) {
                const auto [known, isNew] = owners.emplace(std::pair(one.body.origin, leaf), one.body.number);
                if (isNew) continue;
                return Fault{step.session.nameOf(one.body), "its fragment " + std::to_string(leaf) +
                                                                " is also in body " + std::to_string(known->second)};
            }
        }
        return std::nullopt;
    }

    /// Mass comes by throws and goes by removals; gaps take some of what breaks.
    std::optional<Fault> checkMass(const StepFacts& step) const {
        if (step.hasInput<MaterialInput>() || step.hasInput<RemoveInput>()) return std::nullopt;
        if (step.changesMasses()) return std::nullopt;
        double expected = totalMass(step.before);
        for (const ThrownBody& thrown : step.thrown) expected += thrown.mass;
        for (const PlayRemoval& removal : step.events.removed) expected -= removal.mass;
        const double mass = totalMass(step.after), slack = 1e-5 * (totalMass(step.before) + mass);
        const bool isStaticGone =
            std::ranges::any_of(step.events.removed, [](const auto& one) { return one.mass == 0.0; });
        if (isStaticGone) return std::nullopt;
        const bool mayLose = hasGaps(step) && !(step.events.breaks.empty() && step.events.splits.empty());
        if (mass > expected + slack || (!mayLose && mass < expected - slack)) {
            return Fault{"", "the mass is " + textOf(mass) + " kg, not " + textOf(expected)};
        }
        return std::nullopt;
    }

    /// Whether fragments are smaller than their part of the whole, by a gap or by the mortar between bricks.
    static bool hasGaps(const StepFacts& step) {
        return std::ranges::any_of(step.session.scene().project.assets, [](const Asset& asset) {
            return asset.shaping.gap > 0.0 || hasMortar(asset.pattern) ||
                   std::ranges::any_of(asset.levels, [](const Level& level) { return hasMortar(level.pattern); });
        });
    }
    static bool hasMortar(const Pattern& pattern) {
        return std::ranges::any_of(pattern.layers, [](const PatternLayer& layer) {
            const auto* bricks = std::get_if<BrickBond>(&layer.parameters);
            return bricks != nullptr && bricks->mortar > 0.0;
        });
    }
};

}  // namespace

std::unique_ptr<Invariant> oneComponent() { return std::make_unique<OneComponent>(); }
std::unique_ptr<Invariant> nothingLost() { return std::make_unique<NothingLost>(); }

}  // namespace rubble::soak
