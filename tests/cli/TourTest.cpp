#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace {

QString textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// A command of the tour with what it is said to print.
struct Step {
    QString command;
    QString output;
};

/// The lines of the README's console blocks: those after "$ " are commands, the others what they print.
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

/// What a command prints on both outputs, in a folder, with rubble-cli on the path.
QString outputOf(const QString& command, const QString& folder) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QFileInfo(RUBBLE_CLI).path() + ':' + environment.value("PATH"));
    environment.insert("LC_ALL", "C");
    QProcess shell;
    shell.setProcessEnvironment(environment);
    shell.setWorkingDirectory(folder);
    shell.setProcessChannelMode(QProcess::MergedChannels);
    shell.start("/bin/sh", {"-c", command});
    if (!shell.waitForFinished(60000)) return "did not end within a minute";
    return QString::fromUtf8(shell.readAll());
}

/// Equal but for "…", which stands for anything.
bool matches(const QString& output, const QString& expected) {
    const QString pattern = QRegularExpression::escape(expected).replace(QRegularExpression::escape("…"), ".*");
    const QRegularExpression expression(QRegularExpression::anchoredPattern(pattern),
                                        QRegularExpression::DotMatchesEverythingOption);
    return expression.match(output).hasMatch();
}

}  // namespace

/// The README's tour gives what it says, command by command, in a folder that holds what a clone does.
class TourTest : public QObject {
    Q_OBJECT
private slots:
    void everyStepPrintsWhatItSays() {
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
    /// The picture on the front page was drawn by the command below it.
    void thePictureIsWhatTheProgramDraws() {
        const QString drawn = outputOf("rubble-cli draw projects/house.rubble", RUBBLE_SOURCE_DIR);
        QVERIFY(drawn.startsWith("<svg"));
        QCOMPARE(textOf(RUBBLE_SOURCE_DIR "/docs/pictures/house.svg"), drawn);
    }
};

QTEST_GUILESS_MAIN(TourTest)
#include "TourTest.moc"
