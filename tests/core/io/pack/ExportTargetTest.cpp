#include "core/io/pack/ExportTarget.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <set>

using namespace rubble;

class ExportTargetTest : public QObject {
    Q_OBJECT
private slots:
    void everyTargetHasAReadmeOfItsOwn() {
        std::set<std::string> texts;
        for (std::size_t k = 0; k < kExportTargets.size(); ++k) {
            const std::string text = readmeFor(static_cast<ExportTarget>(k), GlbKind::Plain);
            QVERIFY(text.starts_with("# Destructible assets for "));
            QVERIFY(text.find("`scene.json`") != std::string::npos && text.ends_with(".\n"));
            // else all would be removed
            QVERIFY(text.find("has `bonding`, its `threshold` does not count") != std::string::npos);
            texts.insert(text);
        }
        QCOMPARE(texts.size(), kExportTargets.size());
    }
    void kindsOfGlbFilesAreExplained() {
        for (const GlbKind kind : {GlbKind::Plain, GlbKind::Physics, GlbKind::Compact}) {
            for (const ExportTarget target : {ExportTarget::Web, ExportTarget::Godot}) {
                const std::string text = readmeFor(target, kind);
                QCOMPARE(text.find("setMeshoptDecoder") != std::string::npos, kind == GlbKind::Compact);
                QCOMPARE(text.find("OMI_physics_body") != std::string::npos, kind == GlbKind::Physics);
            }
        }
    }
    void everyTargetHasMeshesAndBodies() {
        for (std::size_t k = 0; k < kExportTargets.size(); ++k) {
            const PackOptions options = optionsFor(static_cast<ExportTarget>(k));
            QVERIFY(options.meshes.glb || options.meshes.usd);
            QVERIFY(options.files != PackFiles::Binary);
            QCOMPARE(options.inset, kDefaultInset);
        }
        QVERIFY(optionsFor(ExportTarget::Neutral) == PackOptions());
        QVERIFY(!optionsFor(ExportTarget::Godot).meshes.obj);
    }
};

RUBBLE_TEST(ExportTargetTest)
#include "ExportTargetTest.moc"
