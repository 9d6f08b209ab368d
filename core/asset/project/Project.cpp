#include "core/asset/project/Project.h"

#include "core/asset/project/Ids.h"

#include <algorithm>

namespace rubble {
namespace {

bool isSameSurface(const std::shared_ptr<const Surface>& first, const std::shared_ptr<const Surface>& second) {
    if (first == second) return true;
    return first && second && *first == *second;
}

}  // namespace

bool Asset::operator==(const Asset& other) const {
    return id == other.id && name == other.name && material == other.material && prism == other.prism &&
           pattern == other.pattern && shaping == other.shaping && levels == other.levels &&
           fragmentLevels == other.fragmentLevels && fragmentThresholds == other.fragmentThresholds &&
           edits == other.edits && threshold == other.threshold && contactTime == other.contactTime &&
           insideUvScale == other.insideUvScale && insideMaterial == other.insideMaterial &&
           cutAtImpact == other.cutAtImpact && breakAs == other.breakAs && bonding == other.bonding &&
           requirements == other.requirements && isSameSurface(surface, other.surface) && texture == other.texture;
}

AssetMaterials materialsOf(const Project& project, const Asset& asset) {
    const Id inside = asset.insideMaterial == 0 ? asset.material : asset.insideMaterial;
    return {*findMaterial(project, asset.material), *findMaterial(project, inside)};
}

const Material* findMaterial(const Project& project, Id id) { return findById(project.materials, id); }

const Asset* findAsset(const Project& project, Id id) { return findById(project.assets, id); }
const Instance* findInstance(const Project& project, Id id) { return findById(project.instances, id); }
const Mortar* findMortar(const Project& project, Id id) { return findById(project.mortars, id); }

const Asset* findAsset(const Project& project, const std::string& name) {
    const auto found = std::ranges::find(project.assets, name, &Asset::name);
    return found != project.assets.end() ? &*found : nullptr;
}

}  // namespace rubble
