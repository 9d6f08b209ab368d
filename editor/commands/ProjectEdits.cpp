#include "editor/commands/ProjectEdits.h"

#include "core/asset/Names.h"
#include "editor/commands/PatternPlaces.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>

namespace rubble {

namespace {

constexpr double kDensityOfStone = 2400.0;  // kg/m^3
constexpr std::uint32_t kSeedsOfLevel = 4;  // in each fragment of a new level
constexpr double kTimeOfShot = 0.5;         // s after the start
constexpr double kGapBetweenAssets = 0.25;  // m, between a new asset and what is in the scene already

QString tr(const char* text) { return QCoreApplication::translate("ProjectEdits", text); }
QString tr(const char* one, const char* many, std::size_t count) { return count == 1 ? tr(one) : tr(many).arg(count); }

bool isAmong(std::span<const Id> ids, Id id) { return std::ranges::find(ids, id) != ids.end(); }

template <class Value>
const Value& elementWith(const std::vector<Value>& elements, Id id) {
    return *std::ranges::find(elements, id, &Value::id);
}

template <class Value>
void addRemoval(Id id, Edit& edit) {
    edit.swaps.push_back(Swap<Value>{id, std::nullopt});
}

/// Half the width, at most, that an asset's outline takes in any turn about the vertical.
double reachOf(const Asset& asset) {
    double reach = asset.prism.depth / 2.0;
    for (const Vec2 corner : asset.prism.outline.outer) reach = std::max(reach, std::abs(corner.x));
    return reach;
}

/// Upright on the ground, to the right of everything.
Pose besideAll(const Project& project, const Asset& asset) {
    double right = -reachOf(asset) - kGapBetweenAssets;
    for (const Instance& instance : project.instances) {
        const Asset& other = elementWith(project.assets, instance.asset);
        right = std::max(right, instance.pose.position.x + reachOf(other));
    }
    const double bottom = boundsOf(asset.prism.outline.outer).min.y;
    return {.position = {right + kGapBetweenAssets + reachOf(asset), project.ground.height - bottom, 0.0}};
}

/// Takes the play-tests' expectations on removed instances and their removed shots out.
void removeFromPlayTests(const Project& project, std::span<const Id> instances, std::span<const Id> shots, Edit& edit) {
    for (const PlayTest& test : project.playTests) {
        PlayTest rest = test;
        std::erase_if(rest.shots, [&](Id shot) { return isAmong(shots, shot); });
        std::erase_if(rest.expectations,
                      [&](const Expectation& expectation) { return isAmong(instances, expectation.instance); });
        if (rest != test) edit.swaps.push_back(Swap<PlayTest>{rest.id, std::move(rest)});
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
    const Id id = edit.takeId(project);
    edit.swaps.push_back(
        Swap<Material>{id, Material{.id = id, .name = freeName(project.materials, name), .density = kDensityOfStone}});
    return id;
}

Id appendShot(const Project& project, const std::string& name, const ShotAction& action, Edit& edit) {
    const Id id = edit.takeId(project);
    const Shot shot{.id = id, .name = freeName(project.shots, name), .time = kTimeOfShot, .action = action};
    edit.swaps.push_back(Swap<Shot>{id, shot});
    return id;
}

/// The project's first material; one that is added where there is none.
Id firstMaterial(const Project& project, Edit& edit) {
    return project.materials.empty() ? appendMaterial(project, "stone", edit) : project.materials.front().id;
}

Id appendInstance(const Project& project, const Asset& asset, Edit& edit) {
    const Id id = edit.takeId(project);
    edit.swaps.push_back(Swap<Instance>{id, Instance{.id = id,
                                                     .name = freeName(project.instances, asset.name),
                                                     .asset = asset.id,
                                                     .pose = besideAll(project, asset)}});
    return id;
}

/// Swaps for the things of one kind that are not the same in both lists.
template <class Value>
void addDifferences(const std::vector<Value>& from, const std::vector<Value>& to, Edit& edit) {
    for (const Value& value : to) {
        const auto before = std::ranges::find(from, value.id, &Value::id);
        if (before == from.end() || !(*before == value)) edit.swaps.push_back(Swap<Value>{value.id, value});
    }
    for (const Value& value : from) {
        if (std::ranges::find(to, value.id, &Value::id) == to.end()) addRemoval<Value>(value.id, edit);
    }
}

/// Gives layers ids of their own, and tells which became which. What patterns have in common stays so.
void takeLayerIds(const Project& project, Pattern& pattern, Edit& edit, std::map<Id, Id>& layers) {
    for (PatternLayer& layer : pattern.layers) {
        const auto [known, isNew] = layers.try_emplace(layer.id, 0);
        if (isNew) known->second = edit.takeId(project);
        layer.id = known->second;
    }
}

/// Names fragments as they are called when layers have other ids.
void renameFragments(const std::map<Id, Id>& layers, Asset& asset) {
    for (FragmentLevel& leaf : asset.leaves) leaf.fragment = withLayers(leaf.fragment, layers);
    std::ranges::sort(asset.leaves, {}, &FragmentLevel::fragment);
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

}  // namespace

Edit editBetween(const QString& text, const Project& from, const Project& to) {
    Edit edit{.text = text};
    addDifferences(from.materials, to.materials, edit);
    addDifferences(from.assets, to.assets, edit);
    addDifferences(from.instances, to.instances, edit);
    addDifferences(from.shots, to.shots, edit);
    addDifferences(from.playTests, to.playTests, edit);
    if (sceneSettings(from) != sceneSettings(to)) edit.swaps.push_back(sceneSettings(to));
    if (from.nextId != to.nextId) edit.nextId = to.nextId;
    return edit;
}

Addition addAsset(const Project& project, const std::string& name, const Prism& prism) {
    Addition addition{{.text = tr("Add asset")}};
    Asset asset{.name = freeName(project.assets, name), .prism = prism};
    asset.material = firstMaterial(project, addition.edit);
    asset.id = addition.id = addition.edit.takeId(project);
    const Id layer = addition.edit.takeId(project);
    asset.pattern.layers = {{.id = layer, .randomSeed = layer, .parameters = UniformScatter{}}};
    appendInstance(project, asset, addition.edit);
    addition.edit.swaps.push_back(Swap<Asset>{addition.id, std::move(asset)});
    return addition;
}

Addition duplicateAsset(const Project& project, Id source) {
    Addition addition{{.text = tr("Duplicate asset")}};
    Asset copy = elementWith(project.assets, source);
    copy.name = freeName(project.assets, copy.name);
    copy.id = addition.id = addition.edit.takeId(project);
    std::map<Id, Id> layers;
    takeLayerIds(project, copy.pattern, addition.edit, layers);
    for (Level& level : copy.levels) takeLayerIds(project, level.pattern, addition.edit, layers);
    for (FragmentLevel& leaf : copy.leaves) {
        if (leaf.level) takeLayerIds(project, leaf.level->pattern, addition.edit, layers);
    }
    renameFragments(layers, copy);
    addition.edit.swaps = {Swap<Asset>{addition.id, std::move(copy)}};
    return addition;
}

Edit removeAssets(const Project& project, std::span<const Id> assets) {
    Edit edit{.text = tr("Delete asset", "Delete %1 assets", assets.size())};
    std::vector<Id> instances;
    for (const Instance& instance : project.instances) {
        if (isAmong(assets, instance.asset)) instances.push_back(instance.id);
    }
    const std::vector<Id> shots = shotsThrowing(project, assets);
    for (const Id id : assets) addRemoval<Asset>(id, edit);
    for (const Id id : instances) addRemoval<Instance>(id, edit);
    for (const Id id : shots) addRemoval<Shot>(id, edit);
    removeFromPlayTests(project, instances, shots, edit);
    return edit;
}

Addition addMaterial(const Project& project, const std::string& name) {
    Addition addition{{.text = tr("Add material")}};
    addition.id = appendMaterial(project, name, addition.edit);
    return addition;
}

Addition duplicateMaterial(const Project& project, Id source) {
    Addition addition{{.text = tr("Duplicate material")}};
    Material copy = elementWith(project.materials, source);
    copy.name = freeName(project.materials, copy.name);
    copy.id = addition.id = addition.edit.takeId(project);
    addition.edit.swaps = {Swap<Material>{addition.id, std::move(copy)}};
    return addition;
}

Edit removeMaterial(const Project& project, Id material) {
    Edit edit{.text = tr("Delete material")};
    const auto other = std::ranges::find_if(project.materials, [&](const Material& m) { return m.id != material; });
    if (other == project.materials.end()) return edit;
    addRemoval<Material>(material, edit);
    for (Asset asset : project.assets) {
        if (asset.material != material && asset.insideMaterial != material) continue;
        if (asset.material == material) asset.material = other->id;
        if (asset.insideMaterial == material) asset.insideMaterial = 0;
        edit.swaps.push_back(Swap<Asset>{asset.id, std::move(asset)});
    }
    return edit;
}

Addition addInstance(const Project& project, Id asset) {
    Addition addition{{.text = tr("Add instance")}};
    addition.id = appendInstance(project, elementWith(project.assets, asset), addition.edit);
    return addition;
}

Edit duplicateInstances(const Project& project, std::span<const Id> instances, Vec3 by) {
    Edit edit{.text = tr("Duplicate instance", "Duplicate %1 instances", instances.size())};
    std::vector<Instance> all = project.instances;  // names of copies are taken, too
    for (const Id id : instances) {
        Instance copy = elementWith(project.instances, id);
        copy.id = edit.takeId(project);
        copy.name = freeName(all, copy.name);
        copy.pose.position += by;
        all.push_back(copy);
        edit.swaps.push_back(Swap<Instance>{copy.id, std::move(copy)});
    }
    return edit;
}

Edit removeInstances(const Project& project, std::span<const Id> instances) {
    Edit edit{.text = tr("Delete instance", "Delete %1 instances", instances.size())};
    for (const Id id : instances) addRemoval<Instance>(id, edit);
    removeFromPlayTests(project, instances, {}, edit);
    return edit;
}

Addition addShot(const Project& project, const std::string& name, const ShotAction& action) {
    Addition added{.edit = {.text = tr("Keep shot")}};
    added.id = appendShot(project, name, action, added.edit);
    return added;
}

Addition addPlayTest(const Project& project, const std::optional<ShotInput>& shot) {
    Addition added{.edit = {.text = tr("Add play-test")}};
    PlayTest test{.name = freeName(project.playTests, shot ? shot->name : "stands")};
    if (shot) {
        test.shots = {appendShot(project, shot->name, shot->action, added.edit)};
        test.expectations = {{.kind = ExpectationKind::Breaks}};
    } else {
        test.expectations = {{.kind = ExpectationKind::StandsUntouched, .value = test.duration}};
    }
    added.id = test.id = added.edit.takeId(project);
    added.edit.swaps.push_back(Swap<PlayTest>{added.id, std::move(test)});
    return added;
}

Edit removePlayTest(Id test) { return {.text = tr("Delete play-test"), .swaps = {Swap<PlayTest>{test, std::nullopt}}}; }

Addition addLayer(const Project& project, Id asset, const LayerParameters& parameters, std::size_t level) {
    Addition addition{{.text = tr("Add layer")}};
    addition.id = addition.edit.takeId(project);
    Asset changed = elementWith(project.assets, asset);
    patternAt(changed, level)
        .layers.push_back({.id = addition.id, .randomSeed = addition.id, .parameters = parameters});
    addition.edit.swaps = {Swap<Asset>{asset, std::move(changed)}};
    return addition;
}

Edit addLevel(const Project& project, Id asset) {
    Edit edit{.text = tr("Add level")};
    const Id layer = edit.takeId(project);
    Asset changed = elementWith(project.assets, asset);
    Level level;
    level.pattern.layers = {{.id = layer, .randomSeed = layer, .parameters = UniformScatter{.count = kSeedsOfLevel}}};
    changed.levels.push_back(std::move(level));
    edit.swaps = {Swap<Asset>{asset, std::move(changed)}};
    return edit;
}

}  // namespace rubble
