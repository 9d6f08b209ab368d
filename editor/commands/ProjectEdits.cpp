#include "editor/commands/ProjectEdits.h"

#include "core/asset/project/AssetShape.h"
#include "core/asset/project/Ids.h"
#include "core/asset/project/Names.h"
#include "core/asset/strength/Threshold.h"
#include "core/fracture/pattern/PatternKind.h"
#include "editor/commands/AssetPatterns.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {

namespace {

constexpr double kDefaultDensity = 2400.0;      // kg/m³, stone
constexpr std::uint32_t kSeedsPerFragment = 4;  // of a new level
constexpr double kDefaultShotTime = 0.5;        // s after the start
constexpr double kGapBetweenAssets = 0.25;      // m, between a new asset and the scene

struct ProjectEditsTexts {
    Q_DECLARE_TR_FUNCTIONS(ProjectEdits)
};

template <class Value>
const Value& elementWith(const std::vector<Value>& elements, Id id) {
    return *std::ranges::find(elements, id, &Value::id);
}

template <class Value>
void addRemoval(Id id, Edit& edit) {
    edit.replacements.push_back(Replacement<Value>{id, std::nullopt});
}

/// The largest horizontal extent of an asset from its axis, at any rotation about the vertical, m.
double horizontalExtent(const Asset& asset) {
    if (const ClosedMesh* mesh = asset.mesh()) {
        double extent = 0.0;
        for (int k = 0; k < 8; ++k) {
            const Vec3 corner = mesh->bounds.corner(k);
            extent = std::max(extent, std::hypot(corner.x, corner.z));
        }
        return extent;
    }
    double extent = asset.prism().depth / 2.0;
    for (const Vec2 corner : asset.prism().outline.outer) extent = std::max(extent, std::abs(corner.x));
    return extent;
}

/// Upright on the ground, to the right of all instances.
Pose poseBesideScene(const Project& project, const Asset& asset) {
    double right = -horizontalExtent(asset) - kGapBetweenAssets;
    for (const Instance& instance : project.instances) {
        const Asset& other = elementWith(project.assets, instance.asset);
        right = std::max(right, instance.pose.position.x + horizontalExtent(other));
    }
    const double bottom = boundsOf(asset).min.y;
    return {.position = {right + kGapBetweenAssets + horizontalExtent(asset), project.ground.height - bottom, 0.0}};
}

/// Removes expectations on removed instances, and removed shots, from the play-tests.
void removeFromPlayTests(const Project& project, std::span<const Id> instances, std::span<const Id> shots, Edit& edit) {
    for (const PlayTest& test : project.playTests) {
        PlayTest rest = test;
        std::erase_if(rest.shots, [&](Id shot) { return isAmong(shots, shot); });
        std::erase_if(rest.expectations,
                      [&](const Expectation& expectation) { return isAmong(instances, expectation.instance); });
        std::erase_if(rest.removed, [&](const InstancePart& part) { return isAmong(instances, part.instance); });
        if (rest != test) edit.replacements.push_back(Replacement<PlayTest>{rest.id, std::move(rest)});
    }
}

/// Removes instances from the mortars that name them, and mortars that name no other, which would join all.
void removeFromMortars(const Project& project, std::span<const Id> instances, Edit& edit) {
    for (const Mortar& mortar : project.mortars) {
        Mortar rest = mortar;
        std::erase_if(rest.instances, [&](Id instance) { return isAmong(instances, instance); });
        if (rest == mortar) continue;
        if (rest.instances.empty()) {
            addRemoval<Mortar>(mortar.id, edit);
        } else {
            edit.replacements.push_back(Replacement<Mortar>{rest.id, std::move(rest)});
        }
    }
}

std::vector<Id> shotsThrowing(const Project& project, std::span<const Id> assets) {
    std::vector<Id> shots;
    for (const Shot& shot : project.shots) {
        const auto* thrown = std::get_if<Throw>(&shot.action);
        if (thrown && thrown->kind == ProjectileKind::Asset && isAmong(assets, thrown->asset)) shots.push_back(shot.id);
    }
    return shots;
}

Id appendMaterial(const Project& project, const std::string& name, Edit& edit) {
    const Id id = edit.allocateId(project);
    edit.replacements.push_back(Replacement<Material>{
        id, Material{.id = id, .name = uniqueName(project.materials, name), .density = kDefaultDensity}});
    return id;
}

Id appendShot(const Project& project, const std::string& name, const ShotAction& action, Edit& edit) {
    const Id id = edit.allocateId(project);
    const Shot shot{.id = id, .name = uniqueName(project.shots, name), .time = kDefaultShotTime, .action = action};
    edit.replacements.push_back(Replacement<Shot>{id, shot});
    return id;
}

/// The project's first material; adds one if there is none.
Id firstOrNewMaterial(const Project& project, Edit& edit) {
    return project.materials.empty() ? appendMaterial(project, "stone", edit) : project.materials.front().id;
}

Id appendInstance(const Project& project, const Asset& asset, Edit& edit) {
    const Id id = edit.allocateId(project);
    edit.replacements.push_back(Replacement<Instance>{id, Instance{.id = id,
                                                                   .name = uniqueName(project.instances, asset.name),
                                                                   .asset = asset.id,
                                                                   .pose = poseBesideScene(project, asset)}});
    return id;
}

/// Adds replacements for the elements that differ between two lists.
template <class Value>
void addDifferences(const std::vector<Value>& from, const std::vector<Value>& to, Edit& edit) {
    for (const Value& value : to) {
        const auto before = std::ranges::find(from, value.id, &Value::id);
        if (before == from.end() || !(*before == value))
            edit.replacements.push_back(Replacement<Value>{value.id, value});
    }
    for (const Value& value : from) {
        if (std::ranges::find(to, value.id, &Value::id) == to.end()) addRemoval<Value>(value.id, edit);
    }
}

/// Gives layers fresh ids and records the mapping; equal ids stay equal.
void replaceLayerIds(const Project& project, Pattern& pattern, Edit& edit, std::map<Id, Id>& layers) {
    for (PatternLayer& layer : pattern.layers) {
        const auto [known, isNew] = layers.try_emplace(layer.id, 0);
        if (isNew) known->second = edit.allocateId(project);
        layer.id = known->second;
    }
}

/// Updates the fragment names of an asset whose layer ids were replaced.
void renameFragments(const std::map<Id, Id>& layers, Asset& asset) {
    for (FragmentLevel& leaf : asset.fragmentLevels) leaf.fragment = withLayers(leaf.fragment, layers);
    std::ranges::sort(asset.fragmentLevels, {}, &FragmentLevel::fragment);
    for (FragmentThreshold& own : asset.fragmentThresholds) own.fragment = withLayers(own.fragment, layers);
    std::ranges::sort(asset.fragmentThresholds, {}, &FragmentThreshold::fragment);
    for (FragmentPath& path : asset.bonding.neverBreaks) path = withLayers(path, layers);
    std::ranges::sort(asset.bonding.neverBreaks);
    for (FragmentCluster& cluster : asset.bonding.clusters) {
        for (FragmentPath& path : cluster.fragments) path = withLayers(path, layers);
    }
    sortClusters(asset.bonding.clusters);
    for (FragmentEdit& edit : asset.edits) {
        if (auto* split = std::get_if<FragmentSplit>(&edit)) {
            split->fragment = withLayers(split->fragment, layers);
            continue;
        }
        auto& merge = std::get<FragmentMerge>(edit);
        merge.into = withLayers(merge.into, layers);
        for (FragmentPath& path : merge.merged) path = withLayers(path, layers);
    }
}

/// Whether an asset has the pattern that addAsset() gave it, to which nothing refers.
bool hasNewPattern(const Asset& asset) {
    const auto& layers = asset.pattern.layers;
    if (layers.size() != 1 || !asset.edits.empty() || !asset.fragmentLevels.empty() ||
        !asset.fragmentThresholds.empty() || !asset.bonding.clusters.empty())
        return false;
    const PatternLayer given{.id = layers[0].id, .randomSeed = layers[0].id, .parameters = UniformScatter{}};
    return layers[0] == given;
}

/// Whether a layer of a kind fractures an asset alone, when it is added: not what only changes the seeds of others, nor
/// what is drawn by hand.
bool isWholePattern(const PatternKind& kind) {
    const bool isMade = kind.role == LayerRole::Scatters || kind.role == LayerRole::Cuts;
    return isMade && kind.elementCount == nullptr && &kind != &kindOf(UniformScatter{});  // of which one wants more
}

}  // namespace

