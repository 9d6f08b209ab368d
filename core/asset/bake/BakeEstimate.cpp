#include "core/asset/bake/BakeEstimate.h"

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

std::string estimateText(double number) {
    return number < 1e15 ? messageText(std::round(number)) : "more than " + messageText(1e15);
}

std::string gigabytes(double bytes) {
    const double size = bytes / (1024.0 * 1024.0 * 1024.0);
    return (size < 10.0 ? roundedText(size, 2) : estimateText(size)) + " GiB";
}

}  // namespace

double BakeEstimate::bytes(MemoryStage stage) const {
    const double kept = kBytesPerFragment * fragments + kBytesPerFracture * fractures;
    switch (stage) {
        case MemoryStage::Kept: break;
        case MemoryStage::Bake: return kept + kBakeBytesPerFragment * largest;
        case MemoryStage::Export: return kept + (kExportBytesPerFragment + meshBytes) * fragments;
        case MemoryStage::Play: return kept + kPlayBytesPerFragment * fragments;
    }
    return kept;
}

BakeEstimate estimateOf(const Asset& asset) {
    // What patterns fill: the outline, or the mesh.
    const double volume = volumeOf(asset);
    const double whole = asset.isPrism() ? std::abs(area(asset.prism().outline)) : volume;
    double count = estimatedPieces(asset.pattern, whole);
    BakeEstimate estimate{count, 1.0, count};
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
        estimate.largest = std::max(estimate.largest, each);
    }
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
