#pragma once

#include "viewport/scene/SceneBuilder.h"

namespace rubble {

/// One drawn solid of an asset.
struct ModelSolid {
    std::uint32_t fragment = kNone;     // index in the bake; kNone: the whole
    Vec3 offset{0.0, 0.0, 0.0};         // origin of its frame in the prism's frame, m
    double volume = 0.0;                // m³
    std::uint32_t parent = kNone;       // fragment of the bake that it is a solid of; kNone: the whole
    double parentVolumeFraction = 1.0;  // volume of its parent ÷ volume of the whole
    double aspect = 1.0;                // see aspectRatio()
    std::uint32_t level = 0;
    Colour colour;  // derived from its id
};

/// The common face of two solids.
struct ModelBond {
    std::uint32_t first = 0, second = 0;  // solids of the model
    std::uint32_t fracture = 0;           // of the bake
    double area = 0.0;                    // m²
    Vec2 centroid{0.0};                   // m, in the prism's plane
};

/// The drawable form of one variant of an asset.
struct AssetModel {
    Asset asset;                       // its source
    std::shared_ptr<const Bake> bake;  // null: the whole asset is drawn
    std::uint32_t level = kNone;
    std::uint32_t variant = 0;
    std::shared_ptr<const SceneGeometry> geometry;
    std::shared_ptr<const SceneGeometry> hulls;           // null if not requested
    std::vector<ModelSolid> solids;                       // one per solid of the geometry
    std::shared_ptr<const std::vector<ModelBond>> bonds;  // each once; null if not requested
};

/// Whether the options need the bonds of a model.
bool needBonds(const SceneOptions& options);

/// A batch of a model without instances. Only where bodies are coloured by material it has the model's texture.
SceneBatch batchOf(const AssetModel& model, const SceneOptions& options);

/// The model of a bake's fragments, or of the whole asset if `bake` is null. It has no solids if the prism cannot be
/// fractured.
AssetModel modelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options);

/// The model of the asset and all its fragments, for play: solid 0 is the whole, in the prism's frame; solid k + 1 is
/// fragment k of the bake, of any level.
AssetModel playModelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options);

}  // namespace rubble
