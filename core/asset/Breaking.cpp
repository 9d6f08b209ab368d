#include "core/asset/Breaking.h"

#include "core/base/Hash.h"
#include "core/base/Random.h"
#include "core/fracture/VoronoiPartition.h"

namespace rubble {

Error ofAsset(const Asset& asset, const Error& error) {
    if (error.code == ErrorCode::Cancelled) return error;
    return {error.code, "Asset \"" + asset.name + "\": " + error.message};
}

Result<Breaking> brokenBy(const Pattern& pattern, Prism prism, const TaskContext& task) {
    Result<Prism> valid = validated(std::move(prism));
    if (!valid) return valid.error();
    Result<Seeds> seeds = seedsOf(pattern, valid->outline, task.stage(0.0, 0.2));
    if (!seeds) return seeds.error();
    Result<Delaunay> delaunay = triangulate(seeds->positions, task.stage(0.2, 0.6));
    if (!delaunay) return delaunay.error();
    Result<Partition> partition = voronoiPartition(valid->outline, *delaunay, task.stage(0.6, 0.8));
    if (!partition) return partition.error();
    Result<Fragments> fragments = extrudedFragments(*valid, std::move(*partition), task.stage(0.8, 1.0));
    if (!fragments) return fragments.error();
    return Breaking{std::move(*valid), std::move(*seeds), std::move(*delaunay), std::move(*fragments)};
}

Pattern patternFor(const std::string& fragmentId, Pattern pattern) {
    const std::uint64_t fragment = contentHash(fragmentId).low;
    for (PatternLayer& layer : pattern.layers) layer.randomSeed = mixedWith(layer.randomSeed, fragment);
    return pattern;
}

std::string fragmentId(const std::string& parentId, const Seeds& seeds, const Fragment& fragment) {
    const SeedId seed = fragment.seed() == kNone ? SeedId{} : seeds.ids[fragment.seed()];
    return parentId + "/" + pieceName(seed, fragment.partOfCell());
}

}  // namespace rubble