Edit editBetween(const QString& text, const Project& from, const Project& to) {
    Edit edit{.text = text};
    addDifferences(from.materials, to.materials, edit);
    addDifferences(from.assets, to.assets, edit);
    addDifferences(from.instances, to.instances, edit);
    addDifferences(from.shots, to.shots, edit);
    addDifferences(from.playTests, to.playTests, edit);
    addDifferences(from.mortars, to.mortars, edit);
    if (sceneSettings(from) != sceneSettings(to)) edit.replacements.push_back(sceneSettings(to));
    if (from.nextId != to.nextId) edit.nextId = to.nextId;
    return edit;
}

Addition addAsset(const Project& project, const std::string& name, const Prism& prism) {
    Addition addition{{.text = ProjectEditsTexts::tr("Add Asset")}};
    Asset asset{.name = uniqueName(project.assets, name), .shape = prism};
    asset.material = firstOrNewMaterial(project, addition.edit);
    if (const Material* material = findMaterial(project, asset.material)) deriveThresholdIfKnown(asset, *material);
    asset.id = addition.id = addition.edit.allocateId(project);
    const Id layer = addition.edit.allocateId(project);
    asset.pattern.layers = {{.id = layer, .randomSeed = layer, .parameters = UniformScatter{}}};
    appendInstance(project, asset, addition.edit);
    addition.edit.replacements.push_back(Replacement<Asset>{addition.id, std::move(asset)});
    return addition;
}

