#include "core/play/scene/PlayScene.h"

#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/checks/ValueFaults.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/project/Names.h"
#include "core/base/MessageText.h"
#include "core/play/scene/PlayMortar.h"
#include "core/play/scene/SupportProblems.h"

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

Error missing(const std::string& owner, Id asset) {
    return {ErrorCode::BadInput, owner + " is of asset " + std::to_string(asset) + ", which is not baked yet."};
}

/// Why a project is too large to be played.
std::optional<std::string> playSizeFault(const Project& project, const AssetBakes& bakes) {
    BakeEstimate all;
    for (const AssetVariant& variant : usedVariants(project)) {
        const auto baked = bakes.find(variant);
        if (baked == bakes.end()) continue;
        const BakeEstimate one = estimateOf(*baked->second);
        all.fragments += one.fragments;
        all.fractures += one.fractures;
        all.ofMeshes += one.ofMeshes;
        all.shrunk += one.shrunk;
        all.triangles += one.triangles;
    }
    std::optional<std::string> fault = stageFault(all, MemoryStage::Play);
    if (fault) fault->front() = 'S';
    return fault;
}

/// Checks that every asset in use is prepared.
Status checkAssets(const PlayScene& scene) {
    for (const Instance& instance : scene.project.instances) {
        if (!scene.assets.contains(variantOf(instance))) {
            return missing(ownerText("Instance", instance.id, instance.name), instance.asset);
        }
    }
    for (const Shot& shot : scene.project.shots) {
        const Throw* thrown = std::get_if<Throw>(&shot.action);
        if (thrown != nullptr && thrown->kind == ProjectileKind::Asset && !scene.assets.contains({thrown->asset})) {
            return missing(ownerText("Saved throw", shot.id, shot.name), thrown->asset);
        }
    }
    return success();
}

Status joinByMortar(PlayScene& scene, std::span<const FixedSolid> surroundings) {
    std::map<Id, MortarMember> members;
    for (const auto& [id, structure] : scene.structures) members[id] = {findInstance(scene.project, id), structure};
    Result<std::vector<JoinedMortar>> joined = addMortar(scene.project, surroundings, members);
    if (!joined) return joined.error();
    scene.mortars = std::move(*joined);
    for (std::size_t k = 0; k < scene.mortars.size(); ++k) {
        if (scene.mortars[k].isHeld) continue;
        Diagnostic idle;
        idle.code = DiagnosticCode::IdleMortar;
        idle.message = "Mortar " + quotedName(scene.project.mortars[k].name) +
                       " holds nothing: it joins no bonded instances of which one is anchored.";
        scene.diagnostics.push_back(std::move(idle));
    }
    for (auto& [id, member] : members) scene.structures[id] = std::move(member.structure);
    return success();
}

/// Whether bonds do not join all fragments of a structure, or of one at a level of an instance without strength.
bool hasUnjoinedStructures(const PlayScene& scene) {
    const auto isUnjoined = [](const auto& entry) { return !entry.second->isJoined; };
    const auto hasNoStrength = [](const Instance& instance) { return instance.bondStrength <= 0.0; };
    return std::ranges::any_of(scene.structures, isUnjoined) ||
           std::ranges::any_of(scene.assetStructures,
                               [&](const auto& entry) { return std::ranges::any_of(entry.second, isUnjoined); }) ||
           std::ranges::any_of(scene.project.instances, hasNoStrength);
}

}  // namespace

