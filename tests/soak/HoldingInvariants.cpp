// What reaches an anchor is held, nothing else is, and what is held stays where it is.
#include "tests/soak/Moment.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

namespace rubble::soak {
namespace {

using Node = std::pair<Id, std::uint32_t>;  // of an instance's whole

/// A bonded instance in a session.
struct BondedInstance {
    const PlayStructure* structure = nullptr;
    const StructureState* state = nullptr;          // null: intact
    std::map<std::uint32_t, std::uint32_t> bodyOf;  // number of the body that has a node
    /// A bond without strength holds nothing.
    bool isBroken(std::uint32_t bond) const {
        return structure->capacities[bond] <= 0.0 || (state != nullptr && state->damage[bond] == kBroken);
    }
};

bool isOfWhole(const PlayBody& body) { return body.fragment == kNone && body.asset != nullptr && body.asset->isBonded; }

std::map<Id, BondedInstance> bondedInstances(const Session& session, const Moment& moment) {
    std::map<Id, BondedInstance> instances;
    for (const auto& [id, structure] : session.scene().structures) instances[id].structure = structure.get();
    for (const StructureState& state : session.structures()) {
        const Id id = session.origins()[state.origin].instance;
        if (state.parent != kNone || !instances.contains(id)) continue;
        instances[id].state = &state;
        instances[id].structure = state.structure.get();
    }
    for (const BodyFacts& one : moment.bodies) {
        const auto found = instances.find(session.origins()[one.body.origin].instance);
        if (found == instances.end() || !isOfWhole(one.body)) continue;
        BondedInstance& instance = found->second;
        for (const std::uint32_t node : one.body.nodes) instance.bodyOf[node] = one.body.number;
        const std::uint32_t count = one.body.nodes.empty() ? instance.structure->nodeCount() : 0;
        for (std::uint32_t node = 0; node < count; ++node) instance.bodyOf[node] = one.body.number;
    }
    return instances;
}

/// The nodes from which unbroken bonds and mortar lead to an anchor.
class AnchoredNodes {
public:
    AnchoredNodes(const std::map<Id, BondedInstance>& instances, const Moment& moment) : m_instances(instances) {
        for (const auto& [id, instance] : instances) addSources(id, instance, moment);
        while (!m_waiting.empty()) {
            const Node node = m_waiting.front();
            m_waiting.pop_front();
            spread(node);
        }
    }
    bool contains(const Node& node) const { return m_reached.contains(node); }

private:
    void reach(Id id, std::uint32_t node) {
        if (!m_instances.at(id).bodyOf.contains(node)) return;  // it is gone
        if (m_reached.insert({id, node}).second) m_waiting.push_back({id, node});
    }

    /// Anchors of its own; and the part that a fixed instance keeps that touches nothing.
    void addSources(Id id, const BondedInstance& instance, const Moment& moment) {
        const std::vector<Bond>& bonds = instance.structure->graph.bonds;
        for (std::uint32_t bond = 0; bond < bonds.size(); ++bond) {
            const bool isAnchor = bonds[bond].second == kNone && instance.structure->mortarOf(bond) == nullptr;
            if (isAnchor && !instance.isBroken(bond)) reach(id, bonds[bond].first);
        }
        if (!instance.structure->holdsHeaviest) return;
        for (const auto& [node, number] : instance.bodyOf) {
            if (moment.find(number)->body.isHeld) reach(id, node);
        }
    }

    void spread(const Node& from) {
        const BondedInstance& instance = m_instances.at(from.first);
        for (const BondLink& link : instance.structure->graph.linksOf(from.second)) {
            if (instance.isBroken(link.bond)) continue;
            if (link.node != kNone) reach(from.first, link.node);
            const MortarLink* const mortar = instance.structure->mortarOf(link.bond);
            if (link.node != kNone || mortar == nullptr) continue;
            const BondedInstance& other = m_instances.at(mortar->instance);
            if (!other.isBroken(mortar->bond)) {
                reach(mortar->instance, other.structure->graph.bonds[mortar->bond].first);
            }
        }
    }

