#include "core/io/exchange/MeshPart.h"

#include "core/io/system/FileName.h"
#include "core/io/text/LetterCase.h"

#include <algorithm>
#include <filesystem>

namespace rubble {
namespace {

/// Returns the fifth root of a value in (0, 1], by Newton's method from above: the same bits on every processor.
double fifthRoot(double value) {
    double root = 1.0;
    for (int iteration = 0; iteration < 40; ++iteration) {
        const double fourth = root * root * root * root;
        root -= (fourth * root - value) / (5.0 * fourth);
    }
    return root;
}

/// Converts a component of an sRGB colour to linear, as colours are in glTF.
/// Source: IEC 61966-2-1.
double linearFromSrgb(double component) {
    if (component <= 0.04045) return component / 12.92;
    const double square = (component + 0.055) * (component + 0.055) / (1.055 * 1.055);
    return square * fifthRoot(square);  // to the power of 2.4; power() would change the last digit in exported files
}

}  // namespace

Vec3 linearColour(const Colour& colour) {
    return {linearFromSrgb(colour.red), linearFromSrgb(colour.green), linearFromSrgb(colour.blue)};
}

std::string meshName(const std::string& name) {
    std::string word = safeFileName(name);
    std::ranges::replace(word, ' ', '_');
    return word;
}

std::string imageFileName(const Texture& texture) {
    const std::string stem = std::filesystem::path(texture.name).stem().string();
    return fittingFileName("", meshName(stem), std::string(texture.image->suffix()));
}

std::string uniqueName(const std::string& name, std::set<std::string>& taken) {
    std::string candidate = name;
    for (int number = 2; !taken.insert(candidate).second; ++number) candidate = name + "_" + std::to_string(number);
    return candidate;
}

std::optional<std::string> importerEffect(std::string_view materialName) {
    constexpr std::pair<std::string_view, const char*> kEndings[] = {
        {"alpha", "makes it transparent"}, {"vcol", "multiplies it by the colours of vertices"}};
    const std::size_t end = materialName.find_last_not_of("0123456789_ ") + 1;
    const std::string name = lowerCase(std::string(materialName.substr(0, end)));
    for (const auto& [ending, effect] : kEndings) {
        for (const char separator : {'-', '_', '$'}) {
            if (name.ends_with(separator + std::string(ending))) return effect;
        }
    }
    return std::nullopt;
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
        materials.imageFile = imageFileName(*asset.texture);
    }
    if (materials.outside.empty())
        materials.outside.push_back({uniqueName(name + "_outside", taken), material.own.outside, material.own.opacity});
    for (std::uint32_t k = 0; asset.texture && k < materials.outside.size(); ++k)
        materials.outside[k].isTextured = asset.texture->covers(k);
    return materials;
}

}  // namespace rubble
