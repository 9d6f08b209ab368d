#include "core/io/formats/ExportTarget.h"

#include "core/io/formats/ExportFormat.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <set>

using namespace rubble;

class ExportTargetTest : public QObject {
    Q_OBJECT
private slots:
    void everyTargetHasAReadmeOfItsOwn() {
        std::set<std::string> texts, words;
        for (const ExportTarget& target : exportTargets()) {
            const std::string text = readmeOf(target, target.options().meshes);
            QVERIFY(text.starts_with("# Destructible assets for "));
            QVERIFY(text.find("`scene.json`") != std::string::npos && text.ends_with(".\n"));
            // else all would be removed
            QVERIFY(text.find("has `bonding`, its `threshold` does not count") != std::string::npos);
            texts.insert(text);
            words.emplace(target.word);
            QCOMPARE(targetNamed(target.word), &target);
        }
        QCOMPARE(texts.size(), exportTargets().size());
        QCOMPARE(words.size(), exportTargets().size());
        QVERIFY(targetNamed("stone") == nullptr);
    }
    void kindsOfGlbFilesAreExplained() {
        for (const GlbKind kind : {GlbKind::Plain, GlbKind::Physics, GlbKind::Compact}) {
            for (const ExportTarget* target : {targetNamed("web"), targetNamed("godot")}) {
                const std::string text = readmeOf(*target, {.glbKind = kind});
                QCOMPARE(text.find("setMeshoptDecoder") != std::string::npos, kind == GlbKind::Compact);
                QCOMPARE(text.find("OMI_physics_body") != std::string::npos, kind == GlbKind::Physics);
                const std::string without = readmeOf(*target, {.formats = {"obj"}, .glbKind = kind});
                QVERIFY(without.find("setMeshoptDecoder") == std::string::npos);
            }
        }
    }
    void everyTargetHasMeshesAndBodies() {
        for (const ExportTarget& target : exportTargets()) {
            const PackOptions options = target.options();
            QVERIFY(options.meshes.formats.contains("glb") || options.meshes.formats.contains("usd"));
            for (const std::string_view word : target.formats) QVERIFY(formatNamed(word) != nullptr);
            QVERIFY(options.files != PackFiles::Binary);
            QCOMPARE(options.inset, kDefaultInset);
        }
        QVERIFY(exportTargets().front().options() == PackOptions());
        QVERIFY(!targetNamed("godot")->options().meshes.formats.contains("obj"));
    }
    void scriptsAreWritten() {
        QVERIFY(scriptOf(*targetNamed("unreal")).starts_with("#") || !scriptOf(*targetNamed("unreal")).empty());
        QVERIFY(targetNamed("godot")->script.empty());
    }
};

RUBBLE_TEST(ExportTargetTest)
#include "ExportTargetTest.moc"
