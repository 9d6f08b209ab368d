#include "core/asset/checks/VerifyBake.h"

#include "core/asset/bake/BakeHash.h"
#include "core/asset/bake/FractureResult.h"
#include "core/asset/project/FragmentLevels.h"
#include "core/base/MessageText.h"
#include "core/fracture/pattern/AnisotropyMap.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/fracture/verify/VerifyDelaunay.h"
#include "core/fracture/verify/VerifyFragments.h"
#include "core/fracture/verify/VerifyGap.h"
#include "core/fracture/verify/VerifyNearestSeed.h"
#include "core/fracture/verify/VerifyPartition.h"
#include "core/fracture/verify/VerifySmallPieces.h"
#include "core/fracture/verify/VerifySolidFragments.h"

#include <algorithm>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

std::string idOf(const Bake& bake, std::uint32_t fragment) {
    return fragment == kNone ? std::to_string(bake.asset) : bake.fragmentId(fragment);
}

/// The recipe of a fragment's fracture; kNone: of the whole.
Recipe recipeOf(const Bake& bake, const Asset& asset, std::uint32_t parent) {
    if (parent == kNone) return recipeOf(asset);
    const BakedFragment fragment = bake.fragment(parent);
    const std::string id = bake.fragmentId(parent);
    return recipeOf(asset, id, *levelFor(asset, pathOfId(id), fragment.level), fragment.solid.offset());
}

/// Fractures a fragment once more; kNone: the whole.
Result<FractureResult> fracturedAgain(const Bake& bake, const Asset& asset, std::uint32_t parent,
                                      const Recipe& recipe) {
    if (parent == kNone) return fractureResult(recipe, asset, {});
    return fractureResult(recipe, bake.fragment(parent).solid, {});
}

/// What a fracture of a mesh was cut from.
TriangleMesh meshOf(const Bake& bake, const Asset& asset, std::uint32_t parent) {
    return parent == kNone ? asset.mesh()->mesh : meshInOwnFrame(bake.fragment(parent).solid);
}

/// Whether fragments of a mesh are the same, bit for bit.
bool areEqual(const SolidFragments& stored, const SolidFragments& again) {
    const auto areSame = [](const ShrunkFragment& a, const ShrunkFragment& b) {
        return a.mesh.points == b.mesh.points && a.mesh.triangles == b.mesh.triangles;
    };
    return stored.partition.points == again.partition.points &&
           stored.partition.triangles == again.partition.triangles && stored.remaining == again.remaining &&
           (stored.shrunk == nullptr) == (again.shrunk == nullptr) &&
           (!stored.shrunk || std::ranges::equal(stored.shrunk->fragments, again.shrunk->fragments, areSame));
}

/// Checks the fragments of a mesh, and that they are those of another time.
Sentence solidFault(const BakedFracture& stored, const FractureResult& again, const TriangleMesh& mesh,
                    const Recipe& recipe) {
    if (!areEqual(*stored.fragments.solid(), *again.fragments.solid()))
        return "The fragments are not those of the seeds.";
    if (stored.fragments.gap != gapOf(recipe)) return "The fragments have another gap than the asset.";
    return verifySolidFragments(stored.fragments, mesh);
}

/// Checks the stored stages and their triangulation.
Sentence stageFault(const BakedFracture& stored, const FractureResult& again, const Recipe& recipe) {
    const Pattern& pattern = recipe.pattern;
    const Partition& partition = stored.fragments.extruded()->partition;
    const std::optional<AnisotropyMap> anisotropy = AnisotropyMap::of(pattern, again.prism.outline);
    const std::vector<Vec2>& positions = again.seeds.positions;
    const std::vector<Vec2> seeds = anisotropy ? (*anisotropy)(std::span(positions)) : positions;
    if (Sentence fault = verifyDelaunay(again.delaunay, seeds)) return fault;
    if (Sentence fault = verifyPartition(partition, again.prism.outline)) return fault;
    const bool areMerged = !partition.partOfCell.empty();  // then the original cells are checked
    const Result<TriangulatedPartition> cells =
        areMerged ? cellsOf(pattern, positions, again.prism.outline) : TriangulatedPartition{{}, partition};
    if (!cells) return cells.error().message;
    if (Sentence fault = verifyNearestSeed(anisotropy ? (*anisotropy)(cells->partition) : cells->partition, seeds))
        return fault;
    if (Sentence fault = verifyNoSmallPieces(partition, recipe.shaping.smallPieces, again.prism.depth)) return fault;
    if (Sentence fault = verifyGap(stored.fragments, gapOf(recipe))) return fault;
    return verifyFragments(stored.fragments, again.prism);
}