    const std::map<Id, BondedInstance>& m_instances;
    std::set<Node> m_reached;
    std::deque<Node> m_waiting;
};

class HeldByAnchors : public Invariant {
public:
    const char* name() const override { return "held by anchors"; }
    std::optional<Fault> check(const StepFacts& step) override {
        const std::map<Id, BondedInstance> instances = bondedInstances(step.session, step.after);
        const AnchoredNodes anchored(instances, step.after);
        for (const auto& [id, instance] : instances) {
            std::set<std::uint32_t> held, reached, all;
            for (const auto& [node, number] : instance.bodyOf) {
                all.insert(number);
                if (step.after.find(number)->body.isHeld) held.insert(number);
                if (anchored.contains({id, node})) reached.insert(number);
            }
            for (const std::uint32_t number : all) {
                if (std::optional<Fault> fault = faultOf(step, number, reached.contains(number))) return fault;
            }
            if (instance.structure->holdsHeaviest && instance.structure->mortar.empty() && held.size() > 1) {
                return Fault{step.session.nameOf(step.after.find(*held.begin())->body),
                             std::to_string(held.size()) + " parts of it are held, though it touches nothing"};
            }
        }
        return unheldFault(step);
    }

private:
    static std::optional<Fault> faultOf(const StepFacts& step, std::uint32_t number, bool isReached) {
        const BodyFacts& facts = *step.after.find(number);
        const std::string name = step.session.nameOf(facts.body);
        if (facts.body.isHeld == facts.isDynamic()) {
            return Fault{name, facts.isDynamic() ? "it is held, and moves" : "it is not held, and does not move"};
        }
        if (facts.body.isHeld == isReached) return std::nullopt;
        return Fault{name, isReached ? "it reaches an anchor and is not held" : "it is held and reaches no anchor"};
    }

    /// Whatever is no fragment of a bonded whole is static only as the ground, or as a fixed instance.
    static std::optional<Fault> unheldFault(const StepFacts& step) {
        for (const BodyFacts& one : step.after.bodies) {
            const bool isPlaced = one.body.role == PlayRole::Ground || one.body.role == PlayRole::Instance;
            if (!one.isDynamic() && !isPlaced && !one.body.isHeld) {
                return Fault{step.session.nameOf(one.body), "it does not move, and nothing holds it"};
            }
        }
        return std::nullopt;
    }
};

class HeldStays : public Invariant {
public:
    const char* name() const override { return "held stays"; }
    void start(const Session&, const Moment& moment) override { m_held = heldNodes(moment); }

    std::optional<Fault> check(const StepFacts& step) override {
        for (const BodyFacts& one : step.after.bodies) {
            if (one.isDynamic() || one.body.role == PlayRole::Ground) continue;
            if (std::optional<Fault> fault = movedFault(step, one)) return fault;
            for (const std::uint32_t node : nodesOf(one.body)) {
                if (m_held.contains({one.body.origin, node})) continue;
                return Fault{step.session.nameOf(one.body), "it is held, and was free before"};
            }
        }
        m_held = heldNodes(step.after);
        return std::nullopt;
    }

private:
    using HeldNodes = std::set<std::pair<std::uint32_t, std::uint32_t>>;  // origin and node

    static std::vector<std::uint32_t> nodesOf(const PlayBody& body) {
        if (!body.nodes.empty()) return body.nodes;
        std::vector<std::uint32_t> nodes{kNone};
        const PlayFracture* const fracture = body.bondedFracture();
        for (std::uint32_t node = 0; fracture != nullptr && node < fracture->count; ++node) nodes.push_back(node);
        return nodes;
    }

    static HeldNodes heldNodes(const Moment& moment) {
        HeldNodes held;
        for (const BodyFacts& one : moment.bodies) {
            if (one.isDynamic() || one.body.asset == nullptr) continue;
            for (const std::uint32_t node : nodesOf(one.body)) held.insert({one.body.origin, node});
        }
        return held;
    }

    static std::optional<Fault> movedFault(const StepFacts& step, const BodyFacts& one) {
        const Instance* const instance =
            findInstance(step.session.scene().project, step.session.origins()[one.body.origin].instance);
        if (instance == nullptr) return std::nullopt;
        const Quat placed = glm::normalize(instance->pose.orientation);
        const Vec3 frame = one.state.pose.position - one.state.pose.orientation * frameOf(one.body);
        const double moved = glm::distance(frame, instance->pose.position);
        const double turned = 1.0 - std::abs(glm::dot(placed, one.state.pose.orientation));
        if (moved <= 1e-5 * (1.0 + glm::length(frame)) && turned <= 1e-6) return std::nullopt;
        return Fault{step.session.nameOf(one.body), "it is held and has moved by " + textOf(moved) + " m"};
    }

    HeldNodes m_held;
};

}  // namespace

std::unique_ptr<Invariant> heldByAnchors() { return std::make_unique<HeldByAnchors>(); }
std::unique_ptr<Invariant> heldStays() { return std::make_unique<HeldStays>(); }

}  // namespace rubble::soak
