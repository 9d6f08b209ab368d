#pragma once

#include "core/asset/finish/AssetFinish.h"
#include "core/asset/project/Project.h"
#include "viewport/scene/SceneGeometry.h"

#include <glm/vec4.hpp>

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// The body under a pixel: one fragment of one instance. In SceneMarks it may match several bodies: instance 0 matches
/// all instances, fragment kNone matches all fragments and the whole.
struct PickId {
    Id asset = 0;
    Id instance = 0;                 // 0: the asset shown by itself
    std::uint32_t fragment = kNone;  // index in Bake::fragments; kNone: the whole
    std::uint32_t origin = 0;        // in play: index in Session::origins(); ignored in SceneMarks
    auto operator<=>(const PickId&) const = default;
};

/// The pose of a body in the format of the shaders.
struct RenderPose {
    glm::vec4 position{0.0f};  // m, relative to RenderScene::origin; w: shrinkage, from 0 (full size) to 1 (a point)
    glm::vec4 orientation{0.0f, 0.0f, 0.0f, 1.0f};  // scene from solid: x, y, z, w
    bool operator==(const RenderPose&) const = default;
};

/// The pose relative to a scene's origin.
RenderPose renderPose(const Pose& pose, Vec3 origin);

/// Interpolates two poses: `fraction` 0 gives `from`, 1 gives `to`. Rotates the shorter way, as the shaders do.
RenderPose interpolated(const RenderPose& from, const RenderPose& to, double fraction);

/// Colours, marks and outline of a body. Colours are sRGB with a transparency, 0xTTRRGGBB; see packedSurface().
struct BodyAppearance {
    std::uint32_t outside = 0xcccccc;
    std::uint32_t inside = 0x999999;
    std::uint32_t marks = 0;    // bits: kHidden, kSelected, kHovered
    std::uint32_t outline = 0;  // of selected bodies: those with the same number share an outline
    bool operator==(const BodyAppearance&) const = default;
};
/// A colour with an opacity in [0, 1], as in BodyAppearance.
std::uint32_t packedSurface(const Colour& colour, double opacity);
inline constexpr std::uint32_t kTransparencyBits = 0xff000000;

inline constexpr std::uint32_t kHidden = 1;
inline constexpr std::uint32_t kSelected = 2;
inline constexpr std::uint32_t kHovered = 4;

/// All instances of one geometry.
struct SceneBatch {
    std::shared_ptr<const SceneGeometry> geometry;
    std::shared_ptr<const SceneGeometry> hulls;   // the same solids as convex hulls; null if not shown
    std::vector<std::uint32_t> firstBodies;       // per instance: the body of its solid 0; the other solids follow
    std::shared_ptr<const EncodedImage> texture;  // of its textured vertices; null: they are as others
    AssetFinish finish;
    bool operator==(const SceneBatch&) const = default;
};

/// A line in the scene, of constant width on screen; where something occludes it, it is drawn faintly, or not at all.
struct SceneLine {
    glm::vec4 from{0.0f};            // m, relative to RenderScene::origin; w: radius, points
    glm::vec4 to{0.0f};              // equal to `from` for a dot; w: a LineEnd
    glm::vec4 colour{1.0f};          // sRGB and opacity
    glm::vec4 previousOffset{0.0f};  // m: its position one step earlier minus its position now
    bool operator==(const SceneLine&) const = default;
};
enum class LineEnd {
    Round,
    Arrow,
    OnSurface,  // round; it is not seen through what occludes it
};

enum class ParticleKind {
    Dust,
    Spark,  // a streak along its flight that glows
    Flash,  // a short glow
};

/// A billboard of dust, or of something that glows.
struct Particle {
    glm::vec4 position{0.0f};  // m, relative to RenderScene::origin; w: radius, m
    glm::vec4 previousOffset{
        0.0f};  // m: its position one step earlier minus its position now; w: opacity at its centre
    // sRGB; w: its ParticleKind as a number, plus of dust the seed of its noise in [0, 1)
    glm::vec4 colour{1.0f};
    ParticleKind kind() const { return static_cast<ParticleKind>(static_cast<int>(colour.w)); }
    bool operator==(const Particle&) const = default;
};

enum class ChipShape {
    Angular,
    Flat,  // of glass: glints
    Long,  // of wood
};

/// A small solid that came off in a break.
struct Chip {
    glm::vec4 position{0.0f};                    // m, relative to RenderScene::origin; w: radius, m
    glm::vec4 previousOffset{0.0f};              // its position and angle one step earlier minus those now
    glm::vec4 rotation{1.0f, 0.0f, 0.0f, 0.0f};  // the axis, length 1, and the angle, rad: at 0 it lies flat
    glm::vec4 colour{1.0f};  // sRGB; w: its ChipShape as a number plus the seed of its form in [0, 1)
    ChipShape shape() const { return static_cast<ChipShape>(static_cast<int>(colour.w)); }
    bool operator==(const Chip&) const = default;
};

enum class DecalKind {
    Light,      // of a flash
    ShockRing,  // of dust, on what faces upwards
    Scorch,     // on the ground only
};

