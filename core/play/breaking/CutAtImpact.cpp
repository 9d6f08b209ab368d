#include "core/play/breaking/CutAtImpact.h"

#include "core/base/Assert.h"
#include "core/base/Random.h"
#include "core/fracture/sampling/PointNear.h"

namespace rubble {
namespace {

/// Seeds whose density falls with the distance from a point, see pointNear().
std::vector<PlacedSeeds::Seed> nearSeeds(const Polygon& outline, Vec2 point, double falloffRadius, std::uint32_t count,
                                         Random& random) {
    std::vector<PlacedSeeds::Seed> seeds;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::optional<Vec2> position = pointNear(outline, point, falloffRadius, random);
        if (position) seeds.push_back({static_cast<std::uint32_t>(seeds.size()), *position});
    }
    return seeds;
}

}  // namespace

Result<std::shared_ptr<const PlayAsset>> cutAtImpact(const Asset& asset, Vec2 point, std::uint64_t number) {
    RUBBLE_ASSERT(asset.cutAtImpact.has_value());
    const std::uint64_t randomSeed = mixSeeds(asset.id, number);
    Random random(randomSeed);
    const std::uint32_t pieces = asset.cutAtImpact->pieces;
    Asset cut = asset;
    cut.leaves.clear();  // this and the next: they refer to the pattern's fragments
    cut.edits.clear();
    PlacedSeeds near{nearSeeds(asset.prism.outline, point, asset.cutAtImpact->falloffRadius, pieces / 2, random)};
    const auto others = static_cast<std::uint32_t>(pieces - near.seeds.size());
    cut.pattern.layers = {{.id = 1, .randomSeed = randomSeed, .parameters = std::move(near)},
                          {.id = 2, .randomSeed = randomSeed, .parameters = UniformScatter{.count = others}}};
    Result<Bake> baked = bake(cut);
    if (!baked) return baked.error();
    return playAsset(cut, std::make_shared<const Bake>(std::move(*baked)), {}, FindContacts::OnBreak);
}

}  // namespace rubble
