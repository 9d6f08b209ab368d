#include "app/cli/console/ProgressLine.h"

#include "app/cli/Cli.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <sstream>

using namespace rubble;

class ProgressLineTest : public QObject {
    Q_OBJECT
private slots:
    void progressNeverGoesBack() {
        std::ostringstream out, err, terminal;
        const CliContext context{.in = -1, .out = out, .err = err, .terminal = &terminal};
        ProgressLine line(context, "Exporting");
        for (const double fraction : {0.0, 0.06, 0.0, 0.065, 0.5, 0.49, 1.0}) line.show(fraction);
        line.clear();
        QCOMPARE(terminal.str(),
                 "\r\x1b[KExporting 0 %\r\x1b[KExporting 6 %\r\x1b[KExporting 50 %\r\x1b[KExporting 100 %"
                 "\r\x1b[K");
        QCOMPARE(out.str() + err.str(), "");
    }
    void quietVerbsShowNone() {
        for (const bool isQuiet : {false, true}) {
            std::ostringstream out, err, terminal;
            std::vector<std::string> arguments{"check", RUBBLE_SOURCE_DIR "/projects/pane.rubble"};
            if (isQuiet) arguments.emplace_back("-q");
            QCOMPARE(runCli(arguments, {.in = -1, .out = out, .err = err, .terminal = &terminal}), 0);
            QCOMPARE(terminal.str().empty(), isQuiet);
            QCOMPARE(out.str().empty(), isQuiet);
        }
    }
    void nothingIsShownWithoutATerminal() {
        std::ostringstream out, err;
        const CliContext context{.in = -1, .out = out, .err = err};
        ProgressLine line(context, "Exporting");
        line.show(0.5);
        line.clear();
        QCOMPARE(out.str() + err.str(), "");
    }
};

RUBBLE_TEST(ProgressLineTest)
#include "ProgressLineTest.moc"
