// Tests core/io/system/LockFile.cpp and core/io/system/LockHolder.cpp.
#include "core/io/system/LockFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileLimits.h"

#include <sys/wait.h>
#include <unistd.h>

#include <QFile>
#include <QLockFile>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace rubble;

namespace {

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

QByteArray textOf(qint64 process, const QByteArray& host, const QByteArray& machine) {
    return QByteArray::number(process) + "\nrubble\n" + host + '\n' + machine + '\n' + QSysInfo::bootUniqueId() +
           "\nbob\n";
}

QByteArray textHere(qint64 process) {
    return textOf(process, QSysInfo::machineHostName().toUtf8(), QSysInfo::machineUniqueId());
}

}  // namespace

class LockFileTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath("lock");
    }

    void fileExistsAsLongAsTheLock() {
        {
            const LockAttempt first = lock();
            QVERIFY(first.lock && !first.holder && first.reason.empty());
            QVERIFY(QFile::exists(m_path));
            const LockAttempt second = lock();
            QVERIFY(!second.lock && second.holder);
            QVERIFY(second.holder->isRunningHere && second.holder->isThisProcess);
            QCOMPARE(second.holder->process, std::int64_t{::getpid()});
            QCOMPARE(second.holder->host, QSysInfo::machineHostName().toStdString());
            QVERIFY(!second.holder->user.empty() && !second.holder->program.empty());
            const auto age = std::chrono::system_clock::now() - second.holder->since;
            QVERIFY(age > -std::chrono::minutes(1) && age < std::chrono::minutes(1));
        }
        QVERIFY(!QFile::exists(m_path));
        QVERIFY(lock().lock);
    }
    void killedProcessHoldsNothing() {
        int ready[2];
        QCOMPARE(::pipe(ready), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            const LockAttempt held = lock();
            const char isLocked = held.lock ? 1 : 0;
            static_cast<void>(::write(ready[1], &isLocked, 1));
            ::pause();
            ::_exit(0);
        }
        char isLocked = 0;
        QCOMPARE(::read(ready[0], &isLocked, 1), ssize_t{1});
        QCOMPARE(isLocked, char{1});
        const LockAttempt refused = lock(LockTakeover::Any);  // not from a running process
        QVERIFY(refused.holder && refused.holder->isRunningHere && !refused.holder->isThisProcess);
        QCOMPARE(refused.holder->process, std::int64_t{child});
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        ::close(ready[0]);
        ::close(ready[1]);
        QVERIFY(QFile::exists(m_path));
        QVERIFY(lock().lock);
    }
    void reusedProcessIdIsNotTheHolder() {
        write(m_path, textHere(::getpid()));
        QVERIFY(lock().lock);
    }
    void lockOfAnotherMachineIsTakenOnRequest() {
        write(m_path, textOf(4711, "render01", "another-machine"));
        const LockAttempt refused = lock();
        QVERIFY(!refused.lock && refused.holder && !refused.holder->isRunningHere);
        QCOMPARE(refused.holder->program, std::string("rubble"));
        QCOMPARE(refused.holder->host, std::string("render01"));
        QCOMPARE(refused.holder->user, std::string("bob"));
        QCOMPARE(refused.holder->process, std::int64_t{4711});
        QVERIFY(lock(LockTakeover::Any).lock);
    }
    void fileWithoutTextIsTakenOnRequest() {
        for (const QByteArray& text : {QByteArray(), QByteArray("garbage"), QByteArray(9000, 'x')}) {
            write(m_path, text);
            const LockAttempt refused = lock();
            QVERIFY(refused.holder && refused.holder->process == 0 && refused.holder->host.empty());
            QVERIFY(!refused.holder->user.empty());  // the owner of the file
            QVERIFY(lock(LockTakeover::Any).lock);
        }
    }
    void fileThatAnotherTookOverIsKept() {
        {
            const LockAttempt held = lock();
            QVERIFY(held.lock && QFile::remove(m_path));
            write(m_path, textOf(4711, "render01", "another-machine"));
        }
        QVERIFY(QFile::exists(m_path));
    }
    void placeThatCannotBeWrittenIsReported() {
        const auto reasonAt = [](const QString& path) { return lockFile(path.toStdString()).reason; };
        QCOMPARE(reasonAt(m_folder->filePath("none/lock")), std::string("No such file or directory"));
        QVERIFY(QFile::setPermissions(m_folder->path(),
                                      QFile::ReadOwner | QFile::ExeOwner | QFile::ReadOther | QFile::ExeOther));
        {
            const AsNobody nobody;
            QCOMPARE(reasonAt(m_path), std::string("Permission denied"));
        }
        QVERIFY(QFile::setPermissions(m_folder->path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        {
            const FileSizeLimit limit(3);
            QCOMPARE(reasonAt(m_path), std::string("No space left on device"));  // only three bytes were written
            QVERIFY(!QFile::exists(m_path));
        }
        QVERIFY(lock().lock);
    }
    void olderVersionsSeeTheLock() {
        {
            const LockAttempt held = lock();
            QVERIFY(held.lock);
            QLockFile older(m_path);
            older.setStaleLockTime(0);
            QVERIFY(!older.tryLock(0));
        }
        QLockFile older(m_path);
        older.setStaleLockTime(0);
        QVERIFY(older.tryLock(0));
        const LockAttempt refused = lock();
        QVERIFY(refused.holder && refused.holder->isThisProcess);
    }

private:
    LockAttempt lock(LockTakeover takeover = LockTakeover::Stale) const {
        return lockFile(m_path.toStdString(), takeover);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

RUBBLE_TEST_WITH(LockFileTest, QCoreApplication)
#include "LockFileTest.moc"
