#include "editor/workspace/PlayToolStore.h"

#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/SavedWall.h"

#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace rubble;

namespace {

constexpr const char* kProject = "/projects/wall.rubble";

}  // namespace

class PlayToolStoreTest : public QObject {
    Q_OBJECT
private slots:
    void settingsAreReadAsWritten() {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("a.conf"), QSettings::IniFormat);
        QVERIFY(readPlayTools(settings, kProject) == PlayToolSettings());
        PlayToolSettings tools;
        tools.projectile.kind = ProjectileKind::Ball;
        tools.projectile.size = {0.2, 0.3, 0.4};
        tools.projectile.mass = 7.0;
        tools.isSpeedAutomatic = false;
        tools.hammerRadius = 0.5;
        tools.blast.radius = 1.5;
        tools.grabForce = 300.0;
        writePlayTools(tools, kProject, settings);
        QVERIFY(readPlayTools(settings, kProject) == tools);
        PlayToolSettings asset = tools;
        asset.projectile.kind = ProjectileKind::Asset;
        asset.projectile.mass = 9.0;
        writePlayTools(asset, kProject, settings);
        QVERIFY(readPlayTools(settings, kProject) == tools);
    }
    /// A ball that suits a pane does not suit a house.
    void toolsAreThoseOfTheirProject() {
        const QTemporaryDir place;
        PlayToolSettings ball;
        ball.projectile.kind = ProjectileKind::Ball;
        ball.projectile.mass = 2.0;
        QString path;
        {
            const auto workspace = test::savedWall(place);
            keepPlayTools(*workspace);
            workspace->play().setToolSettings(ball);
            path = workspace->file().path();
        }
        {
            Workspace workspace(starterProject(), place.filePath("backups"));
            keepPlayTools(workspace);
            QVERIFY(workspace.play().toolSettings() == PlayToolSettings());
            QVERIFY(workspace.file().open(path).hasValue());
            QVERIFY(workspace.play().toolSettings() == ball);
        }
        QVERIFY(readPlayTools(QSettings(), "") == PlayToolSettings());
    }
    void invalidValuesGetTheirDefaults() {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("a.conf"), QSettings::IniFormat);
        for (const char* key : {"width", "mass", "speed", "hammerImpulse", "hammerRadius", "blastImpulse",
                                "blastRadius", "grabForce", "projectile"}) {
            for (const QVariant& value : {QVariant(-1.0), QVariant("heavy"), QVariant(1e300),
                                          QVariant(std::numeric_limits<double>::quiet_NaN())}) {
                settings.setValue("play/tools/" + projectKey(kProject) + "/" + key, value);
                QVERIFY2(readPlayTools(settings, kProject) == PlayToolSettings(), key);
            }
            settings.remove("play/tools/" + projectKey(kProject) + "/" + key);
        }
    }
};

RUBBLE_TEST(PlayToolStoreTest)
#include "PlayToolStoreTest.moc"
