#include "core/play/scene/PlayMortar.h"

#include "core/base/MessageText.h"
#include "core/play/scene/JoinedSupport.h"
#include "core/play/scene/SupportSpread.h"
#include "core/structure/graph/Support.h"

#include <algorithm>
#include <set>
#include <utility>

namespace rubble {
namespace {

/// The fragments of several instances, in the world.
struct MortarNodes {
    struct Place {
        Id instance = 0;
        std::uint32_t node = 0;  // of its structure
        auto operator<=>(const Place&) const = default;
    };
    std::vector<MortarNode> nodes;
    std::vector<Place> places;  // of each node
};

void addNodes(const MortarMember& member, MortarNodes& all) {
    const Id instance = member.instance->id;
    std::vector<MortarNode> nodes = mortarNodes(*member.structure, instance, poseOf(*member.instance));
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        all.nodes.push_back(std::move(nodes[node]));
        all.places.push_back({instance, node});
    }
}

/// A bond in the world, as an anchor of a node of an instance. `side`: 1 for the bond's first node, -1 for the second.
Bond anchorOf(const Bond& bond, std::uint32_t node, const Instance& instance, double side) {
    const Pose pose = poseOf(instance);
    const Quat back = glm::conjugate(pose.orientation);
    const Mat3 turn = glm::mat3_cast(back);
    Bond anchor = bond;
    anchor.first = node;
    anchor.second = kNone;
    anchor.centroid = back * (bond.centroid - pose.position);
    anchor.normal = back * (side * bond.normal);
    anchor.moments = turn * bond.moments * glm::transpose(turn);
    return anchor;
}

MortarJoint jointOf(const Bond& bond, const MortarNodes::Place& first, const MortarNodes::Place& second) {
    return {first.instance, second.instance, {first.node, second.node}, bond.area, bond.centroid,
            bond.normal,    bond.moments};
}

/// What mortar adds to a structure.
struct AddedAnchors {
    std::vector<Bond> bonds;
    std::vector<double> capacities;
    std::vector<MortarLink> links;
};

/// The mortar between instances.
class MortarJoints {
public:
    explicit MortarJoints(const std::map<Id, MortarMember>& members) : m_members(members) {
        for (const auto& [id, member] : members) m_added[id];
    }

    /// Adds the joints of a mortar where no earlier one has any, and returns them. Errors: Limit.
    Result<std::vector<MortarJoint>> add(const Mortar& mortar, std::span<const FixedSolid> surroundings) {
        const auto isJoined = [&](Id instance) {
            return mortar.instances.empty() || std::ranges::binary_search(mortar.instances, instance);
        };
        MortarNodes all;
        for (const auto& [id, member] : m_members) {
            if (isJoined(id)) addNodes(member, all);
        }
        std::vector<Polytope> supports;
        for (const FixedSolid& solid : surroundings) {
            if (solid.instance == 0 || !isJoined(solid.instance)) continue;
            supports.insert(supports.end(), solid.hulls.begin(), solid.hulls.end());
        }
        std::vector<MortarJoint> joined;
        const std::vector<Bond> bonds = mortarBonds(all.nodes, mortar.tolerance, mortar.leastArea, &m_budget);
        if (m_budget == 0) return tooManyPairs(mortar);
        for (const Bond& bond : bonds) {
            const MortarNodes::Place &first = all.places[bond.first], &second = all.places[bond.second];
            if (!m_joined.emplace(first, second).second) continue;
            const std::uint32_t ofFirst = add(first, bond, 1.0, mortar.impulsePerArea);
            const std::uint32_t ofSecond = add(second, bond, -1.0, mortar.impulsePerArea);
            m_added[first.instance].links[ofFirst] = {second.instance, ofSecond};
            m_added[second.instance].links[ofSecond] = {first.instance, ofFirst};
            joined.push_back(jointOf(bond, first, second));
        }
        for (const Bond& bond : anchorBonds(all.nodes, supports, mortar.tolerance, mortar.leastArea)) {
            add(all.places[bond.first], bond, 1.0, mortar.impulsePerArea);
            joined.push_back(jointOf(bond, all.places[bond.first], {0, kNone}));
        }
        return joined;
    }

    const std::map<Id, AddedAnchors>& added() const { return m_added; }

private:
    static Error tooManyPairs(const Mortar& mortar) {
        return {ErrorCode::Limit, "Mortar " + quotedName(mortar.name) +
                                      ", with those before it, would look for joints between more than " +
                                      std::to_string(kMaxMortarPairs) +
                                      " pairs of fragments. Move apart the instances that stand in each other, lower "
                                      "its tolerance, or let fewer mortars join the same instances."};
    }
    /// Returns the index of the link.
    std::uint32_t add(const MortarNodes::Place& place, const Bond& bond, double side, double impulsePerArea) {
        AddedAnchors& added = m_added[place.instance];
        added.bonds.push_back(anchorOf(bond, place.node, *m_members.at(place.instance).instance, side));
        added.capacities.push_back(impulsePerArea * bond.area);
        added.links.emplace_back();
        return static_cast<std::uint32_t>(added.links.size()) - 1;
    }

