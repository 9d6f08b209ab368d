#include "core/io/formats/TextureBaking.h"

#include "core/asset/texture/TextureBake.h"
#include "core/base/Parallel.h"
#include "core/base/image/PngEncoding.h"
#include "core/io/formats/ExportFormat.h"
#include "core/io/system/FileName.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

/// Bytes a texel: three maps, the owners of texels, and three PNG files that are as large as their maps.
constexpr double kBytesPerTexel = 22.0;

bool usesBaked(const MeshOptions& options) {
    if (options.textures == SurfaceTextures::None) return false;
    return std::ranges::any_of(formatsOf(options.formats), [&](const ExportFormat* format) {
        return format->hasBakedImages != nullptr && format->hasBakedImages(options);
    });
}

/// Errors: Limit if there is not enough memory.
Result<std::array<MeshImage, 3>> imagesOf(const BakedMaps& maps, const std::vector<std::string>& names, int threads) {
    const std::array<const std::vector<std::uint8_t>*, 3> pixels{&maps.colour, &maps.normal, &maps.surface};
    std::array<MeshImage, 3> images;
    std::array<std::optional<Error>, 3> errors;
    forEachIndex(images.size(), threads, [&](std::size_t k) {
        Result<std::string> png = encodedPng({maps.side, maps.side, *pixels[k]});
        Result<EncodedImage> image = png ? EncodedImage::of(std::move(*png)) : Result<EncodedImage>(png.error());
        if (!image) errors[k] = image.error();
        if (image) images[k] = {names[k], std::make_shared<const EncodedImage>(std::move(*image))};
    });
    for (const std::optional<Error>& error : errors) {
        if (error) return *error;
    }
    return images;
}

}  // namespace

TexturedSides bakedSides(const Asset& asset, const AssetMaterials& materials, const MeshOptions& options) {
    if (!usesBaked(options)) return {false, false};
    const AssetFinish finish = assetFinish(asset, materials);
    return {finish.outside != Finish::Plain && materials.own.opacity >= 1.0,
            finish.inside != Finish::Plain && materials.inside.opacity >= 1.0};
}

std::vector<std::string> bakedImageNames(const PackNames& names) {
    std::vector<std::string> files;
    for (const char* map : {"-colour", "-normal", "-surface"})
        files.push_back(fittingFileName("", names.folder, std::string(map) + ".png"));
    return files;
}

bool areImagesBeside(const MeshOptions& options) {
    const bool areGlbSplit = options.formats.contains("glb") && options.split == FileSplit::PerFragment &&
                             options.glbKind != GlbKind::Compact;
    return options.formats.contains("usd") || areGlbSplit;
}

double bakingBytes(const MeshOptions& options) {
    const double side = texelsOf(options.textureSize);
    return usesBaked(options) ? kBytesPerTexel * side * side : 0.0;
}

Result<std::optional<BakedTextures>> bakedTextures(const PackInput& pack, const MeshOptions& options,
                                                   const FragmentMesher& mesher, const RoughCuts& cuts,
                                                   const MeshMaterials& materials, const TaskContext& task) {
    const TexturedSides sides = bakedSides(pack.asset, pack.material, options);
    if (!sides.outside && !sides.inside) return std::optional<BakedTextures>();
    Result<TextureAtlas> atlas =
        assetAtlas(pack.bake, mesher, cuts, sides, texelsOf(options.textureSize), task.stage(0.0, 0.2));
    if (!atlas && atlas.error().code == ErrorCode::Limit)
        return Error{ErrorCode::Limit, atlas.error().message + " Choose larger textures, or none."};
    if (!atlas) return atlas.error();
    const AssetFinish finish = assetFinish(pack.asset, pack.material, pack.orientation);
    const Result<BakedMaps> maps = bakedMaps(
        *atlas, surfaceFinish(finish, FinishSide::Outside, linearColour(pack.material.own.outside)),
        surfaceFinish(finish, FinishSide::Inside, linearColour(pack.material.inside.inside)), task.stage(0.2, 0.7));
    if (!maps) return maps.error();
    Result<std::array<MeshImage, 3>> images = imagesOf(*maps, bakedImageNames(pack.names), task.threads);
    if (!images) return images.error();
    BakedTextures textures{std::move(*atlas), materials};
    textures.materials.baked = BakedImages{std::move((*images)[0]), std::move((*images)[1]), std::move((*images)[2]),
                                           options.split == FileSplit::PerFragment};
    for (MeshMaterial& outside : textures.materials.outside) outside.isBaked = sides.outside;
    textures.materials.inside.isBaked = sides.inside;
    return std::optional(std::move(textures));
}

}  // namespace rubble
