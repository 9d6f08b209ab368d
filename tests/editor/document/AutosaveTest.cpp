#include "core/asset/library/StarterProject.h"
#include "core/base/Random.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/Autosave.h"
#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ManyInstances.h"
#include "tests/support/asset/MeshProjects.h"
#include "tests/support/files/FileLimits.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <vector>

using namespace rubble;
using namespace std::chrono_literals;

namespace fs = std::filesystem;

namespace {

constexpr int kMany = 5000;  // instances, so that a backup is not written at once
constexpr const char* kChildFolder = "RUBBLE_AUTOSAVE_CHILD";
constexpr const char* kChildInterval = "RUBBLE_AUTOSAVE_SECONDS";
constexpr const char* kKills = "RUBBLE_AUTOSAVE_KILLS";  // how often a program is killed; default: a few times

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

/// Makes the edit of a number from 1 on, the same each time: raises the ground to it, adds, moves, or removes an
/// instance, or changes an asset.
void makeEdit(Document& document, int number) {
    Random random(static_cast<std::uint64_t>(number));
    const Project& project = document.project();
    SceneSettings scene = sceneSettings(project);
    scene.ground.height = number;
    Edit edit{.text = "Edit", .replacements = {scene}};
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random.unit() * double(count)); };
    const bool isAdding = project.instances.size() < 2 || random.unit() < 0.4;
    if (random.unit() < 0.2) {
        Asset asset = project.assets[0];
        asset.prism().depth = 0.1 + random.unit();
        edit.replacements.push_back(Replacement<Asset>{asset.id, asset});
    } else if (isAdding) {
        const Id id = edit.allocateId(project);
        Instance instance = project.instances[0];
        instance.id = id;
        instance.name = "wall " + std::to_string(number);
        edit.replacements.push_back(Replacement<Instance>{id, instance});
    } else {
        std::optional<Instance> instance = project.instances[1 + below(project.instances.size() - 1)];
        const Id id = instance->id;
        instance->pose.position.x += random.unit();
        if (random.unit() < 0.5) instance.reset();
        edit.replacements.push_back(Replacement<Instance>{id, instance});
    }
    if (!document.push(std::move(edit))) std::abort();
}

