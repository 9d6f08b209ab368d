// Tests app/cli/Cli.cpp: what rubble-cli does where memory runs out.
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

/// Runs rubble-cli with at most so much address space.
ProgramOutcome runWithin(int mebibytes, const QStringList& arguments) {
    const QString command = QString("ulimit -v %1; exec \"$0\" \"$@\"").arg(mebibytes * 1024);
    return runProgram("sh", QStringList{"-c", command, RUBBLE_CLI} + arguments);
}

}  // namespace

class OutOfMemoryTest : public QObject {
    Q_OBJECT
private slots:
    void verbsEndWithASentence_data() {
        QTest::addColumn<QString>("verb");
        QTest::addColumn<int>("count");
        QTest::addColumn<QStringList>("options");
        // Many fragments fail at a large block, few at a small one.
        constexpr int kMany = 550'000, kFew = 120'000;
        QTest::newRow("simulate") << "simulate" << kMany << QStringList{"{project}", "--steps", "1"};
        QTest::newRow("simulate few") << "simulate" << kFew << QStringList{"{project}", "--steps", "1"};
        QTest::newRow("audit few") << "audit" << kFew << QStringList{"{project}"};
        QTest::newRow("export few") << "export" << kFew << QStringList{"{project}", "--out", "{folder}/packs"};
        QTest::newRow("export") << "export" << kMany
                                << QStringList{"{project}", "--out", "{folder}/packs", "--threads", "2"};
        QTest::newRow("draw") << "draw" << kMany << QStringList{"{project}", "--out", "{folder}/wall.svg"};
        QTest::newRow("check") << "check" << kMany << QStringList{"{project}"};
    }
    void verbsEndWithASentence() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("AddressSanitizer reserves terabytes of address space.");
#endif
        QFETCH(QString, verb);
        QFETCH(int, count);
        QFETCH(QStringList, options);
        QTemporaryDir place;
        const QString file = place.filePath("wall.rubble");
        for (QString& option : options) {
            if (option == "{project}") option = file;
            option.replace("{folder}", place.path());
        }
        QVERIFY(saveProject(file.toStdString(), boxProject(UniformScatter{.count = count})));
        const ProgramOutcome ended = runWithin(250, QStringList{verb} + options);
        QCOMPARE(ended.error, "Out of memory while running rubble-cli " + verb +
                                  "; use fewer fragments or smaller textures, or close other programs.\n");
        QCOMPARE(ended.exit, 1);
        QCOMPARE(ended.output, "");
        QCOMPARE(QDir(place.path()).entryList(QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"wall.rubble"});
    }
    void tooLargeProjectsAreRefusedAtOnce() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("AddressSanitizer reserves terabytes of address space.");
#endif
        QTemporaryDir place;
        Project project = boxProject(UniformScatter{.count = 2});
        for (Id layer = 50; layer < 79; ++layer) {
            project.assets[0].levels.push_back(
                {.pattern = {{{.id = layer, .parameters = UniformScatter{.count = 2}}}}});
        }
        const QString file = place.filePath("wall.rubble");
        QVERIFY(saveProject(file.toStdString(), project));
        const ProgramOutcome ended = runWithin(250, {"export", file, "--out", place.filePath("packs")});
        QCOMPARE(ended.error,
                 "Asset \"box\": about 2147483646 fragments would take 4520 GiB of memory; at most 2 GiB are "
                 "allowed. Use fewer seeds or levels, or a larger minimum volume.\n");
        QCOMPARE(ended.exit, 1);
    }
};

RUBBLE_TEST_WITH(OutOfMemoryTest, QCoreApplication)
#include "OutOfMemoryTest.moc"
