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

private slots:
    void init() {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_folder = m_temporary->path().toStdString();
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
        QCOMPARE(file.renameTo(m_folder / "file"), 0);
        QVERIFY(fs::exists(m_folder / "file"));
    }
    void oldContentsAreMovedBack() {
        runAndKill([&] {
            const auto folder = TemporaryFolder::create(m_folder, TemporaryFolder::Purpose::OldContents);
            static_cast<void>(writeFileAtomically((*folder)->path() / "gone", "old"));
            static_cast<void>(writeFileAtomically((*folder)->path() / "taken", "old"));
            std::raise(SIGKILL);
        });
        QVERIFY(writeFileAtomically(m_folder / "taken", "new"));
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder), (Names{"gone", "taken"}));
        QCOMPARE(*readFile(m_folder / "gone"), std::string("old"));
        QCOMPARE(*readFile(m_folder / "taken"), std::string("new"));
    }
    void otherFilesAndLinksStay() {
        fs::create_directory(m_folder / "mine");
        QVERIFY(writeFileAtomically(m_folder / "mine" / "file", "x"));
        fs::create_directory_symlink("mine", m_folder / ".rubble-1-0.tmp");
        QVERIFY(writeFileAtomically(m_folder / ".rubble-1-0.txt", "x"));
        removeLeftovers(m_folder);
        QCOMPARE(namesIn(m_folder), (Names{".rubble-1-0.tmp", ".rubble-1-0.txt", "mine"}));
        QVERIFY(fs::exists(m_folder / "mine" / "file"));
    }
};

RUBBLE_TEST(TemporaryTest)
#include "TemporaryTest.moc"
