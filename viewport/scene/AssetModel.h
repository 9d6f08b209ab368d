#pragma once

#include "viewport/scene/SceneBuilder.h"

namespace rubble {

/// A piece that is drawn.
struct ModelPiece {
    std::uint32_t fragment = kNone;  // index in the bake; kNone: the whole
    Vec3 offset{0.0, 0.0, 0.0};      // its frame's origin in the prism's frame, m
    double volume = 0.0;             // m^3
    double parentShare = 1.0;        // of the whole's volume, that what it is a part of has
    double aspect = 1.0;             // see aspectOf()
    std::uint32_t level = 0;
    Colour colour;  // its own, by its id
};

/// Two pieces that touch.
struct ModelBond {
    std::uint32_t first = 0, second = 0;  // pieces of the model
    double area = 0.0;                    // m^2 shared
};

struct AssetModel {
    Asset asset;                       // it was made from
    std::shared_ptr<const Bake> bake;  // null: of the whole
    std::uint32_t level = kNone;
    std::uint32_t variant = 0;  // that its instances are of
    std::shared_ptr<const SceneGeometry> geometry;
    std::shared_ptr<const SceneGeometry> hulls;           // null where they were not asked for
    std::vector<ModelPiece> pieces;                       // one a piece of the geometry
    std::shared_ptr<const std::vector<ModelBond>> bonds;  // each once; null where they were not asked for
};

/// The model of a bake's fragments, or of the asset as a whole where there is no bake. One without pieces where the prism
/// cannot be fractured.
AssetModel modelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options);

/// The model of all that an asset can become when it is played: piece 0 is the whole, in the prism's frame, piece k + 1 the
/// fragment k of its bake, of any level.
AssetModel playModelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options);

}  // namespace rubble