Status addStructures(PlayScene& scene) {
    const Project& project = scene.project;
    scene.assetStructures.clear();
    scene.structures.clear();
    scene.mortars.clear();
    for (const auto& [variant, ready] : scene.assets) {
        if (!ready->isBonded) continue;
        const Asset asset = variantOf(*findAsset(project, variant.asset), variant.variant);
        for (const BakedFracture& baked : ready->bake->fractures) {
            if (ready->fractureOf(baked.parent) == nullptr) continue;
            scene.assetStructures[variant][baked.parent] =
                playStructure(asset, *findMaterial(project, asset.material), ready, baked.parent);
        }
    }
    const std::vector<FixedSolid> surroundings = fixedSolids(project, scene.assets);
    for (const Instance& instance : project.instances) {
        const auto structures = scene.assetStructures.find(variantOf(instance));
        if (instance.isUnbreakable || structures == scene.assetStructures.end()) continue;
        const auto whole = structures->second.find(kNone);
        if (whole == structures->second.end()) continue;
        const Asset asset = variantOf(*findAsset(project, instance.asset), instance.variant);
        scene.structures[instance.id] =
            instanceStructure(*whole->second, asset, *findMaterial(project, asset.material), instance, surroundings);
    }
    if (!project.mortars.empty()) {
        if (const Status joined = joinByMortar(scene, surroundings); !joined) return joined;
    }
    for (const Instance& instance : project.instances) {
        const auto found = scene.structures.find(instance.id);
        if (found != scene.structures.end())
            found->second = withSupportLimits(found->second, instance, project.gravity);
    }
    scene.hasUnjoined = hasUnjoinedStructures(scene);
    return success();
}

std::shared_ptr<const PlayStructure> structureIn(const PlayScene& scene, const PlayOrigin& origin,
                                                 std::uint32_t fragment) {
    if (const auto own = scene.structures.find(origin.instance); fragment == kNone && own != scene.structures.end()) {
        return own->second;
    }
    const auto structures = scene.assetStructures.find({origin.asset, origin.variant});
    if (structures == scene.assetStructures.end()) return nullptr;
    const auto found = structures->second.find(fragment);
    if (found == structures->second.end()) return nullptr;
    const Instance* placed = findInstance(scene.project, origin.instance);
    if (placed == nullptr || placed->bondStrength == 1.0) return found->second;
    return strengthened(*found->second, placed->bondStrength);
}

Result<std::shared_ptr<const PlayScene>> playScene(const Project& project, const AssetBakes& bakes,
                                                   const TaskContext& task, FindContacts when) {
    if (const std::optional<std::string> fault = verifyProject(project)) return Error{ErrorCode::BadInput, *fault};
    auto scene = std::make_shared<PlayScene>();
    scene->project = project;
    if (const std::optional<std::string> fault = playSizeFault(project, bakes)) return Error{ErrorCode::Limit, *fault};
    for (const AssetVariant& variant : usedVariants(project)) {
        const auto baked = bakes.find(variant);
        if (baked == bakes.end()) continue;
        Asset asset = variantOf(*findAsset(project, variant.asset), variant.variant);
        if (project.damage.isThesis) asset.breakAs = BreakAs::Whole;
        Result<std::shared_ptr<const PlayAsset>> ready = playAsset(asset, baked->second, task, when);
        if (!ready) return ready.error();
        for (Diagnostic one : (*ready)->diagnostics) {
            one.message = ownerText("Asset", asset.id, asset.name) + ": " + one.message;
            scene->diagnostics.push_back(std::move(one));
        }
        scene->assets[variant] = std::move(*ready);
    }
    if (const Status checked = checkAssets(*scene); !checked) return checked.error();
    if (const Status added = addStructures(*scene); !added) return added.error();
    std::ranges::move(supportProblems(*scene), std::back_inserter(scene->diagnostics));
    return std::shared_ptr<const PlayScene>(std::move(scene));
}

Result<std::shared_ptr<const PlayScene>> playScene(const Project& project, const TaskContext& task) {
    if (const std::optional<std::string> fault = verifyProject(project)) return Error{ErrorCode::BadInput, *fault};
    const Result<AssetBakes> bakes = bakesOf(project, {}, task);
    if (!bakes) return bakes.error();
    return playScene(project, *bakes, task);
}

}  // namespace rubble
