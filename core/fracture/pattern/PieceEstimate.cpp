#include "core/fracture/pattern/PieceEstimate.h"

#include "core/base/Trigonometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

double piecesOf(const UniformScatter& layer, double area) { return layer.count.in(area); }
double piecesOf(const ImpactScatter& layer, double area) { return layer.count.in(area); }
double piecesOf(const DensityImage& layer, double area) { return layer.count.in(area); }

double piecesOf(const BlueNoise& layer, double area) {
    constexpr double kJammedDensity = 0.7;  // seeds within a square of the minimum distance, when no more fit
    const double most = std::max(1.0, kJammedDensity * area / layer.minimumDistance / layer.minimumDistance);
    const bool isAsManyAsFit = layer.count.by == CountBy::Number && layer.count.amount == 0.0;
    return isAsManyAsFit ? most : std::min(most, layer.count.in(area));
}

double piecesOf(const PlacedSeeds& layer, double) { return static_cast<double>(layer.seeds.size()); }
double piecesOf(const CrackLines& layer, double) { return static_cast<double>(layer.lines.size()); }
double piecesOf(const Slices&, double) { return 0.0; }  // see piecesOfSlices()
double piecesOf(const LloydRelaxation&, double) { return 0.0; }
double piecesOf(const WeightedLloyd&, double) { return 0.0; }
double piecesOf(const Grain&, double) { return 0.0; }

double piecesOf(const JitteredGrid& layer, double area) {
    if (layer.cells == GridCells::Number) return static_cast<double>(layer.columns) * layer.rows;
    return area / layer.cellWidth / layer.cellHeight;
}

double piecesOf(const Clusters& layer, double) { return static_cast<double>(layer.clusters) * layer.seedsPerCluster; }
double piecesOf(const RadialPattern& layer, double) { return static_cast<double>(layer.rings) * layer.spokes + 1.0; }

double piecesOf(const BrickBond& layer, double area) {
    return area / (layer.length + layer.mortar) / (layer.height + layer.mortar);
}

double piecesOf(const HexagonalLattice& layer, double area) {
    return 2.0 / std::numbers::sqrt3 * area / layer.spacing / layer.spacing;
}

std::vector<Slices> slicesOf(const Pattern& pattern) {
    std::vector<Slices> all;
    for (const PatternLayer& layer : pattern.layers) {
        const Slices* slices = std::get_if<Slices>(&layer.parameters);
        if (slices && layer.isOn) all.push_back(*slices);
    }
    return all;
}

/// The pieces that slices add to a square with a number of cells: each adds one for each cell that it passes, and one
/// for each other that it crosses, which all do that are perpendicular.
double piecesOfSlices(const std::vector<Slices>& all, double cells) {
    constexpr double kCellsPerSide = 4.0 / std::numbers::pi;  // random cells that a line passes in a row of sqrt(n)
    double pieces = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const double cuts = all[k].cuts;
        pieces += cuts * (1.0 + kCellsPerSide * (std::sqrt(cells) - 1.0));
        pieces += cuts * (cuts - 1.0) / 2.0 * std::min(1.0, all[k].angleVariation);
        for (std::size_t other = 0; other < k; ++other) {
            const double apart =
                std::abs(sine(all[k].angle) * cosine(all[other].angle) - cosine(all[k].angle) * sine(all[other].angle));
            const double crossing = apart + all[k].angleVariation + all[other].angleVariation;
            pieces += cuts * all[other].cuts * std::min(1.0, crossing);
        }
    }
    return pieces;
}

}  // namespace

double estimatedPieces(const Pattern& pattern, double area) {
    if (verifyPattern(pattern)) return 1.0;
    double pieces = 0.0;
    for (const PatternLayer& layer : pattern.layers) {
        if (layer.isOn) pieces += std::visit([&](const auto& kind) { return piecesOf(kind, area); }, layer.parameters);
    }
    pieces = std::max(1.0, pieces);
    return pieces + piecesOfSlices(slicesOf(pattern), pieces);
}

}  // namespace rubble
