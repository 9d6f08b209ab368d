#include "viewport/scene/MaterialSample.h"

#include "core/asset/bake/Bake.h"
#include "viewport/scene/SceneBuilder.h"

namespace rubble {
namespace {

constexpr double kSide = 0.5;   // m
constexpr double kLost = 0.08;  // m, of centres of fragments above the diagonal
constexpr std::uint32_t kFragments = 12;
constexpr std::uint64_t kSampleSeed = 5;  // a corner that shows much of the inside

Project sampleProject(const Material& material) {
    constexpr double kHalf = 0.5 * kSide;
    Project project;
    project.materials = {material};
    project.materials[0].id = project.nextId++;
    Asset block{.id = project.nextId++, .name = "block", .material = project.materials[0].id};
    block.prism() = {{{{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}}, {}}, kSide};
    block.pattern.layers = {
        {.id = project.nextId++, .randomSeed = kSampleSeed, .parameters = UniformScatter{.count = kFragments}}};
    project.assets = {block};
    return project;
}

}  // namespace

std::shared_ptr<const RenderScene> materialSample(const Material& material) {
    const Project project = sampleProject(material);
    const Result<Bake> baked = bake(project.assets[0]);
    AssetBakes bakes;
    if (baked) bakes[{project.assets[0].id}] = std::make_shared<const Bake>(*baked);
    RenderScene scene = sceneOf(project, bakes, {.asset = project.assets[0].id});
    const Vec3 middle = boundsOf(scene).centre();
    for (std::uint32_t body = 0; body < scene.poses.size(); ++body) {
        const Vec3 centre = boundsOfBody(scene, body).centre() - middle;
        if (centre.x + centre.y > kLost) scene.appearances[body].marks |= kHidden;
    }
    scene.summary.reset();
    return std::make_shared<const RenderScene>(std::move(scene));
}

Camera sampleCamera(const RenderScene& sample, ImageSize size) {
    constexpr double kAzimuth = 0.55, kElevation = 0.5;  // rad, from the front
    return framing(orbited(alignedTo({}, StandardView::Front), kAzimuth, kElevation), boundsOf(sample), size);
}

}  // namespace rubble