/// Something projected onto the surfaces around a point.
struct Decal {
    glm::vec4 centre{0.0f};   // m, relative to RenderScene::origin; w: radius, m
    glm::vec4 colour{1.0f};   // sRGB and opacity
    glm::vec4 details{0.0f};  // its DecalKind as a number; its radius one step earlier minus now, m; a seed in [0, 1)
    DecalKind kind() const { return static_cast<DecalKind>(static_cast<int>(details.x)); }
    bool operator==(const Decal&) const = default;
};

/// What an impact or a blast left on a body. Drawn on its opaque surfaces.
struct SurfaceMark {
    glm::vec4 centre{0.0f};  // m, in the frame of the body's solid; w: radius, m
    glm::vec4 normal{0.0f};  // of the surface, length 1, in that frame; soot has none; w: a seed in [0, 1)
    std::uint32_t body = 0;
    bool operator==(const SurfaceMark&) const = default;
};
inline constexpr std::size_t kMaxMarksOfBody = 8;  // that are drawn

/// A closed interval of numbers.
struct ValueRange {
    double least = 0.0;
    double most = 0.0;
    bool operator==(const ValueRange&) const = default;
};

/// Properties of a scene as a whole.
struct SceneSummary {
    Box3 bounds;    // see boundsOf()
    Box3 now;       // the same without the previous poses
    Box3 selected;  // of the selected bodies
    bool hasTransparent = false;
    /// The bounds of what is drawn at a fraction of the step: pictures of the end of a step are the same, whether the
    /// step before is known, as in play, or not, as after a seek.
    const Box3& boundsAt(double stepFraction) const { return stepFraction < 1.0 ? bounds : now; }
    bool operator==(const SceneSummary&) const = default;
};

/// Everything that is drawn, as a value, without the camera. Geometry is large and shared between scenes; the rest is a
/// few numbers per body, so that moving, colouring, selecting and exploding bodies is cheap.
struct RenderScene {
    Vec3 origin{0.0, 0.0, 0.0};  // m, in the world: poses are relative to it, so that floats stay precise far from zero
    std::vector<SceneBatch> batches;
    std::vector<RenderPose> poses;  // this and the following three: one per body
    std::vector<BodyAppearance> appearances;
    std::vector<PickId> picks;
    std::vector<RenderPose> previousPoses;  // one step earlier; empty if nothing moves
    std::vector<glm::vec4> explodeOffsets;  // m, one per body at an explode factor of 1; empty if nothing is exploded
    double explodeFactor = 0.0;             // scales `explodeOffsets`
    // m, one per body: the origin of its frame in that of its asset, which finishes are fixed to. Null: all are 0.
    std::shared_ptr<const std::vector<glm::vec4>> restOffsets;
    bool isOutdoors = false;  // draws a sky, a horizon and a scale bar, as in play
    bool hasGround = true;
    double groundHeight = 0.0;              // m
    std::optional<ValueRange> colourRange;  // of the quantity that bodies are coloured by, if any
    double largestBondArea = 0.0;           // m², of the widest bond line; 0: there are no bond lines
    std::vector<SceneLine> lines;
    std::vector<SceneLine> boxes;  // axis-aligned, from one corner to the opposite one
    std::vector<Particle> particles;
    std::vector<Chip> chips;
    std::vector<Decal> decals;
    std::vector<SurfaceMark> surfaceMarks;  // by ascending body
    std::optional<SceneSummary> summary;    // cached; see summaryOf()
    bool operator==(const RenderScene&) const = default;
};

/// Whether the picture depends on the fraction of the step that led to the scene.
bool isMoving(const RenderScene& scene);

/// The pose of a body at a fraction in [0, 1] of the step that led to the scene: 0 before it, 1 after it.
RenderPose poseAt(const RenderScene& scene, std::uint32_t body, double stepFraction);

/// The displacement of a body in the exploded view, m.
Vec3 explodeOffset(const RenderScene& scene, std::uint32_t body);

/// Replaces the marks of all bodies: a body is hidden, selected or hovered if an id of that list matches it. The
/// selected bodies of an instance share an outline, so that there is none between neighbours.
struct SceneMarks {
    std::vector<PickId> hidden;
    std::vector<PickId> selected;
    std::vector<PickId> hovered;
};
void setMarks(RenderScene& scene, const SceneMarks& marks);

/// Whether a visible body has a transparent surface.
bool hasTransparentSurface(const RenderScene& scene);

/// The bounding box, in the world, of all visible bodies as exploded, at their current and previous poses. `marks`: if
/// not 0, only of bodies with one of these marks. Empty (min > max) if there are none.
Box3 boundsOf(const RenderScene& scene, std::uint32_t marks = 0);
/// The same, with the bodies at the given poses.
Box3 boundsAt(const RenderScene& scene, std::span<const RenderPose> poses, std::uint32_t marks = 0);

/// The bounding box of one body, in the world, as exploded, at its current and previous poses; empty if it is hidden.
/// Linear in instances.
Box3 boundsOfBody(const RenderScene& scene, std::uint32_t body);

/// The cached summary; computed in time linear in bodies if there is none.
SceneSummary summaryOf(const RenderScene& scene);

}  // namespace rubble
