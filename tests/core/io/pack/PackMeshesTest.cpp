#include "core/io/pack/PackMeshes.h"

#include "core/io/formats/ExportFormat.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/files/GlbReading.h"
#include "tests/support/files/ObjReading.h"
#include "tests/support/files/TestImages.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace rubble;

namespace {

const Material kBrick{.id = 1, .name = "brick"};

Asset wallAsset() {
    Asset asset = assetOf(unitSquare(), 0.5);
    asset.name = "wall";
    asset.pattern = scatterOf(2, 4);
    return asset;
}

Result<PackMeshes> meshesOf(const Asset& asset, const MeshOptions& options, const TaskContext& task = {}) {
    const Bake baked = bake(asset).value();
    return packMeshes(PackBuilder({baked, asset, kBrick, packNames(asset), {}}), options, task);
}

std::vector<ExportFile> filesOf(const Asset& asset, const MeshOptions& options) {
    return meshesOf(asset, options).value().files;
}

std::vector<std::string> namesOf(const std::vector<ExportFile>& files) {
    std::vector<std::string> names;
    for (const ExportFile& file : files) names.push_back(file.name);
    return names;
}

std::string bytesNamed(const std::vector<ExportFile>& files, const std::string& name) {
    const auto file = std::ranges::find(files, name, &ExportFile::name);
    return file == files.end() ? std::string() : file->bytes;
}

/// The volume of all objects of a file; NaN if one is not closed and oriented outwards.
double volumeOfObj(const std::string& bytes) {
    double volume = 0.0;
    for (const ObjObject& object : readObj(bytes)) {
        const double own = volumeOf(object.mesh);
        const std::optional<std::string> fault = verifyMesh(object.mesh, own);
        if (fault) qWarning("%s: %s", object.name.c_str(), fault->c_str());
        if (fault || own <= 0.0) return std::nan("");
        volume += own;
    }
    return volume;
}

using Names = std::vector<std::string>;

Asset texturedWall() {
    Asset asset = wallAsset();
    const auto image = std::make_shared<const EncodedImage>(imageOf(checkerPng()));
    asset.texture = Texture{.name = "my wall.png", .image = image, .materials = {0}};
    return asset;
}

/// All selections of formats.
std::vector<MeshOptions> formatOptions() {
    std::vector<MeshOptions> options{{.formats = {}}};
    for (const ExportFormat* format : exportFormats()) {
        for (std::size_t k = 0, count = options.size(); k < count; ++k) {
            options.push_back(options[k]);
            options.back().formats.insert(format->word);
        }
    }
    return options;
}

}  // namespace

