#pragma once

#include "core/asset/bake/AssetBakes.h"
#include "viewport/scene/RenderScene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

/// The property that solids are coloured by. Threshold: that of the parent, whose break releases the solid.
/// BondStrength: the mean of the solid's bonds.
enum class SceneColouring { Material, Fragment, Level, Volume, Mass, Aspect, Threshold, BondStrength, Cluster };

/// The content of a scene.
struct SceneOptions {
    Id asset = 0;  // shows this asset alone, in its prism's frame; 0: all instances at their poses
    SceneColouring colouring = SceneColouring::Material;
    std::uint32_t level = kNone;  // the deepest level shown; kNone: the leaf fragments
    double explodeFactor = 0.0;   // 0: assembled; 1: twice as far from the centre
    bool hasHulls = false;
    bool hasBonds = false;  // lines between bonded solids, their width by area
    bool isWhole = false;   // ignores the bakes
    SceneMarks marks;
};

struct AssetModel;

/// Builds scenes and keeps the geometry of the last one: unchanged geometry is shared with it, by pointer, and is
/// neither built nor uploaded again.
class SceneBuilder {
public:
    /// The project's instances, or one asset. An asset without a bake is shown whole; missing assets and prisms that
    /// cannot be fractured are left out. An asset by itself stands on the ground. Bodies are ordered by asset, then by
    /// instance in the project's order, then by solid in the bake's order. Linear in bodies, and in the vertices of new
    /// bakes.
    RenderScene sceneOf(const Project& project, const AssetBakes& bakes, const SceneOptions& options);

private:
    std::vector<std::shared_ptr<const AssetModel>> m_models;
    std::shared_ptr<const std::vector<glm::vec4>> m_restOffsets;
};

/// The same without a cache.
RenderScene sceneOf(const Project& project, const AssetBakes& bakes, const SceneOptions& options = {});

}  // namespace rubble
