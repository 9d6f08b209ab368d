#pragma once

#include "core/asset/AssetBakes.h"
#include "viewport/scene/RenderScene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

/// What the colours of pieces say. Threshold: at which what a piece is a part of breaks, so that it comes loose.
enum class SceneColouring { Material, Piece, Level, Volume, Mass, Aspect, Threshold };

/// What a scene shows and how.
struct SceneOptions {
    Id asset = 0;  // only this one, in its prism's frame; 0: every instance where it stands
    SceneColouring colouring = SceneColouring::Material;
    std::uint32_t level = kNone;  // the deepest level that is shown; kNone: down to the smallest fragments
    double exploded = 0.0;        // 0: together; at 1, twice as far from the middle as they are
    bool hasHulls = false;
    bool hasBonds = false;  // lines from middle to middle of pieces that touch, as wide as what they share
    bool isWhole = false;   // bakes are left aside
    SceneMarks marks;
};

/// An asset as it is drawn; shared by all scenes until its bake or its prism changes.
struct AssetModel;

/// Makes scenes, keeping the geometry of the last one: what did not change is shared with it, by pointer, and need
/// not be made or uploaded again.
class SceneBuilder {
public:
    /// The project's instances, or one asset; an asset without a bake is shown whole. Instances of assets that are not there, and assets whose prism cannot be
    /// fractured, are left out. An asset by itself stands on the ground. Bodies: instance by instance, in the project's
    /// order within each asset; pieces in the bake's order. Linear in bodies, and in the corners of new bakes.
    RenderScene sceneOf(const Project& project, const AssetBakes& bakes, const SceneOptions& options);

private:
    std::vector<std::shared_ptr<const AssetModel>> m_models;
};

/// The same with nothing kept.
RenderScene sceneOf(const Project& project, const AssetBakes& bakes, const SceneOptions& options = {});

}  // namespace rubble
