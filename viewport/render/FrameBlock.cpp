#include "viewport/render/FrameBlock.h"

#include "core/asset/project/FragmentColours.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr float kKeyLight = 0.82f, kEyeLight = 0.1f;
constexpr float kEdgeWidth = 0.85f;    // points, on each side of an edge
constexpr double kLowestLight = 0.05;  // least y of a unit direction towards a light
constexpr double kFineStep = 0.3;      // the fine step is the largest power of ten below this times the distance
constexpr double kGroundBias = 2e-4;   // of the distance, by which the ground is lowered against z-fighting

glm::vec4 direction(Vec3 v, float w) { return glm::vec4(glm::vec3(v), w); }

/// Extends `part` (x and z, in the world) by the ground that the shadow of a box's bounding sphere can reach.
/// Directions are clamped to kLowestLight: lower light hardly brightens the ground, so that its far shadows may be cut
/// off.
void includeShadow(Box2& part, const Box3& bounds, double height, Vec3 towardsLight) {
    const double radius = 0.5 * bounds.diagonal(), rise = std::max(towardsLight.y, kLowestLight);
    const Vec3 centre = bounds.centre();
    for (const double above : {std::max(0.0, centre.y - radius - height), centre.y + radius - height}) {
        const Vec3 foot = centre - (above / rise) * towardsLight;
        part.include({foot.x - radius, foot.z - radius});
        part.include({foot.x + radius, foot.z + radius});
    }
}

/// The grid's fine step and its opacity: it fades out before the next coarser step replaces it.
glm::vec2 gridStep(const Camera& camera) {
    const double power = std::log10(kFineStep * camera.distance);
    const double whole = std::floor(power);
    return glm::vec2(std::pow(10.0, whole), 1.0 - 0.8 * (power - whole));
}

}  // namespace

FrameBlock frameBlock(const RenderView& view, const RenderScene& scene, const Box3& bounds,
                      const std::optional<LightSample>& sample) {
    const Camera& camera = view.camera;
    const RenderSettings& settings = view.settings;
    const Environment environment = environmentOf(settings.theme);
    const CameraMatrices matrices = matricesOf(camera, view.size, scene.origin, bounds);
    const Vec2 offset = sample ? sample->pixelOffset : Vec2(0.0);
    const Vec3 moved(2.0 * offset.x / view.size.width, 2.0 * offset.y / view.size.height, 0.0);
    const auto scale = static_cast<float>(settings.scale);

    FrameBlock frame{};
    frame.clipFromScene = glm::mat4(glm::translate(glm::dmat4(1.0), moved) * matrices.projection * matrices.view);
    frame.eye = direction(eyeOf(camera) - scene.origin, camera.projection == Projection::Perspective ? 1.0f : 0.0f);
    frame.back = direction(axesOf(camera).back, 0.0f);
    frame.keyDirection = direction(sample ? sample->keyDirection : keyDirection(), kKeyLight);
    frame.skyDirection = sample ? direction(sample->skyDirection, 0.0f) : glm::vec4(0.0f);
    frame.skyLight = {0.42f, 0.44f, 0.48f, kEyeLight};
    frame.groundLight = {0.17f, 0.16f, 0.15f, 0.0f};
    frame.backgroundTop = environment.backgroundTop;
    frame.backgroundBottom = environment.backgroundBottom;
    frame.grid = environment.grid;
    const double below = scene.groundHeight - kGroundBias * camera.distance;
    const double gridRadius = std::max(4.0 * camera.distance, bounds.diagonal());
    frame.ground =
        direction(Vec3(camera.target.x, below, camera.target.z) - scene.origin, static_cast<float>(gridRadius));
    if (!bounds.isEmpty()) {
        Box2 shaded;
        includeShadow(shaded, bounds, below, keyDirection());
        if (sample) includeShadow(shaded, bounds, below, sample->skyDirection);
        const Vec2 origin(scene.origin.x, scene.origin.z);
        frame.shaded = glm::vec4(glm::dvec4(shaded.min - origin, shaded.max - origin));
    }
    frame.spacing = glm::vec4(gridStep(camera), environment.shadowStrength, 0.0f);
    const std::uint32_t accent = packed(settings.accent);
    frame.accent = glm::vec4(accent >> 16, accent >> 8 & 255, accent & 255, 255) / 255.0f;
    frame.edges = {kEdgeWidth * scale, settings.hasEdges ? 0.85f : 0.0f,
                   scene.explodeOffsets.empty() ? 0.0f : static_cast<float>(scene.explodeFactor),
                   scene.previousPoses.empty() ? 1.0f : static_cast<float>(view.stepFraction)};
    const double halfHeight = metresPerPixel(camera, {2, 2}) / camera.distance;
    frame.right = direction(axesOf(camera).right, static_cast<float>(halfHeight * view.size.aspect()));
    frame.up = direction(axesOf(camera).up, static_cast<float>(halfHeight));
    frame.depth = glm::vec4(matrices.projection[2][2], matrices.projection[3][2], 0.0, environment.dustLight);
    const bool hasSky = scene.isOutdoors && camera.projection == Projection::Perspective;
    frame.zenith = glm::vec4(environment.zenith, hasSky ? 1.0f : 0.0f);
    frame.horizon = glm::vec4(environment.horizon, 1.0f);
    frame.soil = glm::vec4(environment.soil, 1.0f);
    frame.hovered.x = view.hovered ? *view.hovered + 1 : 0;
    frame.viewport = {view.size.width, view.size.height, 0.0f, scale};
    return frame;
}

glm::vec3 gridOrigin(const FrameBlock& frame, const RenderScene& scene) {
    const double step = 10.0 * static_cast<double>(frame.spacing.x);
    return glm::vec3(scene.origin - step * glm::floor(scene.origin / step));
}

}  // namespace rubble
