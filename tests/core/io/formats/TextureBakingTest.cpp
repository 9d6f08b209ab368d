#include "core/io/formats/TextureBaking.h"

#include "core/io/pack/PackMeshes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/GlbReading.h"
#include "tests/support/files/TestImages.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

const Material kFinishedStone{.id = 1, .name = "stone", .outside = {0.5, 0.4, 0.3}, .finish = Finish::Stone};
const Material kPlainStone{.id = 1, .name = "plain"};
const MeshOptions kBakedTextures{
    .formats = {"glb"}, .textures = SurfaceTextures::Baked, .textureSize = TextureSize::Texels512};

MeshOptions bakedAs(const FormatSet& formats, FileSplit split = FileSplit::Single, GlbKind kind = GlbKind::Plain) {
    MeshOptions options = kBakedTextures;
    options.formats = formats;
    options.split = split;
    options.glbKind = kind;
    return options;
}

Asset bakedBox() { return boxAsset(2, 3, UniformScatter{.count = 4}); }

std::vector<ExportFile> bakedFiles(const Asset& asset, const AssetMaterials& materials, const MeshOptions& options) {
    const Bake baked = bake(asset).value();
    return packMeshes(PackBuilder({baked, asset, materials, packNames(asset), {}}), options).value().files;
}

std::string bakedBytes(const std::vector<ExportFile>& files, const std::string& name) {
    const auto found = std::ranges::find(files, name, &ExportFile::name);
    return found == files.end() ? std::string() : found->bytes;
}

Glb bakedGlb(const std::vector<ExportFile>& files, const std::string& name) {
    Glb glb;
    const std::string fault = openGlb(bakedBytes(files, name), glb);
    if (!fault.empty()) qWarning("%s", fault.c_str());
    return glb;
}

using BakedSides = std::array<bool, 2>;
BakedSides bakedSidesOf(const Asset& asset, const AssetMaterials& materials, const MeshOptions& options) {
    const TexturedSides sides = bakedSides(asset, materials, options);
    return {sides.outside, sides.inside};
}

}  // namespace

