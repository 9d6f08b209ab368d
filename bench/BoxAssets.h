#pragma once

#include "bench/SeedSets.h"
#include "core/asset/project/Project.h"
#include "core/geometry/polygon/OutlineShapes.h"

namespace rubble::bench {

/// A box of 1 x 1 x 0.5 m, fractured by manually placed seeds.
inline Asset boxAsset(const SeedList& seeds) {
    PlacedSeeds placed;
    for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) placed.seeds.push_back({seed, seeds[seed]});
    Asset asset;
    asset.id = 1;
    asset.name = "box";
    asset.material = 1;
    asset.shape = Prism{{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}}, 0.5};
    asset.pattern.layers.push_back({.id = 1, .parameters = std::move(placed)});
    return asset;
}

inline std::vector<Asset> boxAssets(std::size_t seedsInEach) {
    std::vector<Asset> assets;
    for (const SeedList& seeds : seedSets(seedsInEach)) assets.push_back(boxAsset(seeds));
    return assets;
}

/// A project with an instance of a wall of 1.5 x 1 x 0.25 m in `fragments` fragments.
inline Project wallProject(std::uint32_t fragments) {
    Project project;
    project.nextId = 10;
    project.materials = {{.id = 1, .name = "stone"}};
    Asset wall{.id = 2, .name = "wall", .material = 1, .shape = Prism{rectangleOutline(1.5, 1.0), 0.25}};
    wall.pattern.layers = {{.id = 3, .randomSeed = 1, .parameters = UniformScatter{.count = fragments}}};
    project.assets = {wall};
    project.instances = {{.id = 4, .name = "wall", .asset = 2}};
    return project;
}

}  // namespace rubble::bench
