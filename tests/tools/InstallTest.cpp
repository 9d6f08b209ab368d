#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

/// A program's exit code and what it prints on both outputs.
struct Outcome {
    int exit = -1;
    QString output;
};

Outcome run(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    if (!process.waitForFinished(60000)) return {};
    return {process.exitCode(), QString::fromUtf8(process.readAll())};
}

}  // namespace

class InstallTest : public QObject {
    Q_OBJECT
private slots:
    void theInstalledProgramDrawsTheInstalledHouse() {
        QTemporaryDir place;
        const Outcome installed = run("cmake", {"--install", RUBBLE_BINARY_DIR, "--prefix", place.path()});
        QVERIFY2(installed.exit == 0, qPrintable(installed.output));
        for (const char* file :
             {"share/doc/rubble/README.md", "share/doc/rubble/LICENSE", "share/doc/rubble/CHANGELOG.md",
              "share/doc/rubble/docs/architecture.md", "share/rubble/projects/pane.rubble"}) {
            QVERIFY2(QFileInfo::exists(place.filePath(file)), file);
        }
        const Outcome drawn =
            run(place.filePath("bin/rubble-cli"), {"draw", place.filePath("share/rubble/projects/house.rubble")});
        QCOMPARE(drawn.exit, 0);
        QVERIFY(drawn.output.startsWith("<svg"));
    }
};

QTEST_GUILESS_MAIN(InstallTest)
#include "InstallTest.moc"
