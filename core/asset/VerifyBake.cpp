#include "core/asset/Bake.h"
#include "core/asset/Breaking.h"
#include "core/fracture/Grain.h"
#include "core/fracture/PatternPartition.h"
#include "core/fracture/Verify.h"

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

std::string idOf(const Bake& bake, std::uint32_t fragment) {
    return fragment == kNone ? std::to_string(bake.asset) : bake.fragmentId(fragment);
}

/// How a fragment (kNone: the whole) was broken.
Recipe recipeOf(const Bake& bake, const Asset& asset, std::uint32_t parent) {
    if (parent == kNone) return recipeOf(asset);
    const BakedFragment fragment = bake.fragment(parent);
    const std::string id = bake.fragmentId(parent);
    return recipeOf(asset, id, *levelFor(asset, pathOfId(id), fragment.level), Vec2{fragment.solid.offset()});
}

Prism prismOf(const Bake& bake, const Asset& asset, std::uint32_t parent) {
    if (parent == kNone) return asset.prism;
    const BakedFragment fragment = bake.fragment(parent);
    return {fragment.solid.outline(), fragment.solid.depth()};
}

/// The stored stages are sound, and the triangulation they came from is.
Sentence stageFault(const BakedBreaking& stored, const Breaking& again, const Recipe& recipe) {
    const Pattern& pattern = recipe.pattern;
    const Partition& partition = stored.fragments.partition;
    const std::optional<GrainMap> grain = GrainMap::of(pattern, again.prism.outline);
    const std::vector<Vec2>& positions = again.seeds.positions;
    const std::vector<Vec2> seeds = grain ? (*grain)(std::span(positions)) : positions;
    if (Sentence fault = verifyDelaunay(again.delaunay, seeds)) return fault;
    if (Sentence fault = verifyPartition(partition, again.prism.outline)) return fault;
    const bool areMerged = !partition.partOfCell.empty();  // then the cells are looked at as they were before
    const Result<CutCells> cells =
        areMerged ? cellsOf(pattern, positions, again.prism.outline) : CutCells{{}, partition};
    if (!cells) return cells.error().message;
    if (Sentence fault = verifyNearestSeed(grain ? (*grain)(cells->partition) : cells->partition, seeds)) return fault;
    if (Sentence fault = verifyNoSmallPieces(partition, recipe.shaping.smallPieces, again.prism.depth)) return fault;
    if (Sentence fault = verifyGap(stored.fragments, gapOf(recipe))) return fault;
    return verifyFragments(stored.fragments, again.prism);
}

/// The stored fragments are called and placed as they should be.
Sentence placeFault(const Bake& bake, const BakedBreaking& stored, const Breaking& again) {
    const std::string parentId = idOf(bake, stored.parent);
    if (stored.fragments.count() != again.fragments.count()) {
        return "There are " + std::to_string(stored.fragments.count()) + " fragments, but " +
               std::to_string(again.fragments.count()) + " when it is broken again.";
    }
    for (std::uint32_t k = 0; k < stored.fragments.count(); ++k) {
        const std::string id = bake.fragmentId(stored.first + k);
        const std::string expected = fragmentId(parentId, again.seeds, again.fragments[k]);
        if (id != expected) return "Fragment " + id + " is not the " + expected + " it should be.";
    }
    const bool isWhole = stored.parent == kNone;
    const Vec3 origin = isWhole ? Vec3{0.0, 0.0, 0.0} : bake.fragment(stored.parent).solid.offset();
    if (stored.fragments.origin != origin) return "The fragments are not where it is.";
    return std::nullopt;
}

Sentence breakingFault(const Bake& bake, const Asset& asset, const BakedBreaking& stored) {
    const Recipe recipe = recipeOf(bake, asset, stored.parent);
    const Result<Breaking> again = brokenBy(recipe, prismOf(bake, asset, stored.parent), {});
    if (!again) return again.error().message;
    if (Sentence fault = placeFault(bake, stored, *again)) return fault;
    return stageFault(stored, *again, recipe);
}

/// The k-th breaking is of a fragment that stands before it, of the next one that is broken, and one level below it.
Sentence linkFault(const Bake& bake, const Asset& asset, std::size_t k) {
    const BakedBreaking& breaking = bake.breakings[k];
    const bool isAfterLast = k < 2 || breaking.parent > bake.breakings[k - 1].parent;
    if (breaking.parent >= breaking.first || !isAfterLast) {
        return "fragment " + std::to_string(breaking.first) + " is not a piece of the next fragment that is broken.";
    }
    const std::uint32_t level = bake.fragment(breaking.parent).level;
    const std::string name = "fragment " + bake.fragmentId(breaking.parent);
    if (!levelFor(asset, pathOfId(bake.fragmentId(breaking.parent)), level)) {
        return name + " has pieces below the last level.";
    }
    if (breaking.level != level + 1) return name + " has pieces of another level than the next.";
    return std::nullopt;
}

/// The breaking of the whole comes first; all fragments are numbered through.
Sentence treeFault(const Bake& bake, const Asset& asset) {
    if (bake.breakings.empty() || bake.breakings[0].parent != kNone) return "the whole is not broken.";
    std::uint32_t count = 0;
    for (std::size_t k = 0; k < bake.breakings.size(); ++k) {
        if (bake.breakings[k].first != count) return "fragment " + std::to_string(count) + " has another number.";
        count += bake.breakings[k].fragments.count();
        if (k == 0) continue;
        if (Sentence fault = linkFault(bake, asset, k)) return fault;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyBake(const Bake& bake, const Asset& asset) {
    const std::string owner = "Asset \"" + asset.name + "\": ";
    if (bake.asset != asset.id || bake.input != bakeInputHash(asset)) {
        return owner + "the bake was made from something else.";
    }
    for (const Polytope& hull : bake.wholeHulls) {
        if (Sentence fault = verifyPolytope(hull)) return owner + "a hull of the whole: " + *fault;
    }
    if (Sentence fault = treeFault(bake, asset)) return owner + *fault;
    for (const BakedBreaking& breaking : bake.breakings) {
        const Sentence fault = breakingFault(bake, asset, breaking);
        if (!fault) continue;
        return owner + (breaking.parent == kNone ? "" : "fragment " + bake.fragmentId(breaking.parent) + ": ") + *fault;
    }
    return std::nullopt;
}

}  // namespace rubble
