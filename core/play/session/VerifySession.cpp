#include "core/play/session/VerifySession.h"

#include "core/asset/checks/PlayFaults.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/project/Ranges.h"
#include "core/play/breaking/ApplyDamage.h"
#include "core/play/scene/GroundHull.h"
#include "core/play/scene/Projectile.h"
#include "core/play/session/SessionInputs.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <set>

namespace rubble {
namespace {

using Fault = std::optional<std::string>;
using DamagedAssets = std::map<std::uint32_t, std::shared_ptr<const PlayAsset>>;  // by origin

constexpr std::uint64_t kMaxStep = std::uint64_t{1} << 53;

std::string elementOf(const char* table, std::size_t element, const std::string& what) {
    return std::string(table) + '[' + std::to_string(element) + "]" + what;
}

bool isGround(const PlayScene& scene, std::size_t index, const PlayOrigin& origin) {
    return scene.project.ground.isOn && index == 0 && origin.instance == 0 && origin.asset == 0 && !origin.thrown;
}

bool isKnown(ProjectileKind kind) { return kind >= ProjectileKind::Box && kind <= ProjectileKind::Asset; }

/// Whether an origin is what placeScene() and throws add.
bool isOrigin(const PlayScene& scene, std::size_t index, const PlayOrigin& origin) {
    const std::size_t first = scene.project.ground.isOn ? 1 : 0;
    if (index < first) return isGround(scene, index, origin);
    if (index - first < scene.project.instances.size()) {
        const Instance& instance = scene.project.instances[index - first];
        return origin.instance == instance.id && origin.name == instance.name && !origin.thrown &&
               AssetVariant{origin.asset, origin.variant} == variantOf(instance);
    }
    if (origin.instance != 0 || origin.variant != 0 || (origin.asset != 0) == origin.thrown.has_value()) return false;
    if (!origin.thrown) return scene.assets.contains({origin.asset});
    return isKnown(origin.thrown->kind) && origin.thrown->kind != ProjectileKind::Asset &&
           !faultOf(Shot{.name = origin.name, .action = *origin.thrown}) &&
           projectileBody(*origin.thrown, nullptr, nullptr).hasValue();
}

Fault verifyOrigins(const PlayScene& scene, const SessionState& state) {
    const std::size_t placed = scene.project.instances.size() + (scene.project.ground.isOn ? 1 : 0);
    if (state.origins.size() < placed) return "origins are fewer than the instances";
    for (std::size_t k = 0; k < state.origins.size(); ++k) {
        if (!isOrigin(scene, k, state.origins[k])) return elementOf("origins", k, " is not of the project");
    }
    return std::nullopt;
}

Fault verifyMaterials(const PlayScene& scene, const SessionState& state) {
    Project changed = scene.project;
    if (!std::ranges::equal(state.materials, changed.materials, {}, &Material::id, &Material::id)) {
        return "materials are not those of the project";
    }
    changed.materials = state.materials;
    if (const Fault fault = verifyProject(changed)) return "materials are out of range: " + *fault;
    for (const auto* thresholds : {&state.assetThresholds, &state.instanceThresholds}) {
        for (const auto& [id, threshold] : *thresholds) {
            if (threshold <= 0.0) return "thresholds of " + std::to_string(id) + " are not above 0";
        }
    }
    if (!std::ranges::equal(
            state.assetThresholds, scene.project.assets, {}, [](const auto& one) { return one.first; }, &Asset::id)) {
        return "assetThresholds are not of the project's assets";
    }
    for (const auto& [id, threshold] : state.instanceThresholds) {
        if (findInstance(scene.project, id) == nullptr) {
            return "instanceThresholds are of the missing instance " + std::to_string(id);
        }
    }
    return std::nullopt;
}

/// Makes what the damages are of.
Fault prepareDamage(const PlayScene& scene, const SessionState& state, DamagedAssets& assets) {
    for (const auto& [index, damage] : state.damage) {
        const std::string place = "damage[" + std::to_string(index) + "]";
        if (index >= state.origins.size() || state.origins[index].asset == 0) return place + " is of no asset";
        if (damage.kind != DamageKind::Fractures) return place + ".kind is unknown";
        if (damage.isIntact()) return place + " has nothing broken";
        const PlayOrigin& origin = state.origins[index];
        Result<std::shared_ptr<const PlayAsset>> asset = damagedAsset(scene, {origin.asset, origin.variant}, damage);
        if (!asset) return place + " is wrong: " + asset.error().message;
        assets[index] = std::move(*asset);
    }
    return std::nullopt;
}

/// Gives the structures what follows from their origins, without the bodies of their nodes.
Fault completeStructures(const PlayScene& scene, SessionState& state) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> solids;
    for (std::size_t k = 0; k < state.structures.size(); ++k) {
        StructureState& one = state.structures[k];
        if (one.origin >= state.origins.size()) return elementOf("structures", k, ".origin is wrong");
        one.structure = structureIn(scene, state.origins[one.origin], one.parent);
        if (one.structure == nullptr) return elementOf("structures", k, ".parent has no bonds");
        if (!solids.emplace(one.origin, one.parent).second) return elementOf("structures", k, " is there twice");
        if (one.damage.size() != one.structure->graph.bondCount()) {
            return elementOf("structures", k, ".damage is not of its bonds");
        }
        for (std::size_t bond = 0; bond < one.damage.size(); ++bond)
            one.damage[bond] = std::max(one.damage[bond], one.structure->initialDamage[bond]);
        one.bodyOfNode.assign(one.structure->nodeCount(), kNone);
    }
    return std::nullopt;
}

/// The structure of the solid of an origin; null if none of its bonds was damaged.
StructureState* findStructure(SessionState& state, std::uint32_t origin, std::uint32_t parent) {
    const auto found = std::ranges::find_if(
        state.structures, [&](const StructureState& one) { return one.origin == origin && one.parent == parent; });
    return found != state.structures.end() ? &*found : nullptr;
}

/// Gives the nodes of a structure to a body that consists of them. Returns the field that is wrong.
const char* completeNodes(SessionState& state, const PlayBody& body) {
    if (body.structure >= state.structures.size()) return "structure";
    StructureState& structure = state.structures[body.structure];
    if (structure.origin != body.origin || structure.parent != body.fragment) return "structure";
    if (body.nodes.empty() || (body.nodes.size() == 1 && !body.isHeld)) return "nodes";
    for (std::size_t k = 0; k < body.nodes.size(); ++k) {
        const std::uint32_t node = body.nodes[k];
        if (node >= structure.bodyOfNode.size() || (k > 0 && body.nodes[k - 1] >= node)) return "nodes";
        if (structure.bodyOfNode[node] != kNone) return "nodes";
        structure.bodyOfNode[node] = body.number;
    }
    return nullptr;
}

/// Completes a body of an asset that breaks along bonds. Returns the field that is wrong.
const char* completeBonded(const PlayScene& scene, SessionState& state, const PlayBody& body) {
    if (body.fragment != kNone && body.fragment >= body.asset->fragments.size()) return "fragment";
    if (body.collapseStep != PlayBody::kNever && !body.isHeld) return "collapseStep";
    if (body.structure != kNone) return completeNodes(state, body);
    if (!body.nodes.empty()) return "nodes";
    if (findStructure(state, body.origin, body.fragment) != nullptr) return "structure";
    if (body.fragment != kNone) {
        const std::uint32_t from = fractureContaining(*body.asset, body.fragment);
        if (from == kNone) return "fragment";
        const std::uint32_t parent = brokenFragments(*body.asset)[from];
        if (findStructure(state, body.origin, parent) == nullptr) return "fragment";
        return body.isHeld ? "isHeld" : nullptr;
    }
    const auto structure = scene.structures.find(state.origins[body.origin].instance);
    const bool isHeld =
        body.role == PlayRole::Instance && structure != scene.structures.end() && structure->second->isHeld();
    return body.isHeld == isHeld ? nullptr : "isHeld";
}

/// Whether a fragment is free: it came free, and has not broken itself. kNone: the whole.
bool isFree(const PlayAsset& asset, std::uint32_t fragment, const InstanceDamage* damage) {
    const auto isBroken = [&](std::uint32_t fracture) {
        return damage != nullptr && fracture != kNone && damage->broken[fracture];
    };
    if (fragment == kNone) return !isBroken(asset.whole.fracture);
    if (damage == nullptr || fragment >= asset.fragments.size()) return false;
    return isBroken(fractureContaining(asset, fragment)) && !isBroken(asset.fragments[fragment].fracture);
}

/// Whether a body is bonded fragments of a whole that came off it.
bool isDebrisOfNodes(const PlayBody& body) {
    return body.role == PlayRole::Debris && body.structure != kNone && body.fragment == kNone;
}

/// Whether a body has nothing of what only bonded ones have.
bool isPlain(const PlayBody& body) {
    return body.structure == kNone && body.nodes.empty() && !body.isHeld && body.collapseStep == PlayBody::kNever;
}

/// Gives a body its asset or hull. Returns the field that is wrong.
const char* completeBody(const PlayScene& scene, SessionState& state, const DamagedAssets& assets, PlayBody& body) {
    const PlayOrigin& origin = state.origins[body.origin];
    const bool isOfGround = isGround(scene, body.origin, origin);
    if (body.role > PlayRole::Debris || (body.role == PlayRole::Ground) != isOfGround) return "role";
    if (body.role == PlayRole::Instance ? origin.instance == 0
                                        : body.role == PlayRole::Projectile && origin.instance != 0) {
        return "role";
    }
    if ((body.role == PlayRole::Debris) != (body.fragment != kNone || isDebrisOfNodes(body))) return "fragment";
    bool isUnbreakable = false;
    if (body.role == PlayRole::Instance) {
        isUnbreakable = findInstance(scene.project, origin.instance)->isUnbreakable;
    }
    if (body.isUnbreakable != isUnbreakable) return "isUnbreakable";
    if (origin.asset == 0) {
        body.hull = isOfGround ? groundHull() : std::make_shared<const Polytope>(projectileHull(*origin.thrown));
        if (body.fragment != kNone) return "fragment";
        return isPlain(body) ? nullptr : "structure";
    }
    const auto damage = state.damage.find(body.origin);
    const bool isDamaged = damage != state.damage.end();
    body.asset = isDamaged ? assets.at(body.origin) : scene.assets.at({origin.asset, origin.variant});
    if (body.asset->isBonded) return completeBonded(scene, state, body);
    if (!isPlain(body)) return "structure";
    if (!isFree(*body.asset, body.fragment, isDamaged ? &damage->second : nullptr)) return "fragment";
    return nullptr;
}

/// Whether a fragment that is a body by itself is a node of another one.
bool isBonded(SessionState& state, const PlayBody& body) {
    if (body.asset == nullptr || !body.asset->isBonded || body.fragment == kNone || isDebrisOfNodes(body)) return false;
    const std::uint32_t from = fractureContaining(*body.asset, body.fragment);
    const StructureState* const structure = findStructure(state, body.origin, brokenFragments(*body.asset)[from]);
    return structure != nullptr && structure->bodyOfNode[body.fragment - body.asset->fractures[from].first] != kNone;
}

Fault completeBodies(const PlayScene& scene, const DamagedAssets& assets, SessionState& state) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> solids;
    for (std::size_t k = 0; k < state.bodies.size(); ++k) {
        PlayBody& body = state.bodies[k];
        const bool isAscending = k == 0 || state.bodies[k - 1].number < body.number;
        if (!isAscending || body.number >= state.nextNumber) return elementOf("bodies", k, ".number is wrong");
        if (body.origin >= state.origins.size()) return elementOf("bodies", k, ".origin is wrong");
        if (body.born > state.step) return elementOf("bodies", k, ".born is wrong");
        if (const char* field = completeBody(scene, state, assets, body)) {
            return elementOf("bodies", k, "." + std::string(field) + " is wrong");
        }
        const bool isSolid = body.structure == kNone;
        if (isSolid && !solids.emplace(body.origin, body.fragment).second) {
            return elementOf("bodies", k, " is there twice");
        }
    }
    for (std::size_t k = 0; k < state.bodies.size(); ++k) {
        if (isBonded(state, state.bodies[k])) return elementOf("bodies", k, ".fragment is bonded in another body");
    }
    return std::nullopt;
}

