#include "core/fracture/pattern/PieceEstimate.h"

#include <algorithm>
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
double piecesOf(const Slices& layer, double) { return static_cast<double>(layer.cuts); }
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

}  // namespace

double estimatedPieces(const Pattern& pattern, double area) {
    if (verifyPattern(pattern)) return 1.0;
    double pieces = 0.0;
    for (const PatternLayer& layer : pattern.layers) {
        if (layer.isOn) pieces += std::visit([&](const auto& kind) { return piecesOf(kind, area); }, layer.parameters);
    }
    return std::max(1.0, pieces);
}

}  // namespace rubble
