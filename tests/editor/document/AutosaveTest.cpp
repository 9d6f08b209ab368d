#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/Autosave.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ManyInstances.h"
#include "tests/support/files/FileLimits.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <cstdio>
#include <memory>

using namespace rubble;
using namespace std::chrono_literals;

namespace {

constexpr int kMany = 5000;  // instances, so that a backup is not written at once
constexpr const char* kChildFolder = "RUBBLE_AUTOSAVE_CHILD";

void setHeight(Document& document, double height) {
    SceneSettings scene = sceneSettings(document.project());
    scene.ground.height = height;
    document.push({.text = "Move ground", .replacements = {scene}});
}

double heightIn(const QString& path) {
    const Result<Project> project = loadProject(path.toStdString());
    return project ? project->ground.height : -1.0;
}

/// Edits the document and runs the event loop until a backup of it is being written. Returns false where none is.
bool startBackup(Document& document, Autosave& autosave, double height) {
    autosave.setInterval(1s);
    setHeight(document, height);
    const QDeadlineTimer end(kPatience);
    while (!autosave.isWriting() && !end.hasExpired()) QCoreApplication::processEvents();
    return autosave.isWriting();
}

/// Edits until it is killed: raises the ground by 1 every 20 ms, with a backup every second.
int editForever(const QString& folder) {
    Document document(starterProject());
    Autosave autosave(document, folder);
    autosave.setOrigin({"/home/user/wall.rubble", contentHash("as it was")});
    autosave.setInterval(1s);
    QTimer timer;
    double height = 0.0;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        setHeight(document, height += 1.0);
        std::printf("%g\n", height);
        std::fflush(stdout);
    });
    timer.start(20ms);
    return QCoreApplication::exec();
}

}  // namespace

