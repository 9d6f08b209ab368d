#pragma once

#include "core/asset/Project.h"
#include "viewport/scene/SceneGeometry.h"
#include "viewport/scene/SurfaceHeat.h"

#include <glm/vec4.hpp>

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// What a click hits: a fragment of an asset, where it stands. As a mark of what is hidden or selected it may also name
/// many: an instance of 0 stands for all, a fragment of kNone for all fragments and the whole.
struct PickId {
    Id asset = 0;
    Id instance = 0;                 // 0: the asset by itself
    std::uint32_t fragment = kNone;  // index in Bake::fragments; kNone: the whole
    std::uint32_t origin = 0;        // in play: index in Session::origins(); as a mark it says nothing
    auto operator<=>(const PickId&) const = default;
};

/// Where a body stands.
struct DrawnPose {
    glm::vec4 position{
        0.0f};  // m, relative to RenderScene::origin; w: how much it has shrunk, 0 as it is, 1 to a point
    glm::vec4 orientation{0.0f, 0.0f, 0.0f, 1.0f};  // scene from piece: x, y, z, w
    bool operator==(const DrawnPose&) const = default;
};

/// Where a pose is drawn in a scene with that origin.
DrawnPose drawnPose(const Pose& pose, Vec3 origin);

/// Between two poses: `share` 0 gives `from`, 1 gives `to`. Turns the shorter way round, as shaders do.
DrawnPose between(const DrawnPose& from, const DrawnPose& to, double share);

/// What a body looks like. Colours are sRGB, 0xRRGGBB.
struct BodyLook {
    std::uint32_t outside = 0xcccccc;
    std::uint32_t inside = 0x999999;
    std::uint32_t marks = 0;  // of kHidden, kSelected, kHovered
    std::uint32_t heat = 0;   // its row in RenderScene::heats, and one; 0: it has the same colour all over
};
inline constexpr std::uint32_t kHidden = 1;
inline constexpr std::uint32_t kSelected = 2;
inline constexpr std::uint32_t kHovered = 4;

/// All instances of one geometry.
struct SceneBatch {
    std::shared_ptr<const SceneGeometry> geometry;
    std::shared_ptr<const SceneGeometry> hulls;  // the same pieces as convex hulls; null where they are not shown
    std::vector<std::uint32_t> firstBodies;      // an instance each: the body of its piece 0, others follow
    bool operator==(const SceneBatch&) const = default;
};

/// A line in the scene, as wide in the picture wherever it is; seen faintly where something is before it.
struct SceneStroke {
    glm::vec4 from{0.0f};    // m, relative to RenderScene::origin; w: its radius, points
    glm::vec4 to{0.0f};      // the same as `from` for a dot; w: of StrokeEnd
    glm::vec4 colour{1.0f};  // sRGB and opacity
    glm::vec4 back{0.0f};    // m: how far off it was a step before
};
enum class StrokeEnd { Round, Arrow };

/// A cloud of dust that faces whoever looks at it.
struct DustPuff {
    glm::vec4 place{0.0f};   // m, relative to RenderScene::origin; w: its radius, m
    glm::vec4 back{0.0f};    // m: how far off it was a step before; w: opacity in its middle
    glm::vec4 colour{1.0f};  // sRGB; w: what its shape is told apart by, in [0, 1)
};

/// Numbers from the least to the greatest.
struct ValueRange {
    double least = 0.0;
    double most = 0.0;
    bool operator==(const ValueRange&) const = default;
};

/// What is asked of a scene as a whole.
struct SceneSummary {
    Box3 bounds;  // as boundsOf() gives it
    bool hasSelected = false;
};

/// A whole picture as a value: everything that is drawn but not from where. Geometry is shared and large; the rest is
/// small, a few numbers a body, so that moving, colouring, selecting and exploding cost little.
struct RenderScene {
    Vec3 origin{0.0, 0.0, 0.0};  // m, in the world: motions are relative to it, which keeps their digits
    std::vector<SceneBatch> batches;
    std::vector<DrawnPose> motions;  // this and the following: one a body
    std::vector<BodyLook> looks;
    std::vector<PickId> picks;
    std::vector<DrawnPose> earlier;  // motions a step before, of what was there then; empty where nothing moves
    std::vector<glm::vec4> apart;    // m, where to at an exploded factor of 1; empty where nothing is exploded
    double exploded = 0.0;           // factor of `apart`
    bool isOutdoors = false;         // under a sky with a horizon and with a scale, as in play
    bool hasGround = true;
    double groundHeight = 0.0;              // m
    std::optional<ValueRange> colourRange;  // of what bodies are coloured by, where that is a figure
    double largestBond = 0.0;               // m^2: what the widest line between pieces stands for; 0: there are none
    std::vector<SceneStroke> strokes;
    std::vector<SceneStroke> boxes;  // along the axes, from one corner to the opposite
    std::vector<DustPuff> puffs;
    std::vector<SurfaceHeat> heats;  // of bodies that are coloured by heat, place by place
    HeatSource heatSource;
    std::optional<SceneSummary> summary;  // of this scene, found where it was made; none: whoever asks finds it
};

/// Where a body is drawn at a moment in [0, 1] of the step that led to the scene (see PictureView).
DrawnPose poseAt(const RenderScene& scene, std::uint32_t body, double moment);

/// How far a body is moved in the exploded view, m.
Vec3 movedApart(const RenderScene& scene, std::uint32_t body);

/// Marks bodies anew: a body is hidden, selected or hovered where one of the ids stands for it.
struct SceneMarks {
    std::vector<PickId> hidden;
    std::vector<PickId> selected;
    std::vector<PickId> hovered;
};
void setMarks(RenderScene& scene, const SceneMarks& marks);

/// A box in the world around all bodies that are not hidden, as exploded as they are, where they are and where they were
/// earlier; around those only that have one of `marks`, where it is given. Empty (min > max) where there are none.
Box3 boundsOf(const RenderScene& scene, std::uint32_t marks = 0);
/// The same with bodies at these poses, of all of them.
Box3 boundsAt(const RenderScene& scene, std::span<const DrawnPose> poses, std::uint32_t marks = 0);

/// The scene's own, or found anew where it has none. Linear in bodies then.
SceneSummary summaryOf(const RenderScene& scene);

}  // namespace rubble
