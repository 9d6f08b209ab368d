// Tests --glb of app/cli/verbs/ExportVerb.cpp, which may change what --for selects.
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/RunProgram.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

class GlbKindTest : public QObject {
    Q_OBJECT
private slots:
    void kindOverridesTheProgram_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<bool>("hasHulls");
        QTest::newRow("of the program") << QStringList{"--for", "unreal"} << true;
        QTest::newRow("plain, before it") << QStringList{"--glb", "plain", "--for", "unreal"} << false;
        QTest::newRow("plain, behind it") << QStringList{"--for", "unreal", "--glb", "plain"} << false;
        QTest::newRow("without a program") << QStringList{"--glb", "ucx"} << true;
        QTest::newRow("by default") << QStringList{} << false;
    }
    void kindOverridesTheProgram() {
        QFETCH(QStringList, options);
        QFETCH(bool, hasHulls);
        const QTemporaryDir place;
        const QString file = place.filePath("box.rubble"), out = place.filePath("packs");
        QVERIFY(saveProject(file.toStdString(), boxProject(UniformScatter{.count = 3})));
        const ProgramOutcome outcome = runProgram(RUBBLE_CLI, QStringList{"export", file, "--out", out} + options);
        QVERIFY2(outcome.exit == 0, qPrintable(outcome.error));
        const std::string glb = readFile((out + "/box/box-fragments.glb").toStdString()).value();
        QCOMPARE(glb.find("UCX_") != std::string::npos, hasHulls);
    }
};

RUBBLE_TEST(GlbKindTest)
#include "GlbKindTest.moc"
