// Tests the install target.
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QMimeDatabase>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

class InstallTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const ProgramOutcome installed =
            runProgram("cmake", {"--install", RUBBLE_BINARY_DIR, "--prefix", m_root.path()});
        QVERIFY2(installed.exit == 0, qPrintable(installed.error));
        qputenv("XDG_DATA_DIRS", m_root.filePath("share").toUtf8());
        qputenv("XDG_DATA_HOME", m_root.filePath("nothing").toUtf8());
    }

    void allFilesAreInstalled_data() {
        QTest::addColumn<QString>("file");
        for (const char* file : {"bin/rubble-cli",
                                 "libexec/rubble/rubble-importer",
                                 "share/applications/io.github.rubble.Rubble.desktop",
                                 "share/metainfo/io.github.rubble.Rubble.metainfo.xml",
                                 "share/mime/packages/io.github.rubble.Rubble.xml",
                                 "share/thumbnailers/io.github.rubble.Rubble.thumbnailer",
                                 "share/icons/hicolor/scalable/apps/io.github.rubble.Rubble.svg",
                                 "share/icons/hicolor/scalable/mimetypes/application-x-rubble.svg",
                                 "share/icons/hicolor/16x16/apps/io.github.rubble.Rubble.png",
                                 "share/icons/hicolor/512x512/apps/io.github.rubble.Rubble.png",
                                 "share/man/man1/rubble.1",
                                 "share/man/man1/rubble-cli.1",
                                 "share/bash-completion/completions/rubble-cli",
                                 "share/zsh/vendor-completions/_rubble-cli",
                                 "share/fish/vendor_completions.d/rubble-cli.fish",
                                 "share/doc/rubble/README.md",
                                 "share/doc/rubble/LICENSE",
                                 "share/doc/rubble/CHANGELOG.md",
                                 "share/doc/rubble/copyright",
                                 "share/doc/rubble/docs/architecture.md",
                                 "share/doc/rubble/projects/house.rubble",
                                 "share/rubble/projects/pane.rubble",
                                 "share/rubble/docs/manual/index.md",
                                 "share/rubble/docs/pictures/pane.svg",
                                 "share/rubble/docs/formats/rubble_pack.hpp",
                                 "share/rubble/resources/schemas/pack.schema.json"}) {
            QTest::newRow(file) << file;
        }
    }
    void allFilesAreInstalled() {
        QFETCH(const QString, file);
        QVERIFY(QFileInfo(m_root.filePath(file)).size() > 0);
    }
    void noOtherFilesAreInstalled() {
        QCOMPARE(QDir(m_root.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot),
                 QStringList({"bin", "libexec", "share"}));
        QCOMPARE(QDir(m_root.filePath("bin")).entryList(QDir::Files), QStringList({"rubble", "rubble-cli"}));
    }

    void installedProgramDrawsTheInstalledHouse() {
        const ProgramOutcome drawn = runCli({"draw", m_root.filePath("share/rubble/projects/house.rubble")});
        QCOMPARE(drawn.exit, 0);
        QVERIFY(drawn.output.startsWith("<svg"));
    }
    void installedEditorStarts() {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        const ProgramOutcome started =
            runProgram(m_root.filePath("bin/rubble"), {"--version"}, {.environment = environment});
        QCOMPARE(started.exit, 0);
        QVERIFY2(started.output.startsWith("Rubble "), qPrintable(started.output));
    }
    void installedProgramFindsItsImporter() {
        const ProgramOutcome imported = runCli(
            {"import", RUBBLE_SOURCE_DIR "/tests/data/meshes/wall.glb", "--into", m_root.filePath("imported.rubble")});
        QCOMPARE(imported.error, QString());
        QCOMPARE(imported.exit, 0);
    }

    void projectsAreRecognizedByTheirSuffix() {
        const QMimeType type = QMimeDatabase().mimeTypeForFile("/nowhere/house.rubble", QMimeDatabase::MatchExtension);
        QCOMPARE(type.name(), QString("application/x-rubble"));
        QCOMPARE(type.comment(), QString("Rubble project"));
        QVERIFY(type.inherits("application/json"));
    }
    void projectsAreRecognizedByTheirContent() {
        QFile house(m_root.filePath("share/rubble/projects/house.rubble"));
        QVERIFY(house.open(QIODevice::ReadOnly));
        QCOMPARE(QMimeDatabase().mimeTypeForData(house.readAll()).name(), QString("application/x-rubble"));
        QCOMPARE(QMimeDatabase().mimeTypeForData("{\n  \"format\": \"other\"").inherits("application/x-rubble"), false);
    }

    /// File managers run the command of the thumbnailer, with the paths and the size in place of %i, %o and %s.
    void projectsHaveThumbnails() {
        QSettings entry(m_root.filePath("share/thumbnailers/io.github.rubble.Rubble.thumbnailer"),
                        QSettings::IniFormat);
        entry.beginGroup("Thumbnailer Entry");
        QCOMPARE(entry.value("MimeType").toString(), QString("application/x-rubble"));
        const QString picture = m_root.filePath("thumbnail.png");
        QStringList words = entry.value("Exec").toString().split(' ');
        QCOMPARE(words.takeFirst(), entry.value("TryExec").toString());
        words.replaceInStrings("%i", m_root.filePath("share/rubble/projects/pane.rubble"));
        words.replaceInStrings("%o", picture);
        words.replaceInStrings("%s", "128");
        const ProgramOutcome drawn = runCli(words);
        QCOMPARE(drawn.error, QString());
        QCOMPARE(drawn.exit, 0);
        QCOMPARE(QImage(picture).size(), QSize(128, 128));
    }

private:
    ProgramOutcome runCli(const QStringList& arguments) const {
        return runProgram(m_root.filePath("bin/rubble-cli"), arguments);
    }

    const QTemporaryDir m_root;
};

RUBBLE_TEST_WITH(InstallTest, QCoreApplication)
#include "InstallTest.moc"
