#include "core/io/system/FolderExchange.h"

#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;
namespace fs = std::filesystem;

class FolderExchangeTest : public QObject {
    Q_OBJECT
private slots:
    void newFolderGetsItsName() {
        const QTemporaryDir temporary;
        const fs::path place = temporary.path().toStdString(), folder = place / "pack";
        const auto made = TemporaryFolder::create(place);
        QVERIFY(made && writeFileAtomically((*made)->path() / "a", "new"));
        QVERIFY(replaceFolder(**made, folder));
        QCOMPARE(readFile(folder / "a").value(), std::string("new"));
        QVERIFY(!fs::exists((*made)->path()));
    }
    void folderIsExchangedForTheNewOne() {
        const QTemporaryDir temporary;
        const fs::path place = temporary.path().toStdString(), folder = place / "pack";
        fs::create_directory(folder);
        QVERIFY(writeFileAtomically(folder / "b", "old"));
        const auto made = TemporaryFolder::create(place);
        QVERIFY(made && writeFileAtomically((*made)->path() / "a", "new"));
        QVERIFY(replaceFolder(**made, folder));
        QVERIFY(fs::exists(folder / "a") && !fs::exists(folder / "b"));
        QCOMPARE(readFile((*made)->path() / "b").value(), std::string("old"));
    }
    void lockIsWaitedForUntilItIsClosed() {
        const QTemporaryDir temporary;
        const fs::path place = temporary.path().toStdString();
        TaskContext task;
        task.cancel.cancel();
        Result<OpenFile> held = lockFolder(place);
        QVERIFY(held);
        QCOMPARE(lockFolder(place, task).error().code, ErrorCode::Cancelled);
        QCOMPARE(held->close(), 0);
        QVERIFY(lockFolder(place, task));
    }
    void missingFolderCannotBeLocked() {
        const QTemporaryDir temporary;
        QVERIFY(!lockFolder(fs::path(temporary.path().toStdString()) / "gone"));
    }
};

RUBBLE_TEST(FolderExchangeTest)
#include "FolderExchangeTest.moc"
