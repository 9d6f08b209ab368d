#include "core/io/MeshPart.h"

#include "core/io/ExportFolder.h"

#include <algorithm>
#include <set>

namespace rubble {
namespace {

/// `name`, or `name` with the first number from 2 on that makes it differ from all in `taken`, to which it is added.
std::string untaken(const std::string& name, std::set<std::string>& taken) {
    std::string candidate = name;
    for (int number = 2; !taken.insert(candidate).second; ++number) candidate = name + "_" + std::to_string(number);
    return candidate;
}

}  // namespace

std::string meshName(const std::string& name) {
    std::string word = safeFileName(name);
    std::ranges::replace(word, ' ', '_');
    return word;
}

MeshMaterials meshMaterials(const Asset& asset, const AssetMaterials& material) {
    std::set<std::string> taken;
    const std::string name = meshName(material.own.name), insideName = meshName(material.inside.name) + "_inside";
    MeshMaterials materials{{}, {untaken(insideName, taken), material.inside.inside}};
    if (asset.surface) {
        for (const std::string& source : asset.surface->materials) {
            materials.outside.push_back({untaken(meshName(source), taken), material.own.outside});
        }
    }
    if (materials.outside.empty())
        materials.outside.push_back({untaken(name + "_outside", taken), material.own.outside});
    return materials;
}

}  // namespace rubble
