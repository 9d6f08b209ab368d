#include "core/play/CutAtImpact.h"

#include "core/base/Assert.h"
#include "core/base/Random.h"
#include "core/fracture/PointNear.h"

namespace rubble {
namespace {

/// Seeds at a density that falls with the distance from a point, as pointNear() throws them.
std::vector<PlacedSeeds::Seed> nearSeeds(const Polygon& outline, Vec2 point, double reach, std::uint32_t count,
                                         Random& random) {
    std::vector<PlacedSeeds::Seed> seeds;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::optional<Vec2> position = pointNear(outline, point, reach, random);
        if (position) seeds.push_back({static_cast<std::uint32_t>(seeds.size()), *position});
    }
    return seeds;
}

}  // namespace

Result<std::shared_ptr<const PlayAsset>> cutAtImpact(const Asset& asset, Vec2 point, std::uint64_t number) {
    RUBBLE_ASSERT(asset.cutAtImpact.has_value());
    const std::uint64_t randomSeed = mixedWith(asset.id, number);
    Random random(randomSeed);
    const std::uint32_t pieces = asset.cutAtImpact->pieces;
    Asset cut = asset;
    cut.leaves.clear();  // this and the next: for fragments of its pattern
    cut.edits.clear();
    PlacedSeeds near{nearSeeds(asset.prism.outline, point, asset.cutAtImpact->reach, pieces / 2, random)};
    const auto others = static_cast<std::uint32_t>(pieces - near.seeds.size());
    cut.pattern.layers = {{.id = 1, .randomSeed = randomSeed, .parameters = std::move(near)},
                          {.id = 2, .randomSeed = randomSeed, .parameters = UniformScatter{.count = others}}};
    Result<Bake> baked = bake(cut);
    if (!baked) return baked.error();
    return playAsset(cut, std::make_shared<const Bake>(std::move(*baked)), {}, FindContacts::WhenItBreaks);
}

}  // namespace rubble
