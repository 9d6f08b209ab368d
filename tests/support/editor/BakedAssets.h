#pragma once

#include "core/asset/bake/AssetBakes.h"
#include "editor/document/Bakes.h"

namespace rubble::test {

/// Bakes all assets of a project, with the variants that its instances use.
inline void bakeAll(const Project& project, Bakes& bakes) {
    const AssetBakes all = *bakesOf(project);
    for (const Asset& asset : project.assets) {
        BakedAsset baked{
            .asset = std::make_shared<const Asset>(asset), .bake = all.at({asset.id}), .fault = {}, .variants = {}};
        for (const auto& [variant, bake] : all) {
            if (variant.asset == asset.id && variant.variant != 0) baked.variants[variant.variant] = bake;
        }
        bakes.set(asset.id, std::make_shared<const BakedAsset>(std::move(baked)));
    }
}

}  // namespace rubble::test