class AutosaveTest : public QObject {
    Q_OBJECT
public:
    /// As a child process, this program edits instead of testing.
    static void initMain() {
        if (!qEnvironmentVariableIsSet(kChildFolder)) return;
        int argumentCount = 0;
        const QCoreApplication program(argumentCount, nullptr);
        std::exit(editForever(qEnvironmentVariable(kChildFolder)));
    }

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void unchangedDocumentHasNoBackup() {
        const Document document(starterProject());
        Autosave autosave(document, m_folder->path());
        autosave.writeNow();
        QVERIFY(backups().isEmpty());
    }
    void changeIsBackedUpWithinTheInterval() {
        Document document(starterProject());
        Autosave autosave(document, m_folder->path());
        autosave.setInterval(1s);
        setHeight(document, 3.0);
        QTRY_COMPARE_WITH_TIMEOUT(backups().size(), 1, kPatience);
        QCOMPARE(heightIn(backups()[0]), 3.0);
        QVERIFY(orphanedBackups(m_folder->path()).empty());  // its program is running
    }
    void newIntervalCountsFromTheChange() {
        Document document(starterProject());
        Autosave autosave(document, m_folder->path());
        autosave.setInterval(1s);
        setHeight(document, 3.0);
        QTimer preferences;  // as if they were changed all the time
        connect(&preferences, &QTimer::timeout, &autosave, [&] { autosave.setInterval(1s); });
        preferences.start(200ms);
        QTRY_COMPARE_WITH_TIMEOUT(backups().size(), 1, kPatience);
    }
    void savingAndClosingRemoveTheBackup() {
        Document document(starterProject());
        {
            Autosave autosave(document, m_folder->path());
            setHeight(document, 3.0);
            autosave.writeNow();
            QCOMPARE(backups().size(), 1);
            document.setSaved();
            QVERIFY(backups().isEmpty());
            setHeight(document, 4.0);
            autosave.writeNow();
            QCOMPARE(backups().size(), 1);
        }
        QVERIFY(backups().isEmpty());
    }
    void unwritableFolderIsReported() {
        Document document(starterProject());
        const QString file = m_folder->filePath("file");
        QVERIFY(QFile(file).open(QIODevice::WriteOnly));
        Autosave autosave(document, file);
        QString sentence;
        connect(&autosave, &Autosave::failed, this, [&](const QString& told) { sentence = told; });
        setHeight(document, 3.0);
        autosave.writeNow();
        QVERIFY2(sentence.startsWith("The backup could not be written: "), qPrintable(sentence));
    }
    void failedBackupIsWrittenLater() {
        Document document(starterProject());
        Autosave autosave(document, m_folder->path());
        autosave.setInterval(1s);
        setHeight(document, 3.0);
        {
            const FileSizeLimit limit(10);
            autosave.writeNow();
        }
        QVERIFY(backups().isEmpty());
        QTRY_COMPARE_WITH_TIMEOUT(backups().size(), 1, kPatience);
    }
    void adoptedBackupStaysUntilTheNextIsWritten() {
        {
            Backup left = newBackup(m_folder->path());
            QVERIFY(writeBackup(left, QByteArray::fromStdString(projectText(starterProject()))));
        }
        Document document(starterProject());
        Autosave autosave(document, m_folder->path());
        std::vector<Backup> orphans = orphanedBackups(m_folder->path());
        QCOMPARE(orphans.size(), std::size_t{1});
        document.replaceUnsaved(starterProject());
        autosave.adopt(orphans[0]);
        orphans.clear();
        QVERIFY(orphanedBackups(m_folder->path()).empty());  // this program uses it
        const QStringList adopted = backups();
        QCOMPARE(adopted.size(), 1);
        autosave.writeNow();  // nothing: the adopted one is up to date
        setHeight(document, 3.0);
        {
            const FileSizeLimit limit(10);
            autosave.writeNow();
        }
        QCOMPARE(backups(), adopted);
        QCOMPARE(heightIn(adopted[0]), starterProject().ground.height);
        autosave.writeNow();
        QCOMPARE(backups(), adopted);
        QCOMPARE(heightIn(adopted[0]), 3.0);
        document.setSaved();
        QVERIFY(backups().isEmpty());
    }
    void savingStopsTheBackupThatIsWritten() {
        Document document(test::manyInstances(kMany));
        Autosave autosave(document, m_folder->path());
        QVERIFY(startBackup(document, autosave, 3.0));
        document.setSaved();
        QVERIFY(!autosave.isWriting() && backups().isEmpty());  // nothing is left that could write one
    }
    void closingStopsTheBackupThatIsWritten() {
        {
            Document document(test::manyInstances(kMany));
            Autosave autosave(document, m_folder->path());
            QVERIFY(startBackup(document, autosave, 3.0));
        }
        QVERIFY(backups().isEmpty());
    }
    void writingNowReplacesTheBackupThatIsWritten() {
        Document document(test::manyInstances(kMany));
        Autosave autosave(document, m_folder->path());
        for (const double height : {3.0, 5.0}) {
            QVERIFY(startBackup(document, autosave, height));
            autosave.writeNow();  // unchanged since then
            QVERIFY(!autosave.isWriting());
            QCOMPARE(backups().size(), 1);
            QCOMPARE(heightIn(backups()[0]), height);
            QVERIFY(startBackup(document, autosave, height + 0.5));
            setHeight(document, height + 1.0);
            autosave.writeNow();
            QCOMPARE(heightIn(backups()[0]), height + 1.0);
        }
    }
    void changeWhileABackupIsWrittenIsWrittenNext() {
        Document document(test::manyInstances(kMany));
        Autosave autosave(document, m_folder->path());
        QVERIFY(startBackup(document, autosave, 3.0));
        setHeight(document, 4.0);
        QTRY_VERIFY_WITH_TIMEOUT(!backups().isEmpty() && heightIn(backups()[0]) == 4.0, kPatience);
    }
    void adoptingStopsTheBackupThatIsWritten() {
        Document document(test::manyInstances(kMany));
        Autosave autosave(document, m_folder->path());
        QVERIFY(startBackup(document, autosave, 3.0));
        Backup other = newBackup(m_folder->filePath("other"));
        autosave.adopt(other);
        QVERIFY(!autosave.isWriting() && backups().isEmpty());
    }
    void faultInTheBackgroundIsReported() {
        Document document(test::manyInstances(kMany));
        Autosave autosave(document, m_folder->path());
        QString sentence;
        connect(&autosave, &Autosave::failed, this, [&](const QString& told) { sentence = told; });
        {
            const FileSizeLimit limit(10);
            QVERIFY(startBackup(document, autosave, 3.0));
            QTRY_VERIFY_WITH_TIMEOUT(!sentence.isEmpty(), kPatience);
        }
        QVERIFY2(sentence.startsWith("The backup could not be written: "), qPrintable(sentence));
        QVERIFY(backups().isEmpty());
        QTRY_COMPARE_WITH_TIMEOUT(backups().size(), 1, kPatience);  // tried again
    }
    void killedProgramLeavesABackup() {
        QProcess child;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(kChildFolder, m_folder->path());
        child.setProcessEnvironment(environment);
        child.start(QCoreApplication::applicationFilePath(), {"AutosaveTest"});
        QTRY_VERIFY_WITH_TIMEOUT(!backups().isEmpty(), kPatience);
        child.readAllStandardOutput();
        QTRY_VERIFY(child.canReadLine());
        const double sureToBeSaved = child.readLine().trimmed().toDouble();
        QTRY_VERIFY(!backups().isEmpty() && heightIn(backups()[0]) >= sureToBeSaved);  // and it goes on editing
        ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
        QVERIFY(child.waitForFinished(kPatience));

        const std::vector<Backup> left = orphanedBackups(m_folder->path());
        QCOMPARE(left.size(), std::size_t{1});
        QCOMPARE(left[0].origin.path, "/home/user/wall.rubble");
        QVERIFY(left[0].origin.hash == contentHash("as it was"));
        QVERIFY2(heightIn(left[0].path) >= sureToBeSaved,
                 qPrintable(QString("%1 < %2").arg(heightIn(left[0].path)).arg(sureToBeSaved)));
        removeBackup(left[0]);
        QVERIFY(orphanedBackups(m_folder->path()).empty());
    }

private:
    QStringList backups() const {
        QStringList paths;
        for (const QFileInfo& file : QDir(m_folder->path()).entryInfoList({"*.rubble"})) paths += file.filePath();
        return paths;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

RUBBLE_TEST_WITH(AutosaveTest, QCoreApplication)
#include "AutosaveTest.moc"