/// Edits until it is killed: makes the edits in order, one every 20 ms, and prints their numbers.
int editForever(const QString& folder) {
    Document document(starterProject());
    Autosave autosave(document, folder);
    autosave.setOrigin({"/home/user/wall.rubble", contentHash("as it was")});
    autosave.setInterval(std::chrono::seconds(qEnvironmentVariableIntValue(kChildInterval)));
    QTimer timer;
    int number = 0;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        makeEdit(document, ++number);
        std::printf("%d\n", number);
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
        connect(&autosave, &Autosave::failed, this, [&](const QString& reported) { sentence = reported; });
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
        connect(&autosave, &Autosave::failed, this, [&](const QString& reported) { sentence = reported; });
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
        start(child, 1);
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

    void killedProgramLosesTwoSecondsAtMost() {
        const int kills = std::max(3, qEnvironmentVariableIntValue(kKills));
        Random random(20);
        for (int kill = 0; kill < kills; ++kill) {
            init();
            const int interval = random.unit() < 0.5 ? 1 : 60;
            QProcess child;
            start(child, interval);
            QVERIFY(child.waitForReadyRead(kPatience));
            const int enough = 115 + static_cast<int>(random.below(100));  // edits; at least 2.3 s
            std::vector<QDeadlineTimer> sureAfter(1);                      // of each edit: two seconds after it
            const auto readEdits = [&] {
                while (child.canReadLine())
                    sureAfter.resize(child.readLine().trimmed().toUInt() + 1, QDeadlineTimer(2000));
                return static_cast<int>(sureAfter.size()) - 1;
            };
            while (readEdits() < enough) QVERIFY(child.waitForReadyRead(kPatience));
            ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
            const auto sure = static_cast<int>(std::ranges::count_if(sureAfter, &QDeadlineTimer::hasExpired)) - 1;
            QVERIFY(child.waitForFinished(kPatience));
            const int last = readEdits();
            const std::vector<Backup> left = orphanedBackups(m_folder->path());
            QCOMPARE(left.size(), std::size_t{1});
            const auto recovered = recoverProject(toPath(left[0].path), toPath(journalPath(left[0])));
            QVERIFY2(recovered.hasValue(), recovered ? "" : recovered.error().message.c_str());
            QVERIFY(recovered->faults.empty());
            const int found = static_cast<int>(recovered->project.ground.height);
            QVERIFY2(
                found >= sure && found <= last + 1,
                qPrintable(QString("kill %1: %2 of %3 edits, %4 are sure").arg(kill).arg(found).arg(last).arg(sure)));
            QVERIFY(recovered->project == projectAfter(found));
        }
    }
    void editsAreRecordedWithinASecond() {
        Document document(starterProject());
        Autosave autosave(document, m_folder->path());
        autosave.setInterval(60s);
        for (const double height : {3.0, 4.0, 5.0}) {
            setHeight(document, height);
            QTRY_COMPARE(recoveredHeight(), height);
        }
        QCOMPARE(heightIn(backups()[0]), 3.0);  // the others are in the journal
        document.undoStack().undo();
        QTRY_COMPARE(recoveredHeight(), 4.0);
        autosave.writeNow();
        QCOMPARE(heightIn(backups()[0]), 4.0);
        QCOMPARE(recoveredHeight(), 4.0);  // the old journal does not count
        document.setSaved();
        QVERIFY(QDir(m_folder->path()).entryList({"*.journal"}).isEmpty());
    }
    void faultOfTheJournalIsReportedAndMended() {
        Document document(starterProject());
        Autosave autosave(document, m_folder->path());
        autosave.setInterval(2s);
        QString sentence;
        connect(&autosave, &Autosave::failed, this, [&](const QString& reported) { sentence = reported; });
        setHeight(document, 3.0);
        QTRY_COMPARE(recoveredHeight(), 3.0);
        QTRY_VERIFY(!autosave.isWriting());
        {
            const FileSizeLimit limit(10);
            setHeight(document, 4.0);
            QTRY_VERIFY_WITH_TIMEOUT(!sentence.isEmpty(), kPatience);
        }
        QCOMPARE(recoveredHeight(), 3.0);
        QTRY_COMPARE_WITH_TIMEOUT(recoveredHeight(), 4.0, kPatience);
    }
    void meshesAreBackedUpOnceAndRecovered() {
        Document document(test::meshProject());
        Autosave autosave(document, m_folder->path());
        autosave.setInterval(60s);
        setHeight(document, 3.0);
        QTRY_COMPARE(recoveredHeight(), 3.0);
        QVERIFY(*recovered() == document.project());
        const fs::path mesh = meshFile(document.project());
        const auto written = fs::last_write_time(mesh) - std::chrono::hours(1);
        fs::last_write_time(mesh, written);
        rename(document, "statue");  // recorded in the journal, with its mesh
        QTRY_VERIFY(*recovered() == document.project());
        autosave.writeNow();
        document.setSaved();
        QVERIFY(backups().isEmpty());
        setHeight(document, 4.0);
        autosave.writeNow();
        QVERIFY(*recovered() == document.project() && fs::last_write_time(mesh) == written);

        Asset other = document.project().assets[1];
        other.shape = test::meshProject(test::torus(8, 6)).assets[1].shape;
        document.push({.text = "Edit", .replacements = {Replacement<Asset>{other.id, other}}});
        QTRY_VERIFY(*recovered() == document.project());  // by the journal
        QVERIFY(fs::exists(mesh) && fs::exists(meshFile(document.project())));
        setHeight(document, 5.0);
        autosave.writeNow();
        QVERIFY(*recovered() == document.project() && !fs::exists(mesh));
    }
    void closingRemovesTheMeshes() {
        {
            Document document(test::meshProject());
            Autosave autosave(document, m_folder->path());
            setHeight(document, 3.0);
            autosave.writeNow();
            QVERIFY(*recovered() == document.project());
        }
        QVERIFY(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).isEmpty());
    }
    void longJournalsBecomeBackups() {
        Document document(test::manyInstances(kMany));
        Autosave autosave(document, m_folder->path());
        autosave.setInterval(600s);
        qint64 most = 0;
        for (int height = 1; height <= 20; ++height) {
            Edit edit{.text = "Move"};
            for (Instance instance : document.project().instances) {
                instance.pose.position.y = height;
                edit.replacements.push_back(Replacement<Instance>{instance.id, instance});
            }
            QVERIFY(document.push(std::move(edit)));
            QTRY_COMPARE_WITH_TIMEOUT(recoveredPosition(), double(height), kPatience);
            for (const QFileInfo& file : QDir(m_folder->path()).entryInfoList({"*.journal"}))
                most = std::max(most, file.size());
        }
        const qint64 text = QFileInfo(backups()[0]).size();
        QVERIFY2(most > text && most < 4 * text, qPrintable(QString("%1 of %2").arg(most).arg(text)));
    }

private:
    void start(QProcess& child, int interval) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(kChildFolder, m_folder->path());
        environment.insert(kChildInterval, QString::number(interval));
        child.setProcessEnvironment(environment);
        child.start(QCoreApplication::applicationFilePath(), {"AutosaveTest"});
    }
    static Project projectAfter(int edits) {
        Document document(starterProject());
        for (int number = 1; number <= edits; ++number) makeEdit(document, number);
        return document.project();
    }
    static void rename(Document& document, const char* name) {
        Asset asset = document.project().assets[1];
        asset.name = name;
        QVERIFY(document.push({.text = "Rename", .replacements = {Replacement<Asset>{asset.id, asset}}}));
    }
    fs::path meshFile(const Project& project) const {
        return meshPath(meshFolderOf(toPath(backups()[0])), project.assets[1].mesh()->hash);
    }
    /// The backup with its journal.
    std::optional<Project> recovered() const {
        if (backups().isEmpty()) return std::nullopt;
        const Backup backup{.path = backups()[0]};
        const auto project = recoverProject(toPath(backup.path), toPath(journalPath(backup)));
        return project ? std::optional(project->project) : std::nullopt;
    }
    double recoveredHeight() const {
        const std::optional<Project> project = recovered();
        return project ? project->ground.height : -1.0;
    }
    double recoveredPosition() const {
        const std::optional<Project> project = recovered();
        return project ? project->instances.back().pose.position.y : -1.0;
    }
    QStringList backups() const {
        QStringList paths;
        for (const QFileInfo& file : QDir(m_folder->path()).entryInfoList({"*.rubble"})) paths += file.filePath();
        return paths;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

RUBBLE_TEST_WITH(AutosaveTest, QCoreApplication)
#include "AutosaveTest.moc"
