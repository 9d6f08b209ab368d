#include "core/io/project/ProjectLock.h"

#include "core/base/Utf8.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileLimits.h"

#include <QTemporaryDir>

#include <chrono>
#include <fstream>

using namespace rubble;

class ProjectLockTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;
    std::filesystem::path inFolder(const std::string& name) const {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }

private slots:
    void lockIsHiddenBesideTheProject() {
        QCOMPARE(lockPathOf(inFolder("house.rubble")), inFolder(".house.rubble.lock"));
    }
    void symbolicLinksShareALock() {
        std::ofstream(inFolder("real.rubble")) << "x";
        std::filesystem::create_symlink("real.rubble", inFolder("link.rubble"));
        QCOMPARE(lockPathOf(inFolder("link.rubble")), inFolder(".real.rubble.lock"));
    }
    void hardLinksShareALock() {
        const std::filesystem::path one = inFolder("one.rubble"), two = inFolder("sub/two.rubble");
        std::filesystem::create_directory(inFolder("sub"));
        std::ofstream(one) << "x";
        std::filesystem::create_hard_link(one, two);
        LockAttempt first = lockProject(one);
        QVERIFY(first.lock);
        const LockAttempt second = lockProject(two, LockTakeover::Any);
        QVERIFY(!second.lock && second.holder && second.holder->isRunningHere);
        QVERIFY(second.holder->process == 0 || second.holder->isThisProcess);
        QVERIFY(!std::filesystem::exists(lockPathOf(two)));
        first = {};
        QVERIFY(lockProject(two).lock);
    }
    void lockFollowsAFileThatIsReplaced() {
        const std::filesystem::path path = inFolder("replaced.rubble"), other = inFolder("other.rubble");
        std::ofstream(path) << "x";
        const LockAttempt attempt = lockProject(path);
        QVERIFY(writeFileAtomically(path, "y"));
        std::filesystem::create_hard_link(path, other);
        QVERIFY(lockProject(other).lock);  // nobody was informed of the new file
        QVERIFY(!attempt.lock->holdFile(path));
        QVERIFY(lockProject(other).holder);
        QVERIFY(!attempt.lock->holdFile(path));  // it is held already
    }
    void longNamesAreShortened() {
        const std::string longest = std::string(248, 'x') + ".rubble";  // 255 bytes
        const std::filesystem::path lock = lockPathOf(inFolder(longest));
        QCOMPARE(lock.filename().string().size(), std::size_t{255});
        QVERIFY(std::ofstream(lock).is_open());
        QVERIFY(lock != lockPathOf(inFolder(std::string(248, 'x') + ".Rubble")));
        QCOMPARE(lockPathOf(inFolder(std::string(249, 'x'))).filename(), '.' + std::string(249, 'x') + ".lock");
        std::string umlauts;
        for (int k = 0; k < 126; ++k) umlauts += "\u00e4";
        for (const char* ending : {"", "a"}) {  // characters of two bytes at even and at odd places
            const std::string shortened = lockPathOf(inFolder(ending + umlauts)).filename().string();
            QVERIFY(isUtf8(shortened) && shortened.size() <= 255 && shortened.size() >= 254);
        }
    }
    void writeProtectedProjectIsNotLocked() {
        const std::filesystem::path path = inFolder("protected.rubble");
        std::ofstream(path) << "x";
        std::filesystem::permissions(path, std::filesystem::perms::owner_read);
        std::filesystem::permissions(inFolder(""), std::filesystem::perms::all);  // a lock could be created
        {
            const AsNobody nobody;
            QCOMPARE(lockProject(path).reason, std::string("Permission denied"));
        }
        QVERIFY(!std::filesystem::exists(lockPathOf(path)));
    }
    void missingProjectIsLocked() {
        const LockAttempt attempt = lockProject(inFolder("new.rubble"));
        QVERIFY(attempt.lock);
        QCOMPARE(attempt.lock->path(), inFolder(".new.rubble.lock"));
    }
    void oneProcessAtATimeChangesAProject() {
        const std::filesystem::path path = inFolder("changed.rubble");
        {
            const auto lock = waitForProjectLock(path, {});
            QVERIFY(lock.hasValue());
            QVERIFY(lockProject(path).holder->isThisProgram);
        }
        QVERIFY(!std::filesystem::exists(lockPathOf(path)));
    }
    void holderOnAnotherMachineIsNamed() {
        const std::filesystem::path path = inFolder("far.rubble"), lock = lockPathOf(path);
        std::ofstream(lock) << "4711\nrubble\nrender01\nanother machine\nboot\nbob\n";
        QCOMPARE(waitForProjectLock(path, {}).error().message,
                 "\"" + path.string() + "\" is already open in rubble on render01, process 4711. Save and close it " +
                     "there first; if that program has ended, delete \"" + lock.string() + "\".");
        QVERIFY(std::filesystem::exists(lock));
    }
    void lockWithoutNameIsTakenOnceItIsOld() {
        const std::filesystem::path path = inFolder("killed.rubble"), lock = lockPathOf(path);
        std::ofstream(lock) << "";
        CancelToken cancel;
        cancel.cancel();
        QCOMPARE(waitForProjectLock(path, cancel).error().code, ErrorCode::Cancelled);  // it may be about to be written
        std::filesystem::last_write_time(lock, std::filesystem::file_time_type::clock::now() - std::chrono::minutes(1));
        QVERIFY(waitForProjectLock(path, {}).hasValue());
    }
    void waitingCanBeCancelled() {
        const auto held = waitForProjectLock(inFolder("held.rubble"), {});
        CancelToken cancel;
        cancel.cancel();
        QCOMPARE(waitForProjectLock(inFolder("held.rubble"), cancel).error().code, ErrorCode::Cancelled);
    }
    void projectThatCannotBeLockedIsAnError() {
        QCOMPARE(waitForProjectLock("none/a", {}).error().message,
                 std::string("Cannot write \"none/a\": No such file or directory."));
    }
    void namesThatAreNoTextHaveALock() {
        QCOMPARE(lockPathOf(inFolder("h\xff.rubble")), inFolder(".h\xff.rubble.lock"));
    }
};

RUBBLE_TEST(ProjectLockTest)
#include "ProjectLockTest.moc"
