// Tests the commands of app/cli that README.md shows.
#include "tests/support/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

QString textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// A command of the tour with its quoted output.
struct Step {
    QString command;
    QString output;
};

/// Parses the README's console blocks: lines after "$ " are commands, the others their outputs.
QList<Step> stepsOf(const QString& readme) {
    QList<Step> steps;
    bool isConsole = false;
    for (const QString& line : readme.split('\n')) {
        if (line.startsWith("```")) {
            isConsole = line == "```console";
        } else if (isConsole && line.startsWith("$ ")) {
            steps.append({line.mid(2), {}});
        } else if (isConsole && !steps.isEmpty()) {
            steps.last().output += line + '\n';
        }
    }
    return steps;
}

/// Runs a command in a folder with rubble-cli in PATH and returns both outputs.
QString outputOf(const QString& command, const QString& folder) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QFileInfo(RUBBLE_CLI).path() + ':' + environment.value("PATH"));
    environment.insert("LC_ALL", "C");
    QProcess shell;
    shell.setProcessEnvironment(environment);
    shell.setWorkingDirectory(folder);
    shell.setProcessChannelMode(QProcess::MergedChannels);
    shell.start("/bin/sh", {"-c", command});
    if (!shell.waitForFinished(kPatience)) return "did not end in time";
    return QString::fromUtf8(shell.readAll());
}

/// Compares texts, in which "…" matches anything.
bool matches(const QString& output, const QString& expected) {
    const QString pattern = QRegularExpression::escape(expected).replace(QRegularExpression::escape("…"), ".*");
    const QRegularExpression expression(QRegularExpression::anchoredPattern(pattern),
                                        QRegularExpression::DotMatchesEverythingOption);
    return expression.match(output).hasMatch();
}

}  // namespace

/// Runs the commands of the README's tour in a folder with the files of a clone and compares their outputs.
class TourTest : public QObject {
    Q_OBJECT
private slots:
    void everyStepPrintsTheQuotedOutput() {
        const QList<Step> steps = stepsOf(textOf(RUBBLE_SOURCE_DIR "/README.md"));
        QVERIFY(steps.size() >= 5);
        QTemporaryDir clone;
        for (const char* part : {"projects", "tests"}) {
            QVERIFY(QFile::link(QString(RUBBLE_SOURCE_DIR "/") + part, clone.filePath(part)));
        }
        for (const Step& step : steps) {
            const QString output = outputOf(step.command, clone.path());
            QVERIFY2(matches(output, step.output), qPrintable("$ " + step.command + "\nprints\n" + output));
        }
    }
    /// The picture in the README is the output of the command below it.
    void pictureMatchesTheProgramsOutput() {
        const QString drawn = outputOf("rubble-cli draw projects/house.rubble", RUBBLE_SOURCE_DIR);
        QVERIFY(drawn.startsWith("<svg"));
        QCOMPARE(textOf(RUBBLE_SOURCE_DIR "/docs/pictures/house.svg"), drawn);
    }
};

RUBBLE_TEST_WITH(TourTest, QCoreApplication)
#include "TourTest.moc"
