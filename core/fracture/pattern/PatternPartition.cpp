#include "core/fracture/pattern/PatternPartition.h"

#include "core/fracture/cuts/CutPartition.h"
#include "core/fracture/pattern/AnisotropyMap.h"
#include "core/fracture/pattern/PatternCuts.h"
#include "core/fracture/voronoi/VoronoiPartition.h"

namespace rubble {

Result<TriangulatedPartition> cellsOf(const Pattern& pattern, std::span<const Vec2> seeds, const Polygon& outline,
                                      const TaskContext& task) {
    const std::optional<AnisotropyMap> grain = AnisotropyMap::of(pattern, outline);
    Result<Delaunay> delaunay =
        grain ? triangulate((*grain)(seeds), task.stage(0.0, 0.7)) : triangulate(seeds, task.stage(0.0, 0.7));
    if (!delaunay) return delaunay.error();
    Result<Partition> partition =
        voronoiPartition(grain ? (*grain)(outline) : outline, *delaunay, task.stage(0.7, 1.0));
    if (!partition) return partition.error();
    return TriangulatedPartition{std::move(*delaunay),
                                 grain ? grain->inverse(std::move(*partition), outline) : std::move(*partition)};
}

Result<TriangulatedPartition> partitionOf(const Pattern& pattern, std::span<const Vec2> seeds, const Polygon& outline,
                                          const TaskContext& task) {
    if (!hasCuts(pattern)) return cellsOf(pattern, seeds, outline, task);
    Result<TriangulatedPartition> cells = cellsOf(pattern, seeds, outline, task.stage(0.0, 0.8));
    if (!cells) return cells.error();
    const Result<CutSet> cuts = cutsOf(pattern, outline, task);
    if (!cuts) return cuts.error();
    Result<Partition> cut = cutApart(std::move(cells->partition), outline, *cuts, task.stage(0.8, 1.0));
    if (!cut) return cut.error();
    return TriangulatedPartition{std::move(cells->delaunay), std::move(*cut)};
}

Result<PatternStages> patternStages(const Pattern& pattern, const Polygon& outline, const TaskContext& task) {
    Result<Seeds> seeds = seedsOf(pattern, outline, task.stage(0.0, 0.3));
    if (!seeds) return seeds.error();
    Result<TriangulatedPartition> cut = partitionOf(pattern, seeds->positions, outline, task.stage(0.3, 1.0));
    if (!cut) return cut.error();
    return PatternStages{std::move(*seeds), std::move(cut->delaunay), std::move(cut->partition)};
}

SeedId cellId(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds) {
    if (const std::uint32_t seed = partition.seedOfPiece[piece]; seed != kNone) return seeds[seed];
    return partition.cutLayers.empty() ? SeedId{} : SeedId{partition.cutLayers[0], partition.cutCellsOf(piece)[0]};
}

std::string cellName(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds) {
    std::string name;
    const auto add = [&name](SeedId id) { name += (name.empty() ? "" : "+") + id.text(); };
    if (const std::uint32_t seed = partition.seedOfPiece[piece]; seed != kNone) add(seeds[seed]);
    const std::span<const std::uint32_t> cells = partition.cutCellsOf(piece);
    for (std::size_t k = 0; k < cells.size(); ++k) add({partition.cutLayers[k], cells[k]});
    if (name.empty()) add({});
    return name;
}

std::string pieceName(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds) {
    const std::string name = cellName(partition, piece, seeds);
    const std::uint32_t part = partOfCell(partition, piece);
    return part == kNone ? name : name + "." + std::to_string(part);
}

}  // namespace rubble
