// Tests CommandOption::formerWords() of app/cli/options/Command.cpp, and the options that have new words.
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QTest>

using namespace rubble;

/// What earlier versions called an option or a value is read, and neither listed in the help nor completed.
class FormerWordsTest : public QObject {
    Q_OBJECT

    static ProgramOutcome run(const QString& call) { return runProgram(RUBBLE_CLI, call.split(' ')); }

private slots:
    void areReadAsThePresentOnes_data() {
        QTest::addColumn<QString>("former");
        QTest::addColumn<QString>("present");
        QTest::newRow("option") << "export none.rubble --out none --pieces files"
                                << "export none.rubble --out none --fragments files";
        QTest::newRow("colour") << "render none.rubble --out none.png --colour piece"
                                << "render none.rubble --out none.png --colour fragment";
        QTest::newRow("number of fragments") << "sheet none.rubble --asset a --out none.png --sort pieces"
                                             << "sheet none.rubble --asset a --out none.png --sort fragments";
        QTest::newRow("smallest fragment") << "sheet none.rubble --asset a --out none.png --sort smallestPiece"
                                           << "sheet none.rubble --asset a --out none.png --sort smallestFragment";
    }
    void areReadAsThePresentOnes() {
        QFETCH(const QString, former);
        QFETCH(const QString, present);
        const ProgramOutcome expected = run(present), read = run(former);
        QVERIFY2(expected.error.contains("\"none.rubble\"") && !expected.error.contains("--help"),
                 qPrintable(expected.error));  // it got beyond the command line
        QCOMPARE(read.error, expected.error);
        QCOMPARE(read.exit, expected.exit);
    }
    void excludeThePresentOnes() {
        const ProgramOutcome both = run("export none.rubble --out none --pieces files --fragments files");
        QCOMPARE(both.error,
                 "--pieces is the former name of --fragments: give one of them; see rubble-cli export --help.\n");
    }
    void areNotListed() {
        for (const char* verb : {"export", "render", "sheet"}) {
            const ProgramOutcome help = run(QString(verb) + " --help");
            QVERIFY2(help.exit == 0 && !help.output.contains("piece", Qt::CaseInsensitive), qPrintable(help.output));
        }
        const ProgramOutcome completion = run("completion bash");
        QVERIFY(completion.exit == 0 && completion.output.contains("--fragments"));
        QVERIFY(!completion.output.contains("--pieces"));
    }
};

RUBBLE_TEST(FormerWordsTest)
#include "FormerWordsTest.moc"
