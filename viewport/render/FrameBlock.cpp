#include "viewport/render/FrameBlock.h"

#include "core/asset/project/FragmentColours.h"
#include "core/base/math/Power.h"
#include "viewport/render/LightBuffer.h"
#include "viewport/render/light/ToneMapping.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble {
namespace {

constexpr double kFineStep = 0.3;           // the fine step is the largest power of ten below this times the distance
constexpr double kConcretePeriod = 6553.6;  // m: of the noises of ground.frag
constexpr double kGroundBias = 2e-4;        // of the distance, by which the ground is lowered against z-fighting

glm::vec4 direction(Vec3 v, float w) { return glm::vec4(glm::vec3(v), w); }

/// The grid's fine step and its opacity: it fades out before the next coarser step replaces it.
glm::vec2 gridStep(const Camera& camera) {
    const double power = std::log10(kFineStep * camera.distance);
    const double whole = std::floor(power);
    return glm::vec2(std::pow(10.0, whole), 1.0 - 0.8 * (power - whole));
}

/// The scene's origin modulo the grid's coarse step (x, z), so that the grid stays precise far from zero, and modulo
/// the period of the ground's texture (y, w).
glm::vec4 gridOrigin(double fineStep, const RenderScene& scene) {
    const double step = 10.0 * fineStep;
    const auto remainder = [&](double period) { return scene.origin - period * glm::floor(scene.origin / period); };
    const Vec3 ofGrid = remainder(step), ofConcrete = remainder(kConcretePeriod);
    return glm::vec4(ofGrid.x, ofConcrete.x, ofGrid.z, ofConcrete.z);
}

/// The factors of 1, y, z and so on in SphericalHarmonics in the order of sky_light.glsl.
void setDiffuseLight(FrameBlock& frame, const SphericalHarmonics& light) {
    const std::array<Vec3, 9>& c = light.coefficients;
    for (int channel = 0; channel < 3; ++channel) {
        frame.skyLight[channel] = glm::vec4(c[3][channel], c[1][channel], c[2][channel], c[0][channel] - c[6][channel]);
        frame.skyLight[3 + channel] = glm::vec4(c[4][channel], c[5][channel], 3.0 * c[6][channel], c[7][channel]);
    }
    frame.skyLight[6] = direction(c[8], 0.0f);
}

float exposureFactor(double stops) { return static_cast<float>(power(2.0, stops)); }

/// The sRGB colour of a radiance, as in frame.glsl.
glm::vec4 displayed(Vec3 radiance, float exposure) {
    return direction(srgbOf(toneMapped(static_cast<double>(exposure) * radiance)), 1.0f);
}

void setLight(FrameBlock& frame, const SkyLight& light, double exposure, const LightSample& sample,
              bool hasTransparent) {
    frame.keyDirection = direction(sample.keyDirection, static_cast<float>(sample.keyRadius));
    frame.keyLight = direction(light.sky.sunLight, hasTransparent ? 1.0f : 0.0f);
    setDiffuseLight(frame, light.diffuse);
    frame.groundLight = direction(light.ground, exposureFactor(exposure));
}

void setSurroundings(FrameBlock& frame, const Environment& environment, float glowSharpness, const Camera& camera) {
    frame.backgroundTop = displayed(environment.backgroundTop, frame.groundLight.w);
    frame.backgroundBottom = displayed(environment.backgroundBottom, frame.groundLight.w);
    frame.grid = environment.grid;
    frame.zenith = direction(environment.zenith, camera.projection == Projection::Perspective ? 1.0f : 0.0f);
    frame.horizon = direction(environment.horizon, glowSharpness);
    frame.glow = direction(environment.glow, 0.0f);
    frame.soil = direction(environment.soil, 1.0f);
    frame.groundKey = direction(environment.groundKey, 0.0f);
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
                      const SkyLight& light, const LightSample& sample) {
    const Camera& camera = view.camera;
    const RenderSettings& settings = view.settings;
    const Environment environment = environmentOf(settings.sky, settings.theme, light);
    const Box3& bounds = summary.boundsAt(view.stepFraction);
    FrameBlock frame{};
    setCamera(frame, view, scene, bounds, sample.pixelOffset);
    setLight(frame, light, settings.exposure, sample, summary.hasTransparent);
    setSurroundings(frame, environment, static_cast<float>(light.sky.glowSharpness), camera);
    const double below = scene.groundHeight - kGroundBias * camera.distance;
    const double gridRadius = std::max(4.0 * camera.distance, bounds.isEmpty() ? 0.0 : bounds.diagonal());
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
