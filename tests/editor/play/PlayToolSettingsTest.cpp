// Tests editor/play/PlayToolSettings.cpp.
#include "editor/play/PlayToolSettings.h"

#include "core/asset/project/Ranges.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/commands/Resizing.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QTest>

using namespace rubble;

class PlayToolSettingsTest : public QObject {
    Q_OBJECT
private slots:
    void wallsAndHousesHaveTheDefaults() {
        for (const double diagonal : {2.0, 3.9, 100.0, 0.0}) QVERIFY(defaultPlayTools(diagonal) == PlayToolSettings());
    }
    /// A head half a metre high: the box is a third of the house's, and as dense.
    void smallScenesHaveSmallProjectiles() {
        const PlayToolSettings tools = defaultPlayTools(0.64);
        QVERIFY(std::abs(tools.projectile.size.x - 0.22) < 1e-9);
        QVERIFY(std::abs(tools.projectile.mass - 82.0) < 1e-9);
        QVERIFY(std::abs(tools.hammerImpulse - 160.0) < 1e-9);
        QVERIFY(std::abs(tools.blast.impulse - 330.0) < 1e-9);
        QVERIFY(std::abs(tools.blast.radius - 0.96) < 1e-9);
    }
    void numbersAreInRangeForAnyScene() {
        for (double diagonal = 1e-6; diagonal < 10.0; diagonal *= 1.3) {
            const PlayToolSettings tools = defaultPlayTools(diagonal);
            QVERIFY(rangeOf(ProjectNumber::ProjectileSize).contains(tools.projectile.size.x));
            QVERIFY(rangeOf(ProjectNumber::Mass).contains(tools.projectile.mass));
            QVERIFY(rangeOf(ProjectNumber::HammerBlow).contains(tools.hammerImpulse));
            QVERIFY(rangeOf(ProjectNumber::HammerRadius).contains(tools.hammerRadius));
            QVERIFY(rangeOf(ProjectNumber::BlastImpulse).contains(tools.blast.impulse));
            QVERIFY(rangeOf(ProjectNumber::BlastRadius).contains(tools.blast.radius));
        }
    }
    void toolsFollowTheSizeOfTheSceneUntilTheyAreSet() {
        const auto startAtSize = [](test::Stage& stage, double size) {
            Project project = stage.document.project();
            for (Asset& asset : project.assets) asset = resized(asset, Vec3(size));
            QVERIFY(stage.document.push(editBetween("Resize", stage.document.project(), project)));
            stage.bake();
            stage.start();
            stage.controller.stop();
        };
        test::Stage stage;
        for (const double size : {0.25, 4.0, 0.5}) {
            startAtSize(stage, size);
            QVERIFY(stage.controller.toolSettings() == defaultPlayTools(std::sqrt(3.0) * size));
            QVERIFY(stage.controller.hasDefaultTools());
        }
        PlayToolSettings tools = stage.controller.toolSettings();
        tools.projectile.mass = 3.0;
        stage.controller.setToolSettings(tools);
        startAtSize(stage, 4.0);
        QVERIFY(stage.controller.toolSettings() == tools);
    }
};

RUBBLE_TEST_WITH(PlayToolSettingsTest, QCoreApplication)
#include "PlayToolSettingsTest.moc"
