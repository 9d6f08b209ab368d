// Exports assets with baked finishes and draws them: BakedPictures FOLDER. Below it are the packs, and in "pictures"
// for beside.mjs our picture of each asset, with opacities, and camera, light and the places of bodies as JSON. sky.bin
// is the radiance of the sky: rows of 4 floats from the top.
#include "core/asset/bake/AssetBakes.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/json/VectorJson.h"
#include "core/io/pack/PackExport.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/asset/MeshAsset.h"
#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/render/light/SkyLight.h"
#include "viewport/scene/SceneBuilder.h"

#include <cstdio>
#include <numbers>

using namespace rubble;
namespace fs = std::filesystem;

namespace {

constexpr ImageSize kPicture{480, 360};
constexpr int kSkyWidth = 512, kSkyHeight = 256;

/// Of a wall of bricks, a block, a board and a stone.
Project bakedProject() {
    Project project;
    const auto material = [&](const char* name, Finish finish, Colour outside, Colour inside) {
        return test::addMaterial(project, {.name = name, .outside = outside, .inside = inside, .finish = finish});
    };
    const Id brick = material("brick", Finish::Brick, {0.60, 0.32, 0.25}, {0.64, 0.37, 0.29});
    const Id concrete = material("concrete", Finish::Concrete, {0.66, 0.65, 0.62}, {0.56, 0.54, 0.51});
    const Id wood = material("wood", Finish::Wood, {0.62, 0.45, 0.29}, {0.70, 0.54, 0.36});
    const Id stone = material("stone", Finish::Stone, {0.58, 0.57, 0.53}, {0.62, 0.60, 0.56});
    const auto prism = [](Vec2 size, double depth) { return Prism{{rectangle(-0.5 * size, 0.5 * size), {}}, depth}; };
    test::addAsset(project, {.name = "wall", .material = brick, .shape = prism({1.5, 1.0}, 0.115)},
                   {BrickBond{.mortar = 0.0, .origin = {-0.75, -0.5}}});
    test::addAsset(project, {.name = "block", .material = concrete, .shape = prism({1.0, 0.8}, 0.4)},
                   {UniformScatter{.count = 8}});
    test::addAsset(project, {.name = "board", .material = wood, .shape = prism({1.2, 0.2}, 0.04)},
                   {UniformScatter{.count = 4}});
    const Asset sculpture = test::meshAsset(test::bumpySphere(24), 6);
    test::addAsset(project, {.name = "stone", .material = stone, .shape = sculpture.shape},
                   {UniformScatter{.count = 6}});
    return project;
}

bool written(const fs::path& path, std::string_view bytes) {
    const Status status = writeFileAtomically(path, bytes);
    if (!status) std::fprintf(stderr, "%s\n", status.error().message.c_str());
    return status.hasValue();
}

/// As skyLightOf() has it.
std::string skyBytes(const SkyLight& light) {
    std::vector<float> values;
    for (int row = 0; row < kSkyHeight; ++row) {
        const double polar = std::numbers::pi * (row + 0.5) / kSkyHeight;
        for (int column = 0; column < kSkyWidth; ++column) {
            // As three.js reads such images: the middle is towards +x.
            const double turn = 2.0 * std::numbers::pi * ((column + 0.5) / kSkyWidth - 0.5);
            const Vec3 direction(std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn));
            const Vec3 radiance = direction.y > 0.0 ? skyRadiance(light.sky, direction) : light.ground;
            for (int part = 0; part < 3; ++part) values.push_back(static_cast<float>(radiance[part]));
            values.push_back(1.0f);
        }
    }
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

std::string sceneJson(const RenderScene& scene, const RenderView& view, const Sky& sky) {
    JsonWriter json(JsonLayout::Compact, 4096);
    json.openObject();
    json.numbers("size", {double(view.size.width), double(view.size.height)});
    json.number("fieldOfView", view.camera.fieldOfView);
    writeVector(json, "eye", eyeOf(view.camera));
    writeVector(json, "target", view.camera.target);
    writeVector(json, "towardsSun", sky.sunDirection);
    writeVector(json, "sunLight", sky.sunLight);
    json.numbers("skySize", {double(kSkyWidth), double(kSkyHeight)});
    json.openArray("bodies");
    for (std::uint32_t body = 0; body < scene.poses.size(); ++body)
        writeVector(json, {}, scene.origin + Vec3(scene.poses[body].position) + explodeOffset(scene, body));
    json.close();
    json.close();
    return std::move(json).contents();
}

/// The picture of an asset whose fragments are apart, from above and beside it.
bool drawn(OffscreenRenderer& renderer, const Project& project, const AssetBakes& bakes, const Asset& asset,
           const fs::path& folder) {
    const SceneOptions options{.asset = asset.id, .explodeFactor = 0.25};
    const auto scene = std::make_shared<RenderScene>(sceneOf(project, bakes, options));
    RenderView view{.size = kPicture};
    view.camera.azimuth = 0.5;
    view.camera.elevation = 0.35;
    view.camera = framing(view.camera, boundsOf(*scene), kPicture);
    view.settings.hasEdges = view.settings.hasShadows = view.settings.hasOverlays = view.settings.hasGrid = false;
    view.minFragmentPixels = 0.0;
    const Result<Image> image = renderer.renderCutOut(scene, view, 0);
    if (!image) return std::fprintf(stderr, "%s\n", image.error().message.c_str()), false;
    return written(folder / (asset.name + "-ours.png"), pngOf(*image).value()) &&
           written(folder / (asset.name + ".json"),
                   sceneJson(*scene, view, skyOf(view.settings.sky, view.settings.theme)));
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return std::fprintf(stderr, "usage: BakedPictures FOLDER\n"), 2;
    const fs::path folder = arguments[1];
    const Project project = bakedProject();
    PackOptions options{.files = PackFiles::Json};
    options.meshes.formats = {"glb"};
    options.meshes.textures = SurfaceTextures::Baked;
    std::vector<Id> ids;
    for (const Asset& asset : project.assets) ids.push_back(asset.id);
    const auto exports = exportPacks(project, ids, folder, options, EditedFiles::Replaced);
    if (!exports) return std::fprintf(stderr, "%s\n", exports.error().message.c_str()), 1;
    for (const AssetExport& each : *exports) {
        if (!each.status) return std::fprintf(stderr, "%s\n", each.status.error().message.c_str()), 1;
    }
    Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return std::fprintf(stderr, "%s\n", renderer.error().message.c_str()), 77;
    const AssetBakes bakes = bakesOf(project).value();
    const fs::path pictures = folder / "pictures";
    fs::create_directories(pictures);
    for (const Asset& asset : project.assets) {
        if (!drawn(*renderer, project, bakes, asset, pictures)) return 1;
    }
    const Sky sky = skyOf(RenderSettings{}.sky, RenderSettings{}.theme);
    return written(pictures / "sky.bin", skyBytes(skyLightOf(sky))) ? 0 : 1;
}
