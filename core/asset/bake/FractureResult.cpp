#include "core/asset/bake/FractureResult.h"

#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/bake/FragmentEditing.h"
#include "core/asset/bake/SolidShaping.h"
#include "core/base/Hash.h"
#include "core/base/MessageText.h"
#include "core/base/Random.h"
#include "core/fracture/fragments/Extrusion.h"
#include "core/fracture/fragments/FragmentName.h"
#include "core/fracture/fragments/SolidFracture.h"
#include "core/fracture/pattern/PatternCuts.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/fracture/pattern/PieceEstimate.h"
#include "core/fracture/pattern/SolidPatternCut.h"
#include "core/fracture/sampling/SolidDomain.h"

namespace rubble {
namespace {

/// Triangulates the seeds and cuts the outline into pieces.
Status computePartition(const Pattern& pattern, PlanarFracture& cut, const TaskContext& task) {
    Result<TriangulatedPartition> made = partitionOf(pattern, cut.seeds.positions, cut.prism.outline, task);
    if (!made) return made.error();
    cut.delaunay = std::move(made->delaunay);
    cut.partition = std::move(made->partition);
    return success();
}

/// Removes and reports seeds.
void dropSeeds(const std::vector<std::uint32_t>& dropped, Seeds& seeds) {
    for (const std::uint32_t seed : dropped) {
        const SeedId id = seeds.ids[seed];
        seeds.diagnostics.push_back(diagnostic(DiagnosticCode::DroppedSeed, {.layer = id.layer, .index = id.index},
                                               "Seed " + id.text() + " is dropped, since its cell is too small."));
    }
    std::size_t next = 0;
    const auto isDropped = [&](std::size_t seed) {
        if (next == dropped.size() || dropped[next] != seed) return false;
        ++next;
        return true;
    };
    std::size_t kept = 0;
    for (std::size_t seed = 0; seed < seeds.ids.size(); ++seed) {
        if (isDropped(seed)) continue;
        seeds.positions[kept] = seeds.positions[seed];
        if (!seeds.heights.empty()) seeds.heights[kept] = seeds.heights[seed];
        seeds.ids[kept++] = seeds.ids[seed];
    }
    seeds.positions.resize(kept);
    if (!seeds.heights.empty()) seeds.heights.resize(kept);
    seeds.ids.resize(kept);
}

/// The stages in the plane of a valid prism.
Result<PlanarFracture> cutInPlane(const Recipe& recipe, Prism prism, const TaskContext& task) {
    Result<Seeds> seeds = seedsOf(recipe.pattern, prism.outline, task.stage(0.0, 0.25));
    if (!seeds) return seeds.error();
    PlanarFracture cut{.prism = std::move(prism), .seeds = std::move(*seeds), .delaunay = {}, .partition = {}};
    if (const Status made = computePartition(recipe.pattern, cut, task.stage(0.25, 0.9)); !made) return made.error();
    const SmallPieces& small = recipe.shaping.smallPieces;
    while (small.rule == SmallPieceRule::DropSeeds) {
        const std::vector<std::uint32_t> dropped = seedsToDrop(cut.partition, small, cut.prism.depth);
        if (dropped.empty()) break;
        dropSeeds(dropped, cut.seeds);
        if (const Status made = computePartition(recipe.pattern, cut, task.stage(0.9, 0.9)); !made) return made.error();
    }
    if (!recipe.edits.empty()) {
        cut.partition =
            editedPieces(std::move(cut.partition), cut.seeds, recipe.edits, recipe.place, Vec2{recipe.offset});
    }
    if (small.rule != SmallPieceRule::Keep) {
        cut.partition = withoutSmallPieces(std::move(cut.partition), small, cut.prism.depth);
    }
    return cut;
}

/// The fragments of a mesh, before those are shaped. A mesh without seeds is one cell.
Result<SolidPartition> cutInSpace(const Pattern& pattern, const TriangleMesh& mesh, const Seeds& seeds,
                                  const TaskContext& task) {
    std::vector<Vec3> positions;
    for (std::size_t k = 0; k < seeds.ids.size(); ++k) positions.push_back(seeds.at(k));
    if (positions.empty()) positions.push_back(boundsOf(mesh).centre());
    return cutWithPattern(pattern, mesh, positions, task);
}

/// The stages of a mesh up to its partition.
Result<SolidPartition> shapedPartition(const Recipe& recipe, const TriangleMesh& mesh, Seeds& seeds,
                                       std::vector<Diagnostic>& diagnostics, const TaskContext& task) {
    Result<SolidPartition> cut = cutInSpace(recipe.pattern, mesh, seeds, task);
    const SmallPieces& small = recipe.shaping.smallPieces;
    while (cut && small.rule == SmallPieceRule::DropSeeds && !seeds.ids.empty()) {
        const std::vector<std::uint32_t> dropped = seedsToDrop(*cut, small);
        if (dropped.empty()) break;
        dropSeeds(dropped, seeds);
        cut = cutInSpace(recipe.pattern, mesh, seeds, task);
    }
    if (cut && !seeds.ids.empty()) diagnostics = seedReports(*cut);
    if (cut && !recipe.edits.empty()) {
        cut =
            editedFragments(std::move(*cut), seeds, recipe.edits, recipe.place, Vec2{recipe.offset}, diagnostics, task);
    }
    if (!cut) return cut.error();
    if (small.rule != SmallPieceRule::Keep) *cut = withoutSmallFragments(std::move(*cut), small, seeds, diagnostics);
    if (seeds.ids.empty()) {
        std::ranges::fill(cut->seedOfFragment, kNone);
        cut->fragmentOfSeed.clear();
    }
    return cut;
}

}  // namespace

Error ofAsset(const Asset& asset, const Error& error) {
    if (error.code == ErrorCode::Cancelled) return error;
    return {error.code, "Asset " + quotedName(asset.name) + ": " + error.message};
}

Recipe recipeOf(const Asset& asset) { return {asset.pattern, asset.shaping, asset.edits, {}, {}}; }

Recipe recipeOf(const Asset& asset, const std::string& fragmentId, const Level& level, Vec3 offset) {
    return {patternFor(fragmentId, level.pattern), asset.shaping, asset.edits, pathOfId(fragmentId), offset};
}

double gapOf(const Recipe& recipe) { return std::max(recipe.shaping.gap, jointWidthOf(recipe.pattern)); }

Result<PlanarFracture> planarFracture(const Recipe& recipe, Prism prism, const TaskContext& task) {
    Result<Prism> valid = validated(std::move(prism));
    if (!valid) return valid.error();
    const double pieces = estimatedPieces(recipe.pattern, area(valid->outline));
    const BakeEstimate estimate{pieces, 1.0, pieces};
    if (const std::optional<std::string> fault = sizeFault(estimate)) return Error{ErrorCode::Limit, *fault};
    return cutInPlane(recipe, std::move(*valid), task);
}

Result<FractureResult> fractureResult(const Recipe& recipe, Prism prism, const TaskContext& task) {
    Result<Prism> valid = validated(std::move(prism));
    if (!valid) return valid.error();
    Result<PlanarFracture> cut = cutInPlane(recipe, std::move(*valid), task.stage(0.0, 0.8));
    if (!cut) return cut.error();
    Result<Fragments> fragments =
        extrudedFragments(cut->prism, std::move(cut->partition), gapOf(recipe), task.stage(0.8, 1.0));
    if (!fragments) return fragments.error();
    return FractureResult{std::move(cut->prism), std::move(cut->seeds), std::move(cut->delaunay),
                          std::move(*fragments)};
}

Result<FractureResult> fractureResult(const Recipe& recipe, const TriangleMesh& mesh, const TaskContext& task) {
    const Result<SolidDomain> domain = SolidDomain::of(mesh, task);
    if (!domain) return domain.error();
    Result<Seeds> seeds = seedsOf(recipe.pattern, *domain, task.stage(0.0, 0.2));
    if (!seeds) return seeds.error();
    std::vector<Diagnostic> diagnostics;
    Result<SolidPartition> cut = shapedPartition(recipe, mesh, *seeds, diagnostics, task.stage(0.2, 0.6));
    if (!cut) return cut.error();
    Result<Fragments> fragments = solidFragments(std::move(*cut), gapOf(recipe), recipe.hulls, task.stage(0.6, 1.0));
    if (!fragments) return fragments.error();
    fragments->diagnostics.insert(fragments->diagnostics.begin(), diagnostics.begin(), diagnostics.end());
    return FractureResult{{}, std::move(*seeds), {}, std::move(*fragments)};
}

TriangleMesh meshInOwnFrame(const Fragment& fragment) {
    const SolidFragments& all = *fragment.all().solid();
    TriangleMesh mesh = all.meshOf(fragment.index());
    for (Vec3& point : mesh.points) point -= all.masses[fragment.index()].centre;
    return mesh;
}

Result<FractureResult> fractureResult(const Recipe& recipe, const Asset& asset, const TaskContext& task) {
    const ClosedMesh* mesh = asset.mesh();
    return mesh ? fractureResult(recipe, mesh->mesh, task) : fractureResult(recipe, asset.prism(), task);
}

Result<FractureResult> fractureResult(const Recipe& recipe, const Fragment& fragment, const TaskContext& task) {
    const std::optional<ExtrudedFragment> extruded = fragment.extruded();
    if (!extruded) return fractureResult(recipe, meshInOwnFrame(fragment), task);
    return fractureResult(recipe, Prism{extruded->outline(), extruded->depth()}, task);
}

Pattern patternFor(const std::string& fragmentId, Pattern pattern) {
    const std::uint64_t fragment = contentHash(fragmentId).low;
    for (PatternLayer& layer : pattern.layers) layer.randomSeed = mixSeeds(layer.randomSeed, fragment);
    return pattern;
}

std::string fragmentId(const std::string& parentId, const Seeds& seeds, const Fragment& fragment) {
    return parentId + "/" + fragmentName(fragment, seeds.ids);
}

}  // namespace rubble
