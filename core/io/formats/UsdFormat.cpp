#include "core/io/exchange/UsdFile.h"

#include "core/io/formats/ExportFormat.h"
#include "core/io/system/FileName.h"

namespace rubble {
namespace {

constexpr std::string_view kLayerSuffix = ".usda";
constexpr const ExportOption* kUsdOptions[] = {&kTexturesOption, &kTextureSizeOption};

/// Of the fragments, and of the whole.
std::vector<std::string> layerNames(const PackNames& names) {
    return {fittingFileName("", names.folder, std::string(kLayerSuffix)),
            fittingFileName("", wholeFileName(names), std::string(kLayerSuffix))};
}

Result<std::vector<std::string>> layers(const FormatInput& input) {
    const Bake& bake = input.pack.input().bake;
    const BakedTextures* textures = input.textures;
    const auto meshOf = [&](std::uint32_t index) {
        if (index == kNone) {
            const Mesh mesh = input.mesher.wholeMesh(bake);
            return textures != nullptr ? textures->wholeMesh(mesh) : mesh;
        }
        const Mesh mesh = input.mesher.fragmentMesh(bake.fragment(index), input.cuts.cornersOf(index));
        return textures != nullptr ? textures->fragmentMesh(index, mesh) : mesh;
    };
    const MeshMaterials& materials = textures != nullptr ? textures->materials : input.materials;
    std::vector<std::string> files;
    const std::vector<std::uint32_t> whole{kNone};
    for (const std::vector<std::uint32_t>& bodies : {unbrokenFragments(bake), whole}) {
        Result<std::string> layer = usdFile(input.pack, bodies, materials, meshOf, input.task);
        if (!layer) return layer.error();
        files.push_back(std::move(*layer));
    }
    return files;
}

}  // namespace

extern const ExportFormat kUsdFormat;
constinit const ExportFormat kUsdFormat{.word = "usd",
                                        .caption = "U&SD",
                                        .hint = "Write USD files with rigid bodies and colliders of UsdPhysics",
                                        .options = kUsdOptions,
                                        .hasImageFile = true,
                                        .hasBakedImages = [](const MeshOptions&) { return true; },
                                        .bytesPerFragment = [](const MeshOptions&) { return 4800.0; },
                                        .assetFileNames = layerNames,
                                        .assetFiles = layers};

}  // namespace rubble