Addition duplicateAsset(const Project& project, Id source) {
    Addition addition{{.text = ProjectEditsTexts::tr("Duplicate Asset")}};
    Asset copy = elementWith(project.assets, source);
    copy.name = uniqueName(project.assets, copy.name);
    copy.id = addition.id = addition.edit.allocateId(project);
    std::map<Id, Id> layers;
    replaceLayerIds(project, copy.pattern, addition.edit, layers);
    for (Level& level : copy.levels) replaceLayerIds(project, level.pattern, addition.edit, layers);
    for (FragmentLevel& leaf : copy.fragmentLevels) {
        if (leaf.level) replaceLayerIds(project, leaf.level->pattern, addition.edit, layers);
    }
    renameFragments(layers, copy);
    addition.edit.replacements = {Replacement<Asset>{addition.id, std::move(copy)}};
    return addition;
}

Edit removeAssets(const Project& project, std::span<const Id> assets) {
    const int count = static_cast<int>(assets.size());
    Edit edit{.text = ProjectEditsTexts::tr("Delete %n Asset(s)", nullptr, count)};
    std::vector<Id> instances;
    for (const Instance& instance : project.instances) {
        if (isAmong(assets, instance.asset)) instances.push_back(instance.id);
    }
    const std::vector<Id> shots = shotsThrowing(project, assets);
    for (const Id id : assets) addRemoval<Asset>(id, edit);
    for (const Id id : instances) addRemoval<Instance>(id, edit);
    for (const Id id : shots) addRemoval<Shot>(id, edit);
    removeFromPlayTests(project, instances, shots, edit);
    removeFromMortars(project, instances, edit);
    return edit;
}

Addition addMaterial(const Project& project, const std::string& name) {
    Addition addition{{.text = ProjectEditsTexts::tr("Add Material")}};
    addition.id = appendMaterial(project, name, addition.edit);
    return addition;
}

Addition duplicateMaterial(const Project& project, Id source) {
    Addition addition{{.text = ProjectEditsTexts::tr("Duplicate Material")}};
    Material copy = elementWith(project.materials, source);
    copy.name = uniqueName(project.materials, copy.name);
    copy.id = addition.id = addition.edit.allocateId(project);
    addition.edit.replacements = {Replacement<Material>{addition.id, std::move(copy)}};
    return addition;
}

Edit removeMaterial(const Project& project, Id material) {
    Edit edit{.text = ProjectEditsTexts::tr("Delete Material")};
    const auto other = std::ranges::find_if(project.materials, [&](const Material& m) { return m.id != material; });
    if (other == project.materials.end()) return edit;
    addRemoval<Material>(material, edit);
    for (Asset asset : project.assets) {
        if (asset.material != material && asset.insideMaterial != material) continue;
        if (asset.material == material) asset.material = other->id;
        if (asset.insideMaterial == material) asset.insideMaterial = 0;
        edit.replacements.push_back(Replacement<Asset>{asset.id, std::move(asset)});
    }
    return edit;
}

