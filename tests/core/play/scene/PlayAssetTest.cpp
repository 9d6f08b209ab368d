// Tests core/play/scene/PlayAsset.cpp, core/play/scene/PlayScene.cpp and core/play/scene/BodyShape.cpp.
#include "core/play/scene/PlayAsset.h"

#include "core/asset/strength/FragmentThresholds.h"
#include "core/base/math/Roots.h"
#include "core/base/math/Trigonometry.h"
#include "core/play/scene/BodyShape.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/LayeredBox.h"
#include "tests/support/play/Sessions.h"

#include <numbers>

using namespace rubble;

class PlayAssetTest : public QObject {
    Q_OBJECT
private slots:
    void everyFragmentHasAShapeWithItsMass() {
        const auto scene = test::playSceneOf(test::floatingBlock(9));
        const PlayAsset& asset = *scene->assets.begin()->second;
        QCOMPARE(asset.fragments.size(), 9u);
        double volume = 0.0;
        for (const PlaySolid& piece : asset.fragments) {
            volume += piece.shape->mass.volume;
            const double fraction = piece.shape->mass.volume / 0.5;
            QVERIFY(std::abs(piece.thresholdScale - std::pow(fraction, 2.0 / 3.0)) < 1e-12);
        }
        QVERIFY(std::abs(volume - asset.whole.shape->mass.volume) < 1e-12);
        QCOMPARE(asset.fractureOf(kNone)->count, 9u);
        QVERIFY(asset.fractureOf(kNone)->neighbours.size() >= 8);
        QVERIFY(asset.fractureOf(0) == nullptr);
        QVERIFY(scene->diagnostics.empty());
    }
    void oneSeedGivesNoFracture() {
        const auto scene = test::playSceneOf(test::floatingBlock(1));
        QVERIFY(scene->assets.begin()->second->fractureOf(kNone) == nullptr);
    }
    void columnWithManyCornersIsSimplified() {
        Project project = test::floatingBlock();
        Ring& ring = project.assets[0].prism().outline.outer;
        ring.clear();
        for (int k = 0; k < 400; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 400.0;
            ring.push_back({0.5 * cosine(angle), 0.5 * sine(angle)});
        }
        const auto scene = test::playSceneOf(project);
        QVERIFY(!scene->diagnostics.empty());
        const Diagnostic& whole = scene->diagnostics[0];
        QVERIFY2(whole.message.starts_with("Asset 2 \"block\": The whole: It collides as a hull of"),
                 whole.message.c_str());
        QCOMPARE(whole.code, DiagnosticCode::SimplifiedShape);
        QCOMPARE(whole.place, (DiagnosticPlace{.asset = 2}));
        const Shape& shape = *scene->assets.begin()->second->whole.shape;
        QVERIFY(std::abs(shape.mass.volume - scene->assets.begin()->second->bake->whole.volume) < 1e-12);
    }
    void flatSolidCollidesAsABox() {
        const std::vector<Vec2> ring{{0.0, 0.0}, {1.0, 0.0}, {0.5, 1e-5}};
        const Polytope flat = extruded(ring, -0.25, 0.25);
        const Result<BodyShape> shape = bodyShape({&flat, 1}, massOf(flat));
        QVERIFY(shape.hasValue());
        QVERIFY(shape->simplified.has_value() || shape->shape->hulls[0].hull->minWidth > 0.0f);
    }
    void noHullsAreRejected() { QVERIFY(!bodyShape({}, {})); }
    void thresholdScaleIsTheTwoThirdsPower() {
        for (const double number : {1e-300, 1e-9, 0.001, 0.3, 1.0, 2.0, 27.0, 12345.678, 1e300}) {
            QVERIFY(std::abs(cubeRoot(number) - std::cbrt(number)) <= 3e-16 * std::cbrt(number));
        }
    }
    /// Two halves with a level below them.
    void thresholdsOfFragmentsTakePrecedence() {
        Project project;
        project.nextId = 100;
        project.materials = {{.id = 1, .name = "stone"}};
        project.assets = {layeredBox()};
        Asset& asset = project.assets[0];
        asset.threshold = 80.0;
        const auto thresholds = [&] {
            const auto scene = test::playSceneOf(project);
            const PlayAsset& ready = test::onlyAsset(*scene);
            return std::array{thresholdOf(ready.whole, 80.0), thresholdOf(ready.fragments[0], 80.0),
                              thresholdOf(ready.fragments[1], 80.0)};
        };
        const double byVolume = 80.0 * thresholdScaleOf(0.5);
        QVERIFY(isNear(thresholds()[1], byVolume) && isNear(thresholds()[2], byVolume));
        asset.fragmentThresholds = {{"5.1", 3.25}};
        QVERIFY(isNear(thresholds()[1], byVolume));
        QCOMPARE(thresholds()[2], 3.25);
        asset.levels[0].threshold = 12.5;
        QCOMPARE(thresholds(), (std::array{80.0, 12.5, 3.25}));
    }
    void thresholdsOfMissingFragmentsAreReported() {
        Project project;
        project.nextId = 100;
        project.materials = {{.id = 1, .name = "stone"}};
        project.assets = {layeredBox()};
        project.assets[0].fragmentThresholds = {{"5.1", 3.25}, {"5.1/6.0", 2.0}, {"5.7", 1.0}};
        const auto scene = test::playSceneOf(project);
        const std::vector<Diagnostic>& reports = test::onlyAsset(*scene).diagnostics;
        QCOMPARE(reports.size(), std::size_t{2});
        QCOMPARE(reports[1].message,
                 std::string("Fragment 5.7 has its own threshold, but does not exist or does not break."));
    }
    void instanceWithoutABakeIsRejected() {
        const Project project = test::floatingBlock();
        const auto scene = playScene(project, AssetBakes{});
        QVERIFY(!scene);
        QCOMPARE(scene.error().message, std::string("Instance 4 \"block\" is of asset 2, which is not baked yet."));
    }
};

RUBBLE_TEST(PlayAssetTest)
#include "PlayAssetTest.moc"
