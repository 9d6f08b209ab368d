// Tests core/base/Parallel.cpp: rubble-cli where it may use only one of the machine's processors.
#include "tests/support/TestProgram.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <sched.h>

using namespace rubble;

namespace {

/// Confines this process to the first of the processors that it may use.
void confineToOneProcessor() {
    cpu_set_t allowed, first;
    CPU_ZERO(&first);
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    for (int processor = 0; processor < CPU_SETSIZE && CPU_COUNT(&first) == 0; ++processor) {
        if (CPU_ISSET(processor, &allowed)) CPU_SET(processor, &first);
    }
    sched_setaffinity(0, sizeof first, &first);
}

}  // namespace

class ConfinedTest : public QObject {
    Q_OBJECT
private slots:
    void nothingIsWrittenToStandardError_data() {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("default") << QStringList{};
        QTest::newRow("more threads than processors") << QStringList{"--threads", "8"};
    }
    void nothingIsWrittenToStandardError() {
        QFETCH(QStringList, options);
        const QTemporaryDir place;
        QProcess program;
        program.setChildProcessModifier(confineToOneProcessor);
        program.start(RUBBLE_CLI, QStringList{"export", RUBBLE_SOURCE_DIR "/projects/house.rubble", "--out",
                                              place.filePath("packs")} +
                                      options);
        QVERIFY(program.waitForFinished(kPatience));
        QCOMPARE(program.readAllStandardError(), QByteArray());
        QCOMPARE(program.exitCode(), 0);
    }
};

RUBBLE_TEST_WITH(ConfinedTest, QCoreApplication)
#include "ConfinedTest.moc"