/// An input as if the body that it acts on were there: it may have gone since the input was added.
PlayInput withBody(PlayInput input, const SessionState& state) {
    if (state.bodies.empty()) return ReleaseInput{};
    if (auto* grab = std::get_if<GrabInput>(&input)) grab->body = state.bodies.front().number;
    if (auto* broken = std::get_if<BreakInput>(&input)) broken->body = state.bodies.front().number;
    return input;
}

/// Whether the enumerations in an input have values that exist.
bool hasKnownKinds(const PlayInput& input) {
    const auto* shot = std::get_if<ShotInput>(&input);
    const Throw* thrown = shot != nullptr ? std::get_if<Throw>(&shot->action) : nullptr;
    return thrown == nullptr || isKnown(thrown->kind);
}

Fault verifyPending(const PlayScene& scene, const SessionState& state) {
    std::uint64_t last = state.step;
    for (std::size_t k = 0; k < state.pending.size(); ++k) {
        const TimedInput& timed = state.pending[k];
        if (timed.step < last) return elementOf("pending", k, ".step is in the past");
        last = timed.step;
        if (!hasKnownKinds(timed.input)) return elementOf("pending", k, " is of an unknown kind");
        if (const Fault fault = faultOf(withBody(timed.input, state), scene, state)) {
            return elementOf("pending", k, " is wrong: ") + *fault;
        }
    }
    return std::nullopt;
}

