#include "core/asset/bake/BakeEstimate.h"

#include "core/asset/bake/Bake.h"
#include "core/asset/project/AssetShape.h"
#include "core/base/MessageText.h"
#include "core/fracture/pattern/PieceEstimate.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace rubble {
namespace {

// Measured: 10 million fragments of one fracture, and 8,000 fractures into two.
constexpr double kBytesPerFragment = 260.0;
constexpr double kBytesPerFracture = 4000.0;
// Measured at the peak, beyond what is kept: 10,000 to 200,000 fragments of one and of several fractures.
constexpr double kBakeBytesPerFragment = 500.0;     // of the largest fracture; 300 to bake it, 800 to verify it
constexpr double kExportBytesPerFragment = 8000.0;  // of its pack
constexpr double kPlayBytesPerFragment = 4400.0;

// Measured for meshes of 10,000 and 100,000 triangles in 1,000 to 4,000 fragments, without and with a gap.
constexpr double kMeshBytesPerFragment = 8000.0;
constexpr double kMeshBytesPerTriangle = 180.0;
constexpr double kShrunkBytesPerFragment = 20500.0;  // of one less a gap, beyond
constexpr double kShrunkBytesPerTriangle = 150.0;
constexpr double kMeshBakeBytesPerFragment = 1500.0;  // of the largest fracture; at the peak, beyond what is kept
constexpr double kMeshBakeBytesPerTriangle = 300.0;
constexpr double kMeshPlayBytesPerFragment = 10000.0;
constexpr double kMeshPlayBytesPerTriangle = 40.0;

std::string estimateText(double number) {
    return number < 1e15 ? messageText(std::round(number)) : "more than " + messageText(1e15);
}

std::string gigabytes(double bytes) {
    const double size = bytes / (1024.0 * 1024.0 * 1024.0);
    return (size < 10.0 ? roundedText(size, 2) : estimateText(size)) + " GiB";
}

}  // namespace

double BakeEstimate::bytes(MemoryStage stage) const {
    const double kept = kBytesPerFragment * (fragments - ofMeshes) + kBytesPerFracture * fractures +
                        kMeshBytesPerFragment * ofMeshes + kMeshBytesPerTriangle * triangles +
                        kShrunkBytesPerFragment * shrunk + (shrunk > 0.0 ? kShrunkBytesPerTriangle * triangles : 0.0);
    switch (stage) {
        case MemoryStage::Kept: break;
        case MemoryStage::Bake:
            return kept + (ofMeshes > 0.0 ? kMeshBakeBytesPerFragment : kBakeBytesPerFragment) * largest +
                   kMeshBakeBytesPerTriangle * triangles;
        case MemoryStage::Export: return kept + (kExportBytesPerFragment + meshBytes) * fragments;
        case MemoryStage::Play:
            return kept + kPlayBytesPerFragment * (fragments - ofMeshes) + kMeshPlayBytesPerFragment * ofMeshes +
                   kMeshPlayBytesPerTriangle * triangles;
    }
    return kept;
}

BakeEstimate estimateOf(const Bake& bake) {
    BakeEstimate estimate{static_cast<double>(bake.fragmentCount()), static_cast<double>(bake.fractures.size())};
    for (const BakedFracture& fracture : bake.fractures) {
        const SolidFragments* solid = fracture.fragments.solid();
        if (!solid) continue;
        estimate.ofMeshes += fracture.fragments.count();
        if (solid->shrunk) estimate.shrunk += fracture.fragments.count();
        for (const SolidPartition::Face& face : solid->partition.faces)
            estimate.triangles += face.behind == kNone ? 1.0 : 0.0;
    }
    return estimate;
}

BakeEstimate estimateOf(const Asset& asset) {
    // What patterns fill: the outline, or the mesh.
    const double volume = volumeOf(asset);
    const double whole = asset.isPrism() ? std::abs(area(asset.prism().outline)) : volume;
    double count = estimatedPieces(asset.pattern, whole);
    BakeEstimate estimate{count, 1.0, count};
    if (const ClosedMesh* mesh = asset.mesh()) estimate.triangles = static_cast<double>(mesh->mesh.triangles.size());
    const double triangles = estimate.triangles;
    for (const Level& level : asset.levels) {
        // No more fragments than this have the minimum volume.
        const double most = level.minimumVolume > 0.0 ? volume / level.minimumVolume : count;
        const double parents = std::min(count, most);
        if (parents < 1.0) break;
        const double each = estimatedPieces(level.pattern, whole / count);
        if (each <= 1.0) break;
        count = parents * each;
        estimate.fragments += count;
        estimate.fractures += parents;
        estimate.triangles += triangles;
        estimate.largest = std::max(estimate.largest, each);
    }
    if (asset.isPrism()) return estimate;
    estimate.ofMeshes = estimate.fragments;
    if (asset.shaping.gap > 0.0) estimate.shrunk = estimate.fragments;
    return estimate;
}

std::optional<std::string> sizeFault(const BakeEstimate& estimate) {
    const double bytes = estimate.bytes(MemoryStage::Bake);
    if (bytes <= kMaxBakeBytes) return std::nullopt;  // false for NaN
    return "about " + estimateText(estimate.fragments) + " fragments would take " + gigabytes(bytes) +
           " of memory; at most " + gigabytes(kMaxBakeBytes) +
           " are allowed. Use fewer seeds or levels, or a larger minimum volume.";
}

std::optional<std::string> stageFault(const BakeEstimate& estimate, MemoryStage stage) {
    const double bytes = estimate.bytes(stage);
    if (bytes <= kMaxTotalBakeBytes) return std::nullopt;  // false for NaN
    const bool isExport = stage == MemoryStage::Export;
    return std::string(isExport ? "exporting" : "simulating") + " about " + estimateText(estimate.fragments) +
           " fragments would take " + gigabytes(bytes) + " of memory; at most " + gigabytes(kMaxTotalBakeBytes) +
           " are allowed. Use fewer seeds or levels, " +
           (isExport ? "a larger minimum volume, or fewer formats." : "or a larger minimum volume.");
}

std::optional<std::string> totalSizeFault(std::size_t bakes, double bytes) {
    if (bytes <= kMaxTotalBakeBytes) return std::nullopt;  // false for NaN
    return "The fragments of all " + std::to_string(bakes) + " assets and variants would take " + gigabytes(bytes) +
           " of memory; at most " + gigabytes(kMaxTotalBakeBytes) +
           " are allowed. Use fewer seeds, levels, assets or variants.";
}

int bakesAtOnce(std::vector<double> bytes, int threads) {
    std::ranges::sort(bytes, std::greater{});
    double sum = 0.0;
    int count = 0;
    for (const double each : bytes) {
        sum += each;
        if (count == threads || sum > kMaxTotalBakeBytes) break;
        ++count;
    }
    return std::max(1, count);
}

}  // namespace rubble
