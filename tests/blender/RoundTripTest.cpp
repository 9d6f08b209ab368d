// Tests core/io/exchange and core/io/pack with Blender.
#include "core/io/pack/PackMeshes.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/files/TestImages.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

const QString kScript = RUBBLE_SOURCE_DIR "/tests/blender/round_trip.py";
const QByteArray kMark = "ROUND TRIP ";

/// Blender's report on each file, by name.
QMap<QString, QJsonObject> imported(const QStringList& paths) {
    QProcess blender;
    blender.start(
        "blender",
        QStringList{"--background", "--factory-startup", "--python-exit-code", "1", "--python", kScript, "--"} + paths);
    QMap<QString, QJsonObject> files;
    if (!blender.waitForFinished(kPatience) || blender.exitCode() != 0) {
        qWarning("%s", blender.readAllStandardError().constData());
        return files;
    }
    for (const QByteArray& line : blender.readAllStandardOutput().split('\n')) {
        if (!line.startsWith(kMark)) continue;
        const QJsonObject file = QJsonDocument::fromJson(line.mid(kMark.size())).object();
        files[QFileInfo(file["file"].toString()).fileName()] = file;
    }
    return files;
}

double volumeOf(const QJsonArray& objects) {
    double sum = 0.0;
    for (const QJsonValue object : objects) sum += object["volume"].toDouble();
    return sum;
}

}  // namespace

/// Exports an asset with concave, holed and cut-apart fragments on two levels, imports it into Blender and checks it
/// there.
class RoundTripTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        if (QStandardPaths::findExecutable("blender").isEmpty()) QSKIP("Blender is not installed.");
        Asset asset = ringAsset();
        asset.texture = Texture{.name = "checker.png",
                                .image = std::make_shared<const EncodedImage>(imageOf(checkerPng())),
                                .materials = {0}};
        m_bake = bake(asset).value();
        QStringList paths;
        const Material brick{.id = 1, .name = "brick"};
        for (const PartPlacement place : {PartPlacement::Assembled, PartPlacement::Centred}) {
            const MeshOptions options{.place = place};
            const QString prefix = place == PartPlacement::Assembled ? "" : "centred-";
            const PackMeshes meshes =
                packMeshes(PackBuilder({m_bake, asset, brick, packNames(asset), {}}), options).value();
            for (const ExportFile& file : meshes.files) {
                // In one folder, so that each OBJ file finds its MTL file and image.
                const QString name = prefix + QString::fromStdString(file.name);
                const bool isMesh = name.endsWith(".obj") || name.endsWith(".glb");
                const QString path = m_folder.filePath(isMesh ? name : name.mid(prefix.size()));
                QVERIFY(writeFileAtomically(path.toStdString(), file.bytes));
                if (isMesh) paths << path;
            }
        }
        m_files = imported(paths);
        QCOMPARE(m_files.size(), paths.size());
    }

    void assetHasFragmentsOfEveryKind() {
        const auto has = [&](const auto& isSuch) {
            bool isFound = false;
            for (std::uint32_t k = 0; k < m_bake.fragmentCount(); ++k) isFound |= isSuch(m_bake.fragment(k).solid);
            return isFound;
        };
        QVERIFY(has([](const Fragment& solid) { return !solid.extruded()->outline().holes.empty(); }));
        QVERIFY(has([](const Fragment& solid) { return solid.partOfCell() != kNone; }));
        QVERIFY(has([](const Fragment& solid) { return solid.hulls().size() > 1; }));
    }

    void fragmentsAreClosedAndFillTheWhole_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<std::size_t>("count");
        QTest::addColumn<double>("volume");
        std::size_t broken = 0;
        double brokenVolume = 0.0;
        for (std::uint32_t k = 0; k < m_bake.fragmentCount(); ++k) {
            const BakedFragment fragment = m_bake.fragment(k);
            if (fragment.childCount == 0) continue;
            ++broken;
            brokenVolume += fragment.solid.volume();
        }
        for (const char* ending : {".obj", ".glb"}) {
            for (const char* prefix : {"", "centred-"}) {
                const QByteArray stem = QByteArray(prefix) + "old_ring";
                const auto addRow = [&](const char* part, std::size_t count, double volume) {
                    const QByteArray name = stem + part + ending;
                    QTest::newRow(name.constData()) << QString(name) << count << volume;
                };
                addRow("-intact", 1, m_bake.whole.volume);
                addRow("-fragments", m_bake.fragmentCount() - broken, m_bake.whole.volume);
                addRow("-fragments-level-0", broken, brokenVolume);
            }
        }
    }
    void fragmentsAreClosedAndFillTheWhole() {
        QFETCH(QString, file);
        QFETCH(std::size_t, count);
        QFETCH(double, volume);
        const QJsonArray objects = m_files[file]["objects"].toArray();
        QCOMPARE(static_cast<std::size_t>(objects.size()), count);
        for (const QJsonValue object : objects) {
            const QByteArray name = object["name"].toString().toUtf8();
            QVERIFY2(name.startsWith("old_ring"), name);
            QVERIFY2(object["closed"].toBool(), name);
            QVERIFY2(object["manifold"].toBool(), name);
            QVERIFY2(object["volume"].toDouble() > 0.0, name);
            QVERIFY2(object["uvs"].toInt() == 1, name);
            QVERIFY2(object["materials"].toArray().contains("brick_outside"), name);
        }
        QVERIFY(std::abs(volumeOf(objects) - volume) < 1e-6 * m_bake.whole.volume);
    }

    void outsideHasTheTexture() {
        for (const char* name : {"old_ring-fragments.obj", "old_ring-fragments.glb"}) {
            const QJsonObject textured = m_files[name]["textured"].toObject();
            QVERIFY2(textured["brick_outside"] == QJsonArray({16, 16}), name);
            QVERIFY2(!textured.contains("brick_inside"), name);
        }
    }

    void yIsUpAndFragmentsAreInPlace() {
        // z is up in Blender: the square of 4 m is upright, with a quarter metre of depth on either side.
        for (const char* name :
             {"old_ring-fragments.obj", "old_ring-fragments.glb", "old_ring-intact.obj", "old_ring-intact.glb"}) {
            const QJsonArray highest = m_files[name]["highest"].toArray();
            QVERIFY2(std::abs(highest[0].toDouble() - 4.0) < 1e-5, name);
            QVERIFY2(std::abs(highest[1].toDouble() - 0.25) < 1e-5, name);
            QVERIFY2(std::abs(highest[2].toDouble() - 4.0) < 1e-5, name);
        }
    }

private:
    QTemporaryDir m_folder;
    Bake m_bake;
    QMap<QString, QJsonObject> m_files;
};

RUBBLE_TEST_WITH(RoundTripTest, QCoreApplication)
#include "RoundTripTest.moc"
