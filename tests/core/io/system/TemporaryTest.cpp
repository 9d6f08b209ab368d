#include "core/io/system/Temporary.h"

#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FolderNames.h"

#include <QTemporaryDir>
#include <QTest>

#include <sys/wait.h>
#include <csignal>

using namespace rubble;

namespace fs = std::filesystem;

namespace {

/// Runs `work` in another process, which is killed at its end.
template <class Work>
void runAndKill(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        std::raise(SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
}

using Names = std::vector<std::string>;

}  // namespace

class TemporaryTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_folder;

    /// Leaves what a process does that is killed after it moved files away and before it replaced them.
    void leaveOldContents(const Names& names) const {
        runAndKill([&] {
            const auto replacement = TemporaryFolder::create(m_folder);
            static_cast<void>(writeFileAtomically((*replacement)->path() / "file", "new"));
            const auto old = TemporaryFolder::createForOldContents(**replacement);
            for (const std::string& name : names) static_cast<void>(writeFileAtomically((*old)->path() / name, "old"));
            std::raise(SIGKILL);
        });
    }

private slots:
    void init() {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_folder = m_temporary->path().toStdString();
    }
    void everyWriteRemovesLeftovers() {
        runAndKill([&] {
            TemporaryFile file;
            static_cast<void>(file.create(m_folder, 0600));
            std::raise(SIGKILL);
        });
        QCOMPARE(namesIn(m_folder).size(), std::size_t{1});
        QVERIFY(writeFileAtomically(m_folder / "note", "text"));
        QCOMPARE(namesIn(m_folder), Names{"note"});
    }
    void leftoversOfAKilledProcessAreRemoved() {
        runAndKill([&] {
            TemporaryFile file;
            static_cast<void>(file.create(m_folder, 0600));
            const auto folder = TemporaryFolder::create(m_folder);
            static_cast<void>(writeFileAtomically((*folder)->path() / "file", "x"));
            std::raise(SIGKILL);
        });
        QCOMPARE(namesIn(m_folder).size(), std::size_t{2});
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder), Names{});
    }
    void thoseInUseStay() {
        TemporaryFile file;
        QCOMPARE(file.create(m_folder, 0600), 0);
        const auto folder = TemporaryFolder::create(m_folder);
        QVERIFY(folder);
        runAndKill([&] { removeLeftovers(m_folder); });
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder).size(), std::size_t{2});
        QVERIFY(file.renameTo(m_folder / "file", m_folder / "file"));
        QVERIFY(fs::exists(m_folder / "file"));
    }
    void oldContentsAreMovedBack() {
        leaveOldContents({"gone"});
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder), (Names{"gone"}));
        QCOMPARE(*readFile(m_folder / "gone"), std::string("old"));
    }
    void oldContentsThatWereReplacedAreRemoved() {
        leaveOldContents({"taken"});
        for (const fs::directory_entry& entry : fs::directory_iterator(m_folder)) {
            if (entry.path().extension() == ".tmp") fs::rename(entry, m_folder / "taken");
        }
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder), (Names{"taken"}));
        QCOMPARE(*readFile(m_folder / "taken" / "file"), std::string("new"));
    }
    void oldContentsWhoseNameWasTakenByOthersAreKept() {
        leaveOldContents({"gone", "taken"});
        QVERIFY(writeFileAtomically(m_folder / "taken", "of the user", Leftovers::Kept));
        for (int count = 0; count < 2; ++count) {
            removeLeftovers(m_folder);
            QCOMPARE(namesIn(m_folder).size(), std::size_t{4});  // of them two are hidden
            QCOMPARE(*readFile(m_folder / "gone"), std::string("old"));
            QCOMPARE(*readFile(m_folder / "taken"), std::string("of the user"));
        }
        fs::remove(m_folder / "taken");
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder), (Names{"gone", "taken"}));
        QCOMPARE(*readFile(m_folder / "taken"), std::string("old"));
    }
    void similarNamesStay() {
        const Names names{".rubble--0123456789abcdef.tmp",
                          ".rubble-12-0123456789abcdeg.tmp",
                          ".rubble-12-0123456789abcde.tmp",
                          ".rubble-materials.old",
                          ".rubble-notes.tmp",
                          ".rubble-x1-0123456789abcdef.old"};
        for (const std::string& name : names) {
            fs::create_directory(m_folder / name);
            QVERIFY(writeFileAtomically(m_folder / name / "work", "x"));
        }
        QVERIFY(writeFileAtomically(m_folder / ".rubble-.tmp", "x"));
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder).size(), names.size() + 1);
        for (const std::string& name : names) QVERIFY(fs::exists(m_folder / name / "work"));
    }
    void otherFilesAndLinksStay() {
        fs::create_directory(m_folder / "mine");
        QVERIFY(writeFileAtomically(m_folder / "mine" / "file", "x"));
        const std::string link = ".rubble-1-0123456789abcdef.tmp";
        fs::create_directory_symlink("mine", m_folder / link);
        QVERIFY(writeFileAtomically(m_folder / ".rubble-1-0123456789abcdef.txt", "x"));
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder), (Names{link, ".rubble-1-0123456789abcdef.txt", "mine"}));
        QVERIFY(fs::exists(m_folder / "mine" / "file"));
    }
};

RUBBLE_TEST(TemporaryTest)
#include "TemporaryTest.moc"
