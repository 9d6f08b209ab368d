#include "core/base/Random.h"
#include "core/geometry/mesh/SourceScene.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <limits>

using namespace rubble;

namespace {

SourceScene twoObjects() {
    SourceScene scene{.metresPerUnit = 0.01, .materials = {{"Brick", {0.6, 0.2, 0.1}}, {}}};
    scene.objects.push_back({"Wall", true, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}});
    scene.objects.back().triangles.push_back({{0, 1, 2}, {Vec2{0.5, 0.25}, Vec2{1, 0}, Vec2{0, 1}}, 1});
    scene.objects.push_back({"", false, {{1, 2, 3}, {0.1, -4e-9, 5e9}}, {SourceTriangle{{1, 0, 1}, {}, 0}}});
    scene.objects.back().rounding = 1e-4;
    scene.objects.back().copies = {{{1, -2, 3e9}, {0.6, 0.0, 0.8, 0.0}}, {}};
    scene.notes = {"A file was not read."};
    return scene;
}

bool isRefused(const SourceScene& scene) { return !readSourceScene(sourceSceneBytes(scene)).hasValue(); }

}  // namespace

class SourceSceneTest : public QObject {
    Q_OBJECT
private slots:
    void serializedSceneIsReadBack() {
        QVERIFY(*readSourceScene(sourceSceneBytes(twoObjects())) == twoObjects());
        QVERIFY(*readSourceScene(sourceSceneBytes({})) == SourceScene{});
    }
    void truncatedOrExcessBytesAreRejected() {
        const std::string bytes = sourceSceneBytes(twoObjects());
        for (std::size_t size = 0; size < bytes.size(); ++size)
            QVERIFY(!readSourceScene(std::string_view(bytes).substr(0, size)).hasValue());
        QVERIFY(!readSourceScene(bytes + " ").hasValue());
        QCOMPARE(readSourceScene("").error().message, std::string("The bytes are not a valid mesh."));
    }
    void invalidValuesAreRejected() {
        SourceScene scene = twoObjects();
        scene.objects[0].triangles[0].points[2] = 3;
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[1].triangles[0].material = 2;
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[0].points[1].y = std::numeric_limits<double>::infinity();
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[0].triangles[0].uvs[1].x = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[0].triangles.clear();
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.materials[0].colour.x = 1.5;
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[0].name = "\xff";
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.notes[0] = "\xff";
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.metresPerUnit = -1.0;
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[1].copies[0].orientation.w = 0.7;
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[1].rounding = -1.0;
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[1].copies[0].position.z = std::numeric_limits<double>::infinity();
        QVERIFY(isRefused(scene));
    }
    /// A few bytes each must not become much memory.
    void tooManyNotesTrianglesOrCopiesAreRejected() {
        SourceScene scene = twoObjects();
        scene.objects[0].copies.assign(kMaxCopies, {});
        QVERIFY(!isRefused(scene));
        scene.objects[0].copies.assign(kMaxCopies + 1, {});
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.notes.assign(kMaxNotes, "");
        QVERIFY(!isRefused(scene));
        scene.notes.assign(kMaxNotes + 1, "");
        QVERIFY(isRefused(scene));
        scene = twoObjects();
        scene.objects[1].triangles.resize(kMaxTriangles);
        QVERIFY(isRefused(scene));
    }
    void anyBytesAreReadOrRejected() {
        const std::string bytes = sourceSceneBytes(twoObjects());
        Random random(20240);
        for (int round = 0; round < 20000; ++round) {
            std::string changed = bytes;
            for (int k = 0; k < 3; ++k)
                changed[14 + random.below(bytes.size() - 14)] = static_cast<char>(random.next());
            const Result<SourceScene> scene = readSourceScene(changed);
            if (scene) QVERIFY(*readSourceScene(sourceSceneBytes(*scene)) == *scene);
        }
    }
};

RUBBLE_TEST(SourceSceneTest)
#include "SourceSceneTest.moc"
