#include "core/asset/project/Project.h"

#include "core/asset/project/Ids.h"
#include "core/base/Assert.h"

#include <algorithm>

namespace rubble {
namespace {

bool isSameSurface(const std::shared_ptr<const Surface>& first, const std::shared_ptr<const Surface>& second) {
    if (first == second) return true;
    return first && second && *first == *second;
}

}  // namespace

bool isSameShape(const Asset& first, const Asset& second) {
    const ClosedMesh *mesh = first.mesh(), *other = second.mesh();
    if (mesh && other) return mesh == other || mesh->hash == other->hash;
    return !mesh && !other && first.prism() == second.prism();
}

const ClosedMesh* Asset::mesh() const {
    const auto* mesh = std::get_if<std::shared_ptr<const ClosedMesh>>(&shape);
    return mesh ? mesh->get() : nullptr;
}

const Prism& Asset::prism() const {
    RUBBLE_ASSERT(isPrism());
    return *std::get_if<Prism>(&shape);
}

Prism& Asset::prism() {
    RUBBLE_ASSERT(isPrism());
    return *std::get_if<Prism>(&shape);
}

bool Asset::operator==(const Asset& other) const {
    return id == other.id && name == other.name && material == other.material && isSameShape(*this, other) &&
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
