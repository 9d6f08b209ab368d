#pragma once

#include "core/fracture/pattern/PatternKind.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace rubble {

/// An image of 2 x 2 pixels: black, grey, white, and half transparent white.
inline std::shared_ptr<const GreyImage> fourPixels() {
    return std::make_shared<GreyImage>(GreyImage{
        .width = 2, .height = 2, .bits = 8, .grey = {0, 0x7f, 0xff, 0xff}, .opacity = {0xff, 0xff, 0xff, 0x80}});
}

/// Layers of all kinds, with a few seeds each, for outlines with a radius of about a metre around the origin.
inline std::vector<LayerParameters> patternSamples() {
    std::vector<LayerParameters> samples{
        UniformScatter{.count = 12},
        UniformScatter{.count = {CountBy::Density, 8.0}, .domain = ScatterDomain::BoundingBox},
        BlueNoise{.minimumDistance = 0.3},
        BlueNoise{.minimumDistance = 0.2, .count = {CountBy::FragmentSize, 0.35}},
        PlacedSeeds{{{0, {0.1, 0.2}}, {3, {-0.4, 0.3}}, {4, {0.0, -0.5}}}},
        LloydRelaxation{.rounds = 1},
        JitteredGrid{.columns = 4, .rows = 3},
        JitteredGrid{.cells = GridCells::Size,
                     .cellWidth = 0.5,
                     .cellHeight = 0.3,
                     .jitter = 0.0,
                     .domain = ScatterDomain::BoundingBox},
        Clusters{.clusters = 3, .seedsPerCluster = 5, .radius = 0.2},
        RadialPattern{.centre = {0.05, -0.1}, .radius = 0.9, .rings = 3, .spokes = 5},
        RadialPattern{.centre = {-0.3, 0.2}, .rings = 2, .spokes = 6, .exponent = 1.0, .variation = 0.0},
        ImpactScatter{.centre = {0.2, 0.1}, .count = 15},
        ImpactScatter{.centre = {3.0, 0.0}, .count = 10, .radius = 0.01, .falloff = 8.0},
        DensityImage{.count = 14, .dense = DenseWhere::Bright, .image = fourPixels()},
        DensityImage{},
        BrickBond{.length = 0.5, .height = 0.2, .origin = {-1.0, -1.0}},
        BrickBond{.bond = BondKind::Stack, .length = 0.24, .height = 0.24, .mortar = 0.01},
        BrickBond{.bond = BondKind::English, .length = 0.51, .width = 0.25, .height = 0.3, .mortar = 0.0},
        BrickBond{.bond = BondKind::Header, .width = 0.3, .height = 0.3, .origin = {0.013, 0.37}},
        BrickBond{.bond = BondKind::Flemish, .length = 0.4, .width = 0.2, .height = 0.25},
        Slices{},
        Slices{.cuts = 7, .angle = 0.4, .offsetVariation = 1.0, .angleVariation = 0.7},
        Slices{.cuts = 4, .angle = 0.0, .offsetVariation = 0.0, .angleVariation = 0.0},
        CrackLines{{{0, {{-2.0, 0.1}, {0.0, 0.05}, {2.0, -0.2}}},
                    {3, {{0.1, -2.0}, {-0.1, 2.0}}},
                    {4, {{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}, {0.4, 0.4}}},
                    {9, {{0.0, 0.0}, {0.3, 0.55}}}}},
        Grain{.angle = 0.7, .ratio = 4.0},
        WeightedLloyd{.rounds = 2},
        SurfaceScatter{.count = 13, .minDepth = 0.02, .maxDepth = 0.2, .falloff = 2.0}};
    // Kinds without a sample above are tried with their defaults.
    for (const PatternKind* kind : patternKinds()) {
        const bool hasSample =
            std::ranges::any_of(samples, [&](const auto& sample) { return &kindOf(sample) == kind; });
        if (!hasSample) samples.push_back(kind->defaultsFor({{-1.0, -1.0}, {1.0, 1.0}}));
    }
    return samples;
}

}  // namespace rubble