class TextureBakingTest : public QObject {
    Q_OBJECT
private slots:
    void opaqueSidesWithAFinishAreBaked() {
        const Material glass{.id = 1, .name = "glass", .opacity = 0.3, .finish = Finish::Glass};
        QCOMPARE(bakedSidesOf(bakedBox(), kFinishedStone, kBakedTextures), (BakedSides{true, true}));
        QCOMPARE(bakedSidesOf(bakedBox(), {kPlainStone, kFinishedStone}, kBakedTextures), (BakedSides{false, true}));
        QCOMPARE(bakedSidesOf(bakedBox(), {kFinishedStone, glass}, kBakedTextures), (BakedSides{true, false}));
        QCOMPARE(bakedSidesOf(bakedBox(), kPlainStone, kBakedTextures), (BakedSides{false, false}));
        Asset imported = bakedBox();
        imported.texture = Texture{};
        QCOMPARE(bakedSidesOf(imported, kFinishedStone, kBakedTextures), (BakedSides{false, true}));
        MeshOptions none = kBakedTextures;
        none.textures = SurfaceTextures::None;
        QCOMPARE(bakedSidesOf(bakedBox(), kFinishedStone, none), (BakedSides{false, false}));
    }
    void onlySomeFormatsAreBaked() {
        const auto isBaked = [](const MeshOptions& options) {
            return bakedSidesOf(bakedBox(), kFinishedStone, options)[0];
        };
        QVERIFY(isBaked(bakedAs({"usd"})));
        QVERIFY(isBaked(bakedAs({"glb"}, FileSplit::Single, GlbKind::Physics)));
        QVERIFY(!isBaked(bakedAs({"glb"}, FileSplit::Single, GlbKind::Compact)));
        QVERIFY(!isBaked(bakedAs({"obj", "mjcf", "csv"})));
        QVERIFY(bakingBytes(bakedAs({"usd"})) > 1e6);
        QCOMPARE(bakingBytes(bakedAs({"obj"})), 0.0);
    }
    /// All fragments of a file have the images of one set of materials.
    void glbFilesContainTheImages() {
        const std::vector<ExportFile> files = bakedFiles(bakedBox(), kFinishedStone, kBakedTextures);
        for (const char* name : {"box-intact.glb", "box-fragments.glb"}) {
            const Glb glb = bakedGlb(files, name);
            QCOMPARE(glb.json["images"].size(), std::size_t{3});
            QVERIFY(glb.json["images"][1]["name"] == "box-normal.png");
            QCOMPARE(glb.json["materials"].size(), std::size_t{2});
            for (const nlohmann::json& material : glb.json["materials"]) {
                const nlohmann::json& rough = material["pbrMetallicRoughness"];
                QVERIFY(rough["baseColorTexture"]["index"] == 0 && material["normalTexture"]["index"] == 1);
                QVERIFY(rough["metallicRoughnessTexture"]["index"] == 2);
                QVERIFY(!rough.contains("baseColorFactor") && !rough.contains("metallicFactor"));
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const nlohmann::json& view =
                    glb.json["bufferViews"][glb.json["images"][k]["bufferView"].get<std::size_t>()];
                const std::string bytes(glb.binary.substr(view["byteOffset"], view["byteLength"]));
                const Result<EncodedImage> image = EncodedImage::of(bytes);
                QVERIFY(image);
                QCOMPARE(image->width(), 512u);
                QCOMPARE(image->height(), 512u);
            }
        }
        QVERIFY(bakedBytes(files, "box-colour.png").empty());
    }
    void tangentsAreUnitVectorsAcrossNormals() {
        const Glb glb = bakedGlb(bakedFiles(bakedBox(), kFinishedStone, kBakedTextures), "box-fragments.glb");
        for (const nlohmann::json& mesh : glb.json["meshes"]) {
            for (const nlohmann::json& primitive : mesh["primitives"]) {
                const nlohmann::json& attributes = primitive["attributes"];
                const auto values = [&](const char* name) {
                    return numbersOf<float>(glb, glb.json["accessors"][attributes[name].get<std::size_t>()]);
                };
                const std::vector<float> normals = values("NORMAL"), tangents = values("TANGENT"),
                                         uvs = values("TEXCOORD_0");
                QCOMPARE(tangents.size() / 4, normals.size() / 3);
                for (std::size_t k = 0; k < normals.size() / 3; ++k) {
                    const Vec3 normal(normals[3 * k], normals[3 * k + 1], normals[3 * k + 2]);
                    const Vec3 tangent(tangents[4 * k], tangents[4 * k + 1], tangents[4 * k + 2]);
                    QVERIFY(std::abs(glm::length(tangent) - 1.0) < 1e-6 && std::abs(glm::dot(normal, tangent)) < 1e-6);
                    QCOMPARE(tangents[4 * k + 3], 1.0f);
                    QVERIFY(uvs[2 * k] > 0.0f && uvs[2 * k] < 1.0f && uvs[2 * k + 1] > 0.0f && uvs[2 * k + 1] < 1.0f);
                }
            }
        }
    }
    void filesOfOneFragmentShareImagesBesideThem() {
        const MeshOptions options = bakedAs({"glb"}, FileSplit::PerFragment);
        const std::vector<ExportFile> files = bakedFiles(bakedBox(), kFinishedStone, options);
        const Glb glb = bakedGlb(files, "box_f3_0.glb");
        QVERIFY(glb.json["images"][0]["uri"] == "box-colour.png" && !glb.json["images"][0].contains("bufferView"));
        for (const char* name : {"box-colour.png", "box-normal.png", "box-surface.png"})
            QVERIFY(EncodedImage::of(bakedBytes(files, name)));
    }
    void usdFilesReferToTheImages() {
        const std::vector<ExportFile> files = bakedFiles(bakedBox(), kFinishedStone, bakedAs({"usd", "obj"}));
        const std::string layer = bakedBytes(files, "box.usda");
        for (const char* text :
             {"asset inputs:file = @./box-colour.png@", "asset inputs:file = @./box-normal.png@",
              "float4 inputs:scale = (2, 2, 2, 1)", "float4 inputs:bias = (-1, -1, -1, 0)",
              "/RoughnessMetalness.outputs:g>", "/RoughnessMetalness.outputs:b>", "/Colour.outputs:rgb>",
              "token inputs:sourceColorSpace = \"raw\"", "token inputs:sourceColorSpace = \"sRGB\""})
            QVERIFY2(layer.find(text) != std::string::npos, text);
        QVERIFY(EncodedImage::of(bakedBytes(files, "box-surface.png")));
        const std::vector<ExportFile> plain = bakedFiles(bakedBox(), kPlainStone, bakedAs({"usd", "obj"}));
        QVERIFY(bakedBytes(plain, "box.usda").find("Texture") == std::string::npos);
        // Files of other formats are as ever.
        QVERIFY(bakedBytes(plain, "box-fragments.obj") ==
                bakedBytes(bakedFiles(bakedBox(), kPlainStone, {.formats = {"obj"}}), "box-fragments.obj"));
    }
    /// An image that was imported stays on the outside, and baked ones are on the inside.
    void importedImagesStay() {
        Asset asset = bakedBox();
        asset.texture = Texture{
            .name = "own.png", .image = std::make_shared<const EncodedImage>(imageOf(checkerPng())), .materials = {0}};
        const std::vector<ExportFile> files = bakedFiles(asset, kFinishedStone, kBakedTextures),
                                      before = bakedFiles(asset, kFinishedStone, {.formats = {"glb"}});
        const Glb glb = bakedGlb(files, "box-fragments.glb"), old = bakedGlb(before, "box-fragments.glb");
        QCOMPARE(glb.json["images"].size(), std::size_t{4});
        QVERIFY(glb.json["materials"][0] == old.json["materials"][0]);
        QVERIFY(glb.json["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 1);
        // Tangents are those of baked images.
        for (const nlohmann::json& mesh : glb.json["meshes"]) {
            for (const nlohmann::json& primitive : mesh["primitives"])
                QCOMPARE(primitive["attributes"].contains("TANGENT"), primitive["material"] == 1);
        }
        QVERIFY(numbersOf<float>(glb, glb.json["accessors"][2]) == numbersOf<float>(old, old.json["accessors"][2]));
    }
    void fragmentsThatDoNotFitAreRefused() {
        const Asset asset = boxAsset(2, 3, UniformScatter{.count = 4000});
        const Bake baked = bake(asset).value();
        const PackInput pack{baked, asset, kFinishedStone, packNames(asset), {}};
        const Result<PackMeshes> meshes = packMeshes(PackBuilder(pack), kBakedTextures);
        QVERIFY(!meshes);
        QVERIFY(meshes.error().code == ErrorCode::Limit);
        QVERIFY(meshes.error().message.ends_with(
            " faces do not fit into a texture of 512 × 512 texels. Choose larger textures, or none."));
    }
    void bakingIsCancelled() {
        const Asset asset = bakedBox();
        const Bake baked = bake(asset).value();
        TaskContext task;
        task.cancel.cancel();
        const PackInput pack{baked, asset, kFinishedStone, packNames(asset), {}};
        QVERIFY(packMeshes(PackBuilder(pack), kBakedTextures, task).error().code == ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(TextureBakingTest)
#include "TextureBakingTest.moc"