/// Checks ids and offset of the stored fragments.
Sentence placeFault(const Bake& bake, const BakedFracture& stored, const FractureResult& again) {
    const std::string parentId = idOf(bake, stored.parent);
    if (stored.fragments.count() != again.fragments.count()) {
        return "There are " + std::to_string(stored.fragments.count()) + " fragments, but " +
               std::to_string(again.fragments.count()) + " when it is fractured again.";
    }
    for (std::uint32_t k = 0; k < stored.fragments.count(); ++k) {
        const std::string id = bake.fragmentId(stored.first + k);
        const std::string expected = fragmentId(parentId, again.seeds, again.fragments[k]);
        if (id != expected) return "Fragment " + id + " should be " + expected + ".";
    }
    const bool isWhole = stored.parent == kNone;
    const Vec3 origin = isWhole ? Vec3{0.0, 0.0, 0.0} : bake.fragment(stored.parent).solid.offset();
    if (stored.fragments.origin != origin) return "The fragments have the wrong offset.";
    return std::nullopt;
}

Sentence fractureFault(const Bake& bake, const Asset& asset, const BakedFracture& stored) {
    const Recipe recipe = recipeOf(bake, asset, stored.parent);
    const Result<FractureResult> again = fracturedAgain(bake, asset, stored.parent, recipe);
    if (!again) return again.error().message;
    if (Sentence fault = placeFault(bake, stored, *again)) return fault;
    if (stored.fragments.solid()) return solidFault(stored, *again, meshOf(bake, asset, stored.parent), recipe);
    return stageFault(stored, *again, recipe);
}

/// Checks that the parent of fracture k precedes it, follows the parent of fracture k - 1, and is one level above.
Sentence linkFault(const Bake& bake, const Asset& asset, std::size_t k) {
    const BakedFracture& fracture = bake.fractures[k];
    const bool isAfterLast = k < 2 || fracture.parent > bake.fractures[k - 1].parent;
    if (fracture.parent >= fracture.first || !isAfterLast) {
        return "fragment " + std::to_string(fracture.first) + " does not belong to the next fractured fragment.";
    }
    const std::uint32_t level = bake.fragment(fracture.parent).level;
    const std::string name = "fragment " + bake.fragmentId(fracture.parent);
    if (!levelFor(asset, bake.fragmentPath(fracture.parent), level)) {
        return name + " is fractured below the last level.";
    }
    if (fracture.level != level + 1) return name + " has fragments of a wrong level.";
    return std::nullopt;
}

/// Checks that the fracture of the whole comes first and that fragments are numbered consecutively.
Sentence treeFault(const Bake& bake, const Asset& asset) {
    if (bake.fractures.empty() || bake.fractures[0].parent != kNone) return "the whole has no fracture.";
    std::uint32_t count = 0;
    for (std::size_t k = 0; k < bake.fractures.size(); ++k) {
        if (bake.fractures[k].first != count) return "fragment " + std::to_string(count) + " has the wrong number.";
        count += bake.fractures[k].fragments.count();
        if (k == 0) continue;
        if (Sentence fault = linkFault(bake, asset, k)) return fault;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyBake(const Bake& bake, const Asset& asset) {
    const std::string owner = "Asset " + quotedName(asset.name) + ": ";
    if (bake.asset != asset.id || bake.input != bakeInputHash(asset)) {
        return owner + "the bake was computed from a different asset.";
    }
    for (const Polytope& hull : bake.wholeHulls) {
        if (Sentence fault = verifyPolytope(hull)) return owner + "a hull of the whole: " + *fault;
    }
    if (Sentence fault = treeFault(bake, asset)) return owner + *fault;
    for (const BakedFracture& fracture : bake.fractures) {
        const Sentence fault = fractureFault(bake, asset, fracture);
        if (!fault) continue;
        return owner + (fracture.parent == kNone ? "" : "fragment " + bake.fragmentId(fracture.parent) + ": ") + *fault;
    }
    return std::nullopt;
}

}  // namespace rubble
