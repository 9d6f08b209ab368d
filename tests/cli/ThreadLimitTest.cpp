// Tests that the verbs in app/cli work with the threads that the system allows, or end with a sentence.
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

const QString kHouse = RUBBLE_SOURCE_DIR "/projects/house.rubble";
constexpr const char* kNoRendering =
    "The system allows no more threads while rendering images; close other programs, or raise the limit of processes "
    "(ulimit -u).\n";

/// Runs rubble-cli where so many threads can be started.
ProgramOutcome runWithThreads(int threads, const QStringList& arguments) {
    RunOptions options;
    options.environment.insert("LD_PRELOAD", RUBBLE_FAULTS);
    options.environment.insert("RUBBLE_FAULT_THREADS", QString::number(threads));
    return runProgram(RUBBLE_CLI, arguments, options);
}

}  // namespace

class ThreadLimitTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("The library with the faults cannot be loaded before that of the sanitizer.");
#endif
    }
    void verbsNeedNoThreads_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("export") << QStringList{"export", kHouse, "--out", "{folder}/packs", "-j", "8"};
        QTest::newRow("check") << QStringList{"check", kHouse, "-j", "8"};
        QTest::newRow("audit") << QStringList{"audit", kHouse, "-j", "8"};
        QTest::newRow("simulate") << QStringList{"simulate", kHouse, "--steps", "20", "-j", "8"};
        QTest::newRow("test") << QStringList{"test", kHouse, "-j", "8"};
    }
    void verbsNeedNoThreads() {
        QFETCH(QStringList, arguments);
        QTemporaryDir place;
        arguments.replaceInStrings("{folder}", place.path());
        const ProgramOutcome free = runProgram(RUBBLE_CLI, arguments);
        for (const int threads : {0, 1, 2}) {
            QDir(place.filePath("packs")).removeRecursively();
            const ProgramOutcome ended = runWithThreads(threads, arguments);
            QCOMPARE(ended.error, free.error);
            QCOMPARE(ended.exit, free.exit);
            if (arguments[0] != "test") QCOMPARE(ended.output, free.output);
        }
    }
    void picturesEndWithASentence_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("render") << QStringList{"render", kHouse, "--out", "{folder}/house.png"};
        QTest::newRow("sheet") << QStringList{"sheet", kHouse, "--asset", "wall", "--out", "{folder}/sheet.png"};
        QTest::newRow("video") << QStringList{"video", kHouse, "{folder}/video", "--steps", "2"};
    }
    void picturesEndWithASentence() {
        QFETCH(QStringList, arguments);
        QTemporaryDir place;
        arguments.replaceInStrings("{folder}", place.path());
        for (const int threads : {0, 1, 2}) {
            const ProgramOutcome ended = runWithThreads(threads, arguments);
            QCOMPARE(ended.error, kNoRendering);
            QCOMPARE(ended.exit, 1);
            QVERIFY(QDir(place.path()).isEmpty());
        }
    }
};

RUBBLE_TEST_WITH(ThreadLimitTest, QCoreApplication)
#include "ThreadLimitTest.moc"
