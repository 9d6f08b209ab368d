#include "core/fracture/pattern/PieceEstimate.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/sampling/SolidDomain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

/// 0 for kinds that adjust seeds, and for slices: see piecesOfSlices().
double piecesOf(const LayerParameters& parameters, double area) {
    const auto estimate = [&](const auto& kind) {
        if constexpr (requires { kind.estimatedPieces(area); }) {
            return kind.estimatedPieces(area);
        } else {
            return 0.0;
        }
    };
    return std::visit(estimate, parameters);
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
        if (layer.isOn) pieces += piecesOf(layer.parameters, area);
    }
    pieces = std::max(1.0, pieces);
    return pieces + piecesOfSlices(slicesOf(pattern), pieces);
}

double estimatedPieces(const Pattern& pattern, const SolidDomain& domain) {
    if (verifyPattern(pattern)) return 1.0;
    double pieces = 0.0;
    const auto estimate = [&](const auto& kind) {
        if constexpr (requires { kind.estimatedPiecesIn(domain); }) {
            return kind.estimatedPiecesIn(domain);
        } else {
            return 0.0;
        }
    };
    for (const PatternLayer& layer : pattern.layers) {
        if (layer.isOn) pieces += std::visit(estimate, layer.parameters);
    }
    return std::max(1.0, pieces);
}

}  // namespace rubble
