#include "core/io/exchange/MeshPart.h"

#include "core/io/system/FileName.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace rubble {
namespace {

/// Returns `name`, with a number from 2 on if it is in `taken` already, and adds the result to `taken`.
std::string uniqueName(const std::string& name, std::set<std::string>& taken) {
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
    MeshMaterials materials{{}, {uniqueName(insideName, taken), material.inside.inside, material.inside.opacity}};
    if (asset.surface) {
        for (const std::string& source : asset.surface->materials) {
            materials.outside.push_back(
                {uniqueName(meshName(source), taken), material.own.outside, material.own.opacity});
        }
    }
    if (asset.texture) {
        materials.image = asset.texture->image;
        const std::string stem = std::filesystem::path(asset.texture->name).stem().string();
        materials.imageFile = fittingFileName("", meshName(stem), std::string(materials.image->suffix()));
    }
    if (materials.outside.empty())
        materials.outside.push_back({uniqueName(name + "_outside", taken), material.own.outside, material.own.opacity});
    for (std::uint32_t k = 0; asset.texture && k < materials.outside.size(); ++k)
        materials.outside[k].isTextured = asset.texture->covers(k);
    return materials;
}

}  // namespace rubble
