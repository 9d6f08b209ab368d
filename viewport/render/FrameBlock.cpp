#include "viewport/render/FrameBlock.h"

#include "core/asset/project/FragmentColours.h"
#include "viewport/render/LightBuffer.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kFineStep = 0.3;     // the fine step is the largest power of ten below this times the distance
constexpr double kGroundBias = 2e-4;  // of the distance, by which the ground is lowered against z-fighting

glm::vec4 direction(Vec3 v, float w) { return glm::vec4(glm::vec3(v), w); }

/// The grid's fine step and its opacity: it fades out before the next coarser step replaces it.
glm::vec2 gridStep(const Camera& camera) {
    const double power = std::log10(kFineStep * camera.distance);
    const double whole = std::floor(power);
    return glm::vec2(std::pow(10.0, whole), 1.0 - 0.8 * (power - whole));
}

/// The scene's origin modulo the grid's coarse step, so that the grid stays precise far from zero.
glm::vec4 gridOrigin(double fineStep, const RenderScene& scene) {
    const double step = 10.0 * fineStep;
    return direction(scene.origin - step * glm::floor(scene.origin / step), 0.0f);
}

void setLight(FrameBlock& frame, const Environment& environment, const LightSample& sample, bool hasTransparent) {
    frame.keyDirection = direction(sample.keyDirection, static_cast<float>(sample.keyRadius));
    frame.keyLight = glm::vec4(environment.keyLight, hasTransparent ? 1.0f : 0.0f);
    frame.skyLight = glm::vec4(environment.skyLight, environment.headlight);
    frame.bounceLight = glm::vec4(environment.bounceLight, 0.0f);
}

void setSurroundings(FrameBlock& frame, const Environment& environment, const Camera& camera) {
    frame.backgroundTop = environment.backgroundTop;
    frame.backgroundBottom = environment.backgroundBottom;
    frame.grid = environment.grid;
    frame.zenith = glm::vec4(environment.zenith, camera.projection == Projection::Perspective ? 1.0f : 0.0f);
    frame.horizon = glm::vec4(environment.horizon, 1.0f);
    frame.soil = glm::vec4(environment.soil, 1.0f);
}

void setPlainBackground(FrameBlock& frame, const Colour& colour) {
    frame.backgroundTop = frame.backgroundBottom = glm::vec4(colour.red, colour.green, colour.blue, 1.0);
    frame.zenith.w = 0.0f;
    frame.spacing.z = 0.0f;
}

void setCamera(FrameBlock& frame, const RenderView& view, const RenderScene& scene, const Box3& bounds, Vec2 offset) {
    const Camera& camera = view.camera;
    const CameraMatrices matrices = matricesOf(camera, view.size, scene.origin, bounds);
    const Vec3 moved(2.0 * offset.x / view.size.width, 2.0 * offset.y / view.size.height, 0.0);
    const bool isPerspective = camera.projection == Projection::Perspective;
    frame.clipFromScene = glm::mat4(glm::translate(glm::dmat4(1.0), moved) * matrices.projection * matrices.view);
    frame.eye = direction(eyeOf(camera) - scene.origin, isPerspective ? 1.0f : 0.0f);
    frame.back = direction(axesOf(camera).back, 0.0f);
    const double halfHeight = metresPerPixel(camera, {2, 2}) / (isPerspective ? camera.distance : 1.0);
    frame.right = direction(axesOf(camera).right, static_cast<float>(halfHeight * view.size.aspect()));
    frame.up = direction(axesOf(camera).up, static_cast<float>(halfHeight));
    frame.depth = glm::vec4(matrices.projection[2][2], matrices.projection[3][2], 0.0, 0.0);
    frame.viewport = {view.size.width, view.size.height, view.size.height / (2.0 * halfHeight), view.settings.scale};
}

}  // namespace

FrameBlock frameBlock(const RenderView& view, const RenderScene& scene, const SceneSummary& summary,
                      const LightSample& sample) {
    const Camera& camera = view.camera;
    const RenderSettings& settings = view.settings;
    const Environment environment = environmentOf(settings.theme);
    FrameBlock frame{};
    setCamera(frame, view, scene, summary.bounds, sample.pixelOffset);
    setLight(frame, environment, sample, summary.hasTransparent);
    setSurroundings(frame, environment, camera);
    frame.depth.w = environment.dustLight;
    const double below = scene.groundHeight - kGroundBias * camera.distance;
    const double gridRadius =
        std::max(4.0 * camera.distance, summary.bounds.isEmpty() ? 0.0 : summary.bounds.diagonal());
    frame.ground =
        direction(Vec3(camera.target.x, below, camera.target.z) - scene.origin, static_cast<float>(gridRadius));
    const glm::vec2 step = gridStep(camera);
    frame.spacing = glm::vec4(step, scene.hasGround ? 1.0f : 0.0f, settings.hasGrid ? 1.0f : 0.0f);
    frame.gridOrigin = gridOrigin(static_cast<double>(step.x), scene);
    if (settings.background) setPlainBackground(frame, *settings.background);
    const std::uint32_t accent = packed(settings.accent);
    frame.accent = glm::vec4(accent >> 16, accent >> 8 & 255, accent & 255, 255) / 255.0f;
    frame.edges = {static_cast<float>(settings.scale), settings.hasEdges ? 0.85f : 0.0f,
                   scene.explodeOffsets.empty() ? 0.0f : static_cast<float>(scene.explodeFactor),
                   scene.previousPoses.empty() ? 1.0f : static_cast<float>(view.stepFraction)};
    frame.jitter = {sample.pixelOffset, sample.patternPhase, static_cast<float>(LightBuffer::kPixels)};
    return frame;
}

}  // namespace rubble