Addition addInstance(const Project& project, Id asset) {
    Addition addition{{.text = ProjectEditsTexts::tr("Add Instance")}};
    addition.id = appendInstance(project, elementWith(project.assets, asset), addition.edit);
    return addition;
}

Edit duplicateInstances(const Project& project, std::span<const Id> instances, Vec3 by) {
    const int count = static_cast<int>(instances.size());
    Edit edit{.text = ProjectEditsTexts::tr("Duplicate %n Instance(s)", nullptr, count)};
    std::vector<Instance> all = project.instances;  // with the copies, whose names must be unique, too
    for (const Id id : instances) {
        Instance copy = elementWith(project.instances, id);
        copy.id = edit.allocateId(project);
        copy.name = uniqueName(all, copy.name);
        copy.pose.position += by;
        all.push_back(copy);
        edit.replacements.push_back(Replacement<Instance>{copy.id, std::move(copy)});
    }
    return edit;
}

Edit removeInstances(const Project& project, std::span<const Id> instances) {
    const int count = static_cast<int>(instances.size());
    Edit edit{.text = ProjectEditsTexts::tr("Delete %n Instance(s)", nullptr, count)};
    for (const Id id : instances) addRemoval<Instance>(id, edit);
    removeFromPlayTests(project, instances, {}, edit);
    removeFromMortars(project, instances, edit);
    return edit;
}

Addition addShot(const Project& project, const std::string& name, const ShotAction& action) {
    Addition added{.edit = {.text = ProjectEditsTexts::tr("Save Throw")}};
    added.id = appendShot(project, name, action, added.edit);
    return added;
}

Addition addPlayTest(const Project& project, const std::optional<ShotInput>& shot) {
    Addition added{.edit = {.text = ProjectEditsTexts::tr("Add Test")}};
    PlayTest test{.name = uniqueName(project.playTests, shot ? shot->name : "stands")};
    if (shot) {
        test.shots = {appendShot(project, shot->name, shot->action, added.edit)};
        test.expectations = {{.kind = ExpectationKind::Breaks}};
    } else {
        test.expectations = {{.kind = ExpectationKind::StandsUntouched, .value = test.duration}};
    }
    added.id = test.id = added.edit.allocateId(project);
    added.edit.replacements.push_back(Replacement<PlayTest>{added.id, std::move(test)});
    return added;
}

Edit removePlayTest(Id test) {
    return {.text = ProjectEditsTexts::tr("Delete Test"), .replacements = {Replacement<PlayTest>{test, std::nullopt}}};
}

Addition addMortar(const Project& project, std::span<const Id> instances) {
    Addition addition{{.text = ProjectEditsTexts::tr("Add Mortar")}};
    addition.id = addition.edit.allocateId(project);
    Mortar mortar{.id = addition.id, .name = uniqueName(project.mortars, "mortar")};
    mortar.instances.assign(instances.begin(), instances.end());
    std::ranges::sort(mortar.instances);
    addition.edit.replacements.push_back(Replacement<Mortar>{mortar.id, std::move(mortar)});
    return addition;
}

Edit removeMortar(Id mortar) {
    return {.text = ProjectEditsTexts::tr("Delete Mortar"),
            .replacements = {Replacement<Mortar>{mortar, std::nullopt}}};
}

Addition addLayer(const Project& project, Id asset, const LayerParameters& parameters, std::size_t pattern) {
    Addition addition{{.text = ProjectEditsTexts::tr("Add Layer")}};
    addition.id = addition.edit.allocateId(project);
    Asset changed = elementWith(project.assets, asset);
    if (pattern == 0 && hasNewPattern(changed) && isWholePattern(kindOf(parameters))) changed.pattern.layers.clear();
    patternAt(changed, pattern)
        .layers.push_back({.id = addition.id, .randomSeed = addition.id, .parameters = parameters});
    addition.edit.replacements = {Replacement<Asset>{asset, std::move(changed)}};
    return addition;
}

Edit addLevel(const Project& project, Id asset) {
    Edit edit{.text = ProjectEditsTexts::tr("Add Level")};
    const Id layer = edit.allocateId(project);
    Asset changed = elementWith(project.assets, asset);
    Level level;
    level.pattern.layers = {
        {.id = layer, .randomSeed = layer, .parameters = UniformScatter{.count = kSeedsPerFragment}}};
    changed.levels.push_back(std::move(level));
    edit.replacements = {Replacement<Asset>{asset, std::move(changed)}};
    return edit;
}

}  // namespace rubble
