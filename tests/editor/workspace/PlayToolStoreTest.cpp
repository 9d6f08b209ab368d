#include "editor/workspace/PlayToolStore.h"

#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace rubble;

class PlayToolStoreTest : public QObject {
    Q_OBJECT
private slots:
    void settingsAreReadAsWritten() {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("a.conf"), QSettings::IniFormat);
        QVERIFY(readPlayTools(settings) == PlayToolSettings());
        PlayToolSettings tools;
        tools.projectile.kind = ProjectileKind::Ball;
        tools.projectile.size = {0.2, 0.3, 0.4};
        tools.projectile.mass = 7.0;
        tools.isSpeedAutomatic = false;
        tools.hammerRadius = 0.5;
        tools.explosion.radius = 1.5;
        tools.grabForce = 300.0;
        writePlayTools(tools, settings);
        QVERIFY(readPlayTools(settings) == tools);
        PlayToolSettings asset = tools;
        asset.projectile.kind = ProjectileKind::Asset;
        asset.projectile.mass = 9.0;
        writePlayTools(asset, settings);
        QVERIFY(readPlayTools(settings) == tools);
    }
    void invalidValuesGetTheirDefaults() {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("a.conf"), QSettings::IniFormat);
        for (const char* key : {"width", "mass", "speed", "hammerImpulse", "hammerRadius", "blastImpulse",
                                "blastRadius", "grabForce", "projectile"}) {
            for (const QVariant& value : {QVariant(-1.0), QVariant("heavy"), QVariant(1e300),
                                          QVariant(std::numeric_limits<double>::quiet_NaN())}) {
                settings.setValue(QString("play/tools/") + key, value);
                QVERIFY2(readPlayTools(settings) == PlayToolSettings(), key);
            }
            settings.remove(QString("play/tools/") + key);
        }
    }
};

RUBBLE_TEST(PlayToolStoreTest)
#include "PlayToolStoreTest.moc"