class PackMeshesTest : public QObject {
    Q_OBJECT
private slots:
    void singleFileHoldsAllFragments() {
        const std::vector<ExportFile> files = filesOf(wallAsset(), {});
        QCOMPARE(namesOf(files),
                 (Names{"wall-intact.obj", "wall-intact.glb", "wall-fragments.obj", "wall-fragments.glb", "wall.mtl"}));
        const std::vector<ObjObject> objects = readObj(bytesNamed(files, "wall-fragments.obj"));
        QCOMPARE(objects.size(), std::size_t{2});
        QCOMPARE(objects[1].name, std::string("wall_f4_1"));
        QVERIFY(bytesNamed(files, "wall-fragments.obj").find("\nmtllib wall.mtl\n") != std::string::npos);
    }
    void perFragmentFilesHoldOneFragmentEach() {
        const MeshOptions options{.formats = {"obj"}, .split = FileSplit::PerFragment};
        const std::vector<ExportFile> files = filesOf(wallAsset(), options);
        QCOMPARE(namesOf(files), (Names{"wall-intact.obj", "wall_f4_0.obj", "wall_f4_1.obj", "wall.mtl"}));
        QCOMPARE(readObj(bytesNamed(files, "wall_f4_1.obj"))[0].name, std::string("wall_f4_1"));
    }
    void withoutFormatsThereAreNoFiles() { QVERIFY(filesOf(wallAsset(), {.formats = {}}).empty()); }
    void glbAloneHasNoMaterialFile() {
        QCOMPARE(namesOf(filesOf(wallAsset(), {.formats = {"glb"}})), (Names{"wall-intact.glb", "wall-fragments.glb"}));
    }
    void usdAndMjcfAreFilesBesideTheMeshes() {
        const MeshOptions options{.formats = {"usd", "mjcf"}};
        const PackMeshes meshes = meshesOf(wallAsset(), options).value();
        QVERIFY(meshes.list.empty());
        QCOMPARE(namesOf(meshes.files), (Names{"wall.mjcf.xml", "wall.usda", "wall-intact.usda"}));
        Asset textured = wallAsset();
        const auto image = std::make_shared<const EncodedImage>(imageOf(checkerPng()));
        textured.texture = Texture{.name = "wall.png", .image = image, .materials = {0}};
        const std::vector<ExportFile> files = filesOf(textured, {.formats = {"usd"}});
        QCOMPARE(bytesNamed(files, "wall.png"), image->bytes());
        QVERIFY(bytesNamed(files, "wall.usda").find("inputs:file = @./wall.png@\n") != std::string::npos);
    }
    void textureIsAFileOfObjAndAPartOfGlb() {
        Asset asset = wallAsset();
        const auto image = std::make_shared<const EncodedImage>(imageOf(checkerPng() + "odd"));
        asset.texture = Texture{.name = "my wall.jpg.png", .image = image, .materials = {0}};
        const std::vector<ExportFile> files = filesOf(asset, {});
        QCOMPARE(bytesNamed(files, "my_wall.jpg.png"), image->bytes());
        QCOMPARE(bytesNamed(files, "wall.mtl"),
                 std::string("# Rubble 1\nnewmtl brick_outside\nKd 0.8 0.8 0.8\nmap_Kd my_wall.jpg.png\nillum 1\n"
                             "newmtl brick_inside\nKd 0.8 0.8 0.8\nillum 1\n"));
        Glb glb;
        QCOMPARE(openGlb(bytesNamed(files, "wall-fragments.glb"), glb), std::string());
        const nlohmann::json& view = glb.json["bufferViews"][glb.json["images"][0]["bufferView"].get<std::size_t>()];
        QVERIFY(glb.binary.substr(view["byteOffset"], view["byteLength"]) == image->bytes());
        QVERIFY(glb.json["buffers"][0]["byteLength"].get<std::size_t>() <= glb.binary.size());
        QVERIFY(glb.json["images"][0]["mimeType"] == "image/png");
        QVERIFY(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 0);
        QVERIFY(!glb.json["materials"][1]["pbrMetallicRoughness"].contains("baseColorTexture"));
        QCOMPARE(namesOf(filesOf(asset, {.formats = {"glb"}})).size(), std::size_t{2});  // no file for the image
        asset.texture->name = "pack.json";
        QVERIFY(!bytesNamed(filesOf(asset, {}), "pack.png").empty());
    }
    void everyMeshIsListedForThePack() {
        const Asset asset = wallAsset();
        const PackMeshes single = meshesOf(asset, {.formats = {"obj"}}).value();
        const std::vector<PackMeshFile> expected{{"wall-intact.obj", PackMeshBodies::Whole},
                                                 {"wall-fragments.obj", PackMeshBodies::Fragments}};
        QVERIFY(single.list == expected);
        const MeshOptions options{.formats = {"glb"}, .split = FileSplit::PerFragment, .place = PartPlacement::Centred};
        const PackMeshes each = meshesOf(asset, options).value();
        const PackMeshFile last{"wall_f4_1.glb", PackMeshBodies::Fragment, 1, PartPlacement::Centred};
        QVERIFY(each.list.back() == last);
    }
    void namesAreKnownBeforeFracturing() {
        for (const MeshOptions& options : formatOptions()) {
            for (const Asset& asset : {wallAsset(), texturedWall()}) {
                const PackFileNames known = meshFileNames(asset, kBrick, packNames(asset), options);
                QVERIFY(known.areAll);
                QCOMPARE(known.names, namesOf(filesOf(asset, options)));
            }
        }
    }
    void namesOfBakedImagesAreKnown() {
        const Material brick{.id = 1, .name = "brick", .finish = Finish::Brick};
        const Asset asset = wallAsset();
        const Bake baked = bake(asset).value();
        for (const FormatSet& formats : {FormatSet{"glb"}, FormatSet{"usd"}, FormatSet{"glb", "obj", "usd"}}) {
            const MeshOptions options{
                .formats = formats, .textures = SurfaceTextures::Baked, .textureSize = TextureSize::Texels512};
            const PackMeshes meshes =
                packMeshes(PackBuilder({baked, asset, brick, packNames(asset), {}}), options).value();
            QCOMPARE(meshFileNames(asset, brick, packNames(asset), options).names, namesOf(meshes.files));
        }
    }
    void namesThatDependOnFragmentsAreNotKnown() {
        Asset single = wallAsset();
        single.fragmentLevels = {{"4.1", Level{scatterOf(3, 6)}}};
        for (MeshOptions options : formatOptions()) {
            for (const Asset& asset : {wallAsset(), ringAsset(), single}) {
                for (const FileSplit split : {FileSplit::Single, FileSplit::PerFragment}) {
                    options.split = split;
                    const PackFileNames known = meshFileNames(asset, kBrick, packNames(asset), options);
                    Names written = namesOf(filesOf(asset, options));
                    QCOMPARE(known.areAll, known.names == written);
                    std::erase_if(written, [&](const std::string& name) {
                        return std::ranges::find(known.names, name) == known.names.end();
                    });
                    QCOMPARE(known.names, written);
                }
            }
        }
    }
    void namesInFilesHaveNoSpaces() {
        const std::vector<ExportFile> files = filesOf(ringAsset(), {.formats = {"obj"}});
        QCOMPARE(namesOf(files), (Names{"old_ring-intact.obj", "old_ring-fragments.obj",
                                        "old_ring-fragments-level-0.obj", "old_ring.mtl"}));
    }
    void objectsHaveTheNamesOfTheFragmentTable() {
        const Asset asset = ringAsset();
        const Bake baked = bake(asset).value();
        const std::vector<ExportFile> files = filesOf(asset, {.formats = {"obj"}});
        std::set<std::string> expected, names;
        for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
            std::string name = "old_ring_f";
            for (const char letter : baked.fragmentPath(k))
                name += letter == '.' ? "_" : letter == '/' ? "__" : std::string(1, letter);
            expected.insert(name);
        }
        for (const char* name : {"old_ring-fragments.obj", "old_ring-fragments-level-0.obj"}) {
            for (const ObjObject& object : readObj(bytesNamed(files, name))) names.insert(object.name);
        }
        QCOMPARE(names, expected);
        QCOMPARE(fragmentBodyName(packNames(asset), "3/5.17+8.2/4.1"), std::string("old_ring_f5_17x8_2__4_1"));
    }
    void fragmentsOfAFileDoNotOverlap() {
        const Asset asset = ringAsset();
        const Bake baked = bake(asset).value();
        std::size_t broken = 0;
        double brokenVolume = 0.0;
        for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
            const BakedFragment fragment = baked.fragment(k);
            if (fragment.childCount == 0) continue;
            ++broken;
            brokenVolume += fragment.solid.volume();
        }
        QVERIFY(broken > 0 && broken < 12);
        const std::vector<ExportFile> files = filesOf(asset, {});
        QCOMPARE(readObj(bytesNamed(files, "old_ring-fragments-level-0.obj")).size(), broken);
        QCOMPARE(readObj(bytesNamed(files, "old_ring-fragments.obj")).size(), baked.fragmentCount() - broken);
        QVERIFY(std::abs(volumeOfObj(bytesNamed(files, "old_ring-fragments.obj")) - 5.98) < 6e-9);
        QVERIFY(std::abs(volumeOfObj(bytesNamed(files, "old_ring-fragments-level-0.obj")) - brokenVolume) < 6e-9);
        QVERIFY(std::abs(volumeOfObj(bytesNamed(files, "old_ring-intact.obj")) - 5.98) < 6e-9);
    }
    void allOptionsGiveClosedFragmentsWithTheWholesVolume() {
        for (const PartPlacement place : {PartPlacement::Assembled, PartPlacement::Centred}) {
            for (const FaceShape faces : {FaceShape::Polygons, FaceShape::Triangles}) {
                const std::vector<ExportFile> files = filesOf(ringAsset(), {.place = place, .faces = faces});
                QVERIFY(std::abs(volumeOfObj(bytesNamed(files, "old_ring-fragments.obj")) - 5.98) < 6e-9);
                Glb glb;
                QCOMPARE(openGlb(bytesNamed(files, "old_ring-fragments.glb"), glb), std::string());
                double volume = 0.0;
                for (const nlohmann::json& node : glb.json["nodes"]) volume += volumeOf(meshOfNode(glb, node));
                QVERIFY(std::abs(volume - 5.98) < 6e-6);  // float32
            }
        }
    }
    void assembledFragmentsAreInPlaceAndCentredOnesAtTheOrigin() {
        const auto highest = [](PartPlacement place) {
            double height = 0.0;
            for (const ObjObject& object :
                 readObj(bytesNamed(filesOf(ringAsset(), {.place = place}), "old_ring-fragments.obj"))) {
                for (const Vec3 position : object.mesh.positions) height = std::max(height, position.y);
            }
            return height;
        };
        QCOMPARE(highest(PartPlacement::Assembled), 4.0);
        QVERIFY(highest(PartPlacement::Centred) < 2.0);
    }
    void facesOfGlbDoNotDependOnThoseOfObj() {
        const auto glb = [](FaceShape faces) {
            return bytesNamed(filesOf(ringAsset(), {.faces = faces}), "old_ring-fragments.glb");
        };
        QVERIFY(glb(FaceShape::Polygons) == glb(FaceShape::Triangles));
    }
    void cancellationStops() {
        const Asset asset = wallAsset();
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(meshesOf(asset, {}, task).error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(PackMeshesTest)
#include "PackMeshesTest.moc"