Fault verifyReportedImpacts(const SessionState& state) {
    for (std::size_t k = 0; k < state.reportedImpacts.size(); ++k) {
        const ReportedImpact& one = state.reportedImpacts[k];
        const auto isBefore = [](const ReportedImpact& a, const ReportedImpact& b) {
            return std::pair(a.first, a.second) < std::pair(b.first, b.second);
        };
        const bool isAscending = k == 0 || isBefore(state.reportedImpacts[k - 1], one);
        if (!isAscending || one.first >= one.second) return elementOf("reportedImpacts", k, " is not in order");
        if (one.apartSince != ReportedImpact::kTouching && one.apartSince > state.step) {
            return elementOf("reportedImpacts", k, ".apartSince is wrong");
        }
    }
    return std::nullopt;
}

}  // namespace

Fault completeState(const PlayScene& scene, SessionState& state) {
    if (state.step > kMaxStep) return "step is wrong";
    if (Fault fault = verifyOrigins(scene, state)) return fault;
    if (Fault fault = verifyMaterials(scene, state)) return fault;
    DamagedAssets assets;
    if (Fault fault = prepareDamage(scene, state, assets)) return fault;
    if (Fault fault = completeStructures(scene, state)) return fault;
    if (Fault fault = completeBodies(scene, assets, state)) return fault;
    if (Fault fault = verifyReportedImpacts(state)) return fault;
    return verifyPending(scene, state);
}

}  // namespace rubble