    const std::map<Id, MortarMember>& m_members;
    std::map<Id, AddedAnchors> m_added;
    std::set<std::pair<MortarNodes::Place, MortarNodes::Place>> m_joined;
    std::size_t m_budget = kMaxMortarPairs;
};

/// The instances that are anchored, themselves or through mortar.
std::set<Id> anchoredThroughMortar(const std::map<Id, MortarMember>& members, const MortarJoints& joints) {
    std::set<Id> anchored;
    std::vector<Id> next;
    const auto reach = [&](Id instance) {
        if (anchored.insert(instance).second) next.push_back(instance);
    };
    for (const auto& [id, member] : members) {
        const auto isFixed = [](const MortarLink& link) { return link.instance == 0; };
        if (member.structure->isHeld() || std::ranges::any_of(joints.added().at(id).links, isFixed)) reach(id);
    }
    while (!next.empty()) {
        const Id instance = next.back();
        next.pop_back();
        for (const MortarLink& link : joints.added().at(instance).links) {
            if (link.instance != 0) reach(link.instance);
        }
    }
    return anchored;
}

/// Gives structures the instances that mortar joins with theirs.
void addJoined(const std::map<Id, std::shared_ptr<PlayStructure>>& structures) {
    for (const auto& [id, structure] : structures) {
        if (structure->joined != nullptr) continue;
        const auto joined = std::make_shared<std::vector<Id>>();
        std::vector<Id> open{id};
        structure->joined = joined;
        while (!open.empty()) {
            joined->push_back(open.back());
            const PlayStructure& one = *structures.at(open.back());
            open.pop_back();
            for (const MortarLink& link : one.mortar) {
                if (link.instance == 0 || structures.at(link.instance)->joined != nullptr) continue;
                structures.at(link.instance)->joined = joined;
                open.push_back(link.instance);
            }
        }
        std::ranges::sort(*joined);
    }
}

/// Prepares how support spreads in a structure that mortar joins.
void addSteps(PlayStructure& structure, const Instance& instance, Vec3 gravity) {
    if (structure.span <= 0.0 || gravity == Vec3(0.0)) return;
    const BondGraph& graph = structure.graph;
    structure.up = upIn(poseOf(instance), gravity);
    for (std::uint32_t node = 0; node < graph.nodeCount(); ++node) {
        for (const BondLink& link : graph.linksOf(node))
            structure.steps.push_back(link.node == kNone ? 0.0 : sidewaysStep(graph, node, link, structure.up));
    }
}

/// Adds how structures that mortar joins are supported, group by group.
void addSupport(const std::map<Id, std::shared_ptr<PlayStructure>>& structures,
                const std::map<Id, MortarMember>& members, Vec3 gravity) {
    if (gravity == Vec3(0.0)) return;
    for (const auto& [first, structure] : structures) {
        if (structure->joined->front() != first) continue;
        std::map<Id, JoinedStructure> joined;
        for (const Id id : *structure->joined)
            joined[id] = joinedAtStart(*structures.at(id), upIn(poseOf(*members.at(id).instance), gravity));
        const auto hasSpan = [](const auto& entry) { return entry.second.structure->hasSpan(); };
        if (std::ranges::none_of(joined, hasSpan)) continue;
        NodeFractions limits = joinedSupportLimits(joined);
        const auto support = std::make_shared<const SupportSpread>(joined, limits);
        for (const Id id : *structure->joined) {
            structures.at(id)->supportAtStart = support;
            if (structures.at(id)->hasSpan()) structures.at(id)->supportLimits = std::move(limits.at(id));
        }
    }
}

/// A structure with the mortar that `joints` adds to it. The links lead to bonds among the added ones of the others,
/// whose structures have `firstMortar` bonds without them.
std::shared_ptr<PlayStructure> withMortar(const PlayStructure& structure, const AddedAnchors& added,
                                          const std::map<Id, std::uint32_t>& firstMortar) {
    auto made = std::make_shared<PlayStructure>(structure);
    std::vector<Bond> bonds = structure.graph.bonds;
    bonds.insert(bonds.end(), added.bonds.begin(), added.bonds.end());
    std::vector<double> capacities = structure.capacities;
    capacities.insert(capacities.end(), added.capacities.begin(), added.capacities.end());
    made->graph = bondGraph(structure.graph.centres, std::move(bonds));
    made->setCapacities(std::move(capacities));
    made->mortar = added.links;
    for (MortarLink& link : made->mortar) {
        if (link.instance != 0) link.bond += firstMortar.at(link.instance);
    }
    return made;
}

}  // namespace

JoinedGroups joinedGroups(const std::map<Id, std::shared_ptr<const PlayStructure>>& structures,
                          const std::set<Id>& instances) {
    JoinedGroups groups;
    for (const Id instance : instances) {
        const auto structure = structures.find(instance);
        if (structure == structures.end() || structure->second->joined == nullptr) continue;
        groups.emplace(structure->second->joined->front(), structure->second->joined);
    }
    return groups;
}

Result<std::vector<JoinedMortar>> addMortar(const Project& project, std::span<const FixedSolid> surroundings,
                                            std::map<Id, MortarMember>& members) {
    MortarJoints joints(members);
    std::vector<JoinedMortar> joined;
    for (const Mortar& mortar : project.mortars) {
        Result<std::vector<MortarJoint>> added = joints.add(mortar, surroundings);
        if (!added) return added.error();
        joined.push_back({mortar.id, std::move(*added)});
    }
    const std::set<Id> anchored = anchoredThroughMortar(members, joints);
    std::map<Id, std::uint32_t> firstMortar;
    for (const auto& [id, member] : members) firstMortar[id] = member.structure->graph.bondCount();
    std::map<Id, std::shared_ptr<PlayStructure>> made;
    for (auto& [id, member] : members) {
        const AddedAnchors& added = joints.added().at(id);
        if (!anchored.contains(id) || added.bonds.empty()) continue;
        made[id] = withMortar(*member.structure, added, firstMortar);
        addSteps(*made[id], *member.instance, project.gravity);
        member.structure = made[id];
    }
    addJoined(made);
    addSupport(made, members, project.gravity);
    const auto isOfAnchored = [&](const MortarJoint& joint) { return anchored.contains(joint.first); };
    for (JoinedMortar& one : joined) one.isHeld = std::ranges::any_of(one.joints, isOfAnchored);
    return joined;
}

}  // namespace rubble
