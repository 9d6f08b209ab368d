// Tests core/io/animation/AnimatedScene.cpp, core/io/animation/GlbAnimation.cpp, core/io/animation/UsdAnimation.cpp and
// core/io/animation/AnimationFile.cpp.
#include "core/io/animation/AnimationFile.h"

#include "core/io/animation/GlbAnimation.h"
#include "core/io/animation/UsdAnimation.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/GlbReading.h"
#include "tests/support/files/TestImages.h"
#include "tests/support/play/Sessions.h"

#include <QTemporaryDir>

#include <algorithm>
#include <set>

using namespace rubble;

namespace {

/// A block that a box breaks.
Project brokenBlock() {
    Project project = test::floatingBlock();
    test::addShot(project, "a box", 0.0, test::throwAtBlock(200.0, 10.0));
    return project;
}

SessionTracks tracksOf(const Project& project, std::uint64_t steps = 60) {
    Session session = test::sessionOf(project);
    for (const Shot& shot : project.shots) {
        if (!session.add(shot)) qFatal("a shot cannot be fired");
    }
    Result<SessionTracks> tracks = recordTracks(std::move(session), {}, steps);
    if (!tracks) qFatal("%s", tracks.error().message.c_str());
    return std::move(*tracks);
}

AnimatedScene sceneOf(const Project& project, std::uint64_t steps = 60) {
    return *animatedScene("hit", project, tracksOf(project, steps));
}

nlohmann::json animationJson(const AnimatedScene& scene) {
    Glb glb;
    if (const std::string fault = openGlb(*glbAnimation(scene), glb); !fault.empty()) qFatal("%s", fault.c_str());
    return glb.json;
}

}  // namespace

class AnimationFileTest : public QObject {
    Q_OBJECT
private slots:
    void sceneHasEverySolidOnce() {
        const AnimatedScene scene = sceneOf(brokenBlock());
        QCOMPARE(scene.nodes.size(), std::size_t{7});  // the block, the box, and five fragments
        QCOMPARE(scene.nodes[0].name, "block_whole");
        QVERIFY(std::ranges::count(scene.nodes, "a_box_thrown", &AnimatedNode::name) == 1);
        std::set<std::string> names;
        for (const AnimatedNode& node : scene.nodes) names.insert(node.name);
        QCOMPARE(names.size(), scene.nodes.size());
        QCOMPARE(scene.meshes.size(), scene.nodes.size());
        QCOMPARE(scene.materials.size(), std::size_t{3});  // outside, inside, projectile
        for (const AnimatedMesh& mesh : scene.meshes) QVERIFY(volumeOf(mesh.mesh) > 0.0);
    }

    void instancesShareMeshes() {
        const AnimatedScene scene = sceneOf(test::house(), 1);
        QCOMPARE(scene.nodes.size(), std::size_t{77});
        QVERIFY2(scene.meshes.size() < 10, qPrintable(QString::number(scene.meshes.size())));
    }

    void glbHidesWhatIsNotThere() {
        const AnimatedScene scene = sceneOf(brokenBlock());
        const nlohmann::json gltf = animationJson(scene);
        QCOMPARE(gltf["nodes"].size(), std::size_t{7});
        QVERIFY(!gltf["nodes"][0].contains("scale"));
        QVERIFY(gltf["nodes"][6]["scale"] == (nlohmann::json{0, 0, 0}));
        int steps = 0;
        for (const nlohmann::json& sampler : gltf["animations"][0]["samplers"])
            steps += sampler["interpolation"] == "STEP" ? 1 : 0;
        QCOMPARE(steps, 7);  // the box is thrown in the first step
        QVERIFY(!gltf.contains("extensionsRequired"));
    }

    void whatRestsHasNoAnimation() {
        const nlohmann::json gltf = animationJson(sceneOf(test::floatingBlock(), 30));
        QVERIFY(!gltf.contains("animations"));
        QCOMPARE(gltf["bufferViews"].size(), std::size_t{4});
    }

    void usdHasTimeSamples() {
        const AnimatedScene scene = sceneOf(brokenBlock());
        const QString layer = QString::fromStdString(usdAnimation(scene, {}));
        QVERIFY(layer.contains("endTimeCode = 60\n"));
        QVERIFY(layer.contains("timeCodesPerSecond = 60\n"));
        QCOMPARE(layer.count("token visibility.timeSamples = {"), qsizetype{7});
        QCOMPARE(layer.count("0: \"invisible\""), qsizetype{6});
        QCOMPARE(layer.count("0: \"inherited\""), qsizetype{1});
        QVERIFY(!layer.contains("xformOp:scale"));
    }

    void usdShrinksWhatFades() {
        Project project = brokenBlock();
        project.debris.lifetime = 0.5;
        project.debris.fade = 0.25;
        const QString layer = QString::fromStdString(usdAnimation(sceneOf(project, 90), {}));
        QCOMPARE(layer.count("float3 xformOp:scale.timeSamples = {"), qsizetype{5});
    }

    void filesAreNamedByTheirSuffix() {
        const QTemporaryDir folder;
        const Project project = brokenBlock();
        const SessionTracks tracks = tracksOf(project);
        const std::filesystem::path place(folder.path().toStdString());
        QVERIFY(saveAnimation(place / "a.GLB", project, tracks).hasValue());
        QVERIFY(saveAnimation(place / "a.usda", project, tracks).hasValue());
        QVERIFY(bytesOfFile(folder.filePath("a.GLB")).startsWith("glTF"));
        QVERIFY(bytesOfFile(folder.filePath("a.usda")).startsWith("#usda 1.0\n"));
        const Status refused = saveAnimation(place / "a.fbx", project, tracks);
        QVERIFY(!refused && refused.error().message.find(".glb or .usda") != std::string::npos);
        QVERIFY(!QFile::exists(folder.filePath("a.fbx")));
    }

    void imagesAreInGlbFilesAndBesideUsd() {
        Project project = brokenBlock();
        const auto image = std::make_shared<const EncodedImage>(imageOf(checkerPng()));
        project.assets[0].texture = Texture{.name = "checker.png", .image = image, .materials = {0}};
        const SessionTracks tracks = tracksOf(project);
        const AnimatedScene scene = *animatedScene("hit", project, tracks);
        QCOMPARE(scene.images.size(), std::size_t{1});
        Glb glb;
        QCOMPARE(openGlb(*glbAnimation(scene), glb), std::string());
        const auto& view = glb.json["bufferViews"][glb.json["images"][0]["bufferView"].get<std::size_t>()];
        QVERIFY(glb.binary.substr(view["byteOffset"], view["byteLength"]) == image->bytes());
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("hit.usda").toStdString();
        QVERIFY(saveAnimation(file, project, tracks).hasValue());
        QVERIFY(bytesOfFile(folder.filePath("hit.usda")).contains("@./hit-checker.png@"));
        QCOMPARE(bytesOfFile(folder.filePath("hit-checker.png")).toStdString(), image->bytes());
    }

    void theBytesDoNotDependOnThreads() {
        const Project project = test::house();
        std::string bytes;
        for (const int threads : {1, 3}) {
            Result<Session> session = Session::start(test::playSceneOf(project), {.threads = threads});
            for (const Shot& shot : project.shots) QVERIFY(session->add(shot).hasValue());
            const Result<SessionTracks> tracks = recordTracks(std::move(*session), {}, 90);
            const std::string file = *glbAnimation(*animatedScene("house", project, *tracks));
            QVERIFY(bytes.empty() || bytes == file);
            bytes = file;
        }
    }
};

RUBBLE_TEST(AnimationFileTest)
#include "AnimationFileTest.moc"
