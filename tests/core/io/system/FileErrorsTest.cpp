// Tests core/io/system/FileErrors.cpp and core/io/system/FolderReading.cpp.
#include "core/io/system/FileErrors.h"

#include "core/io/system/AtomicFile.h"
#include "core/io/system/FolderReading.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <set>

using namespace rubble;
namespace fs = std::filesystem;

class FileErrorsTest : public QObject {
    Q_OBJECT
private slots:
    void errorsNameThePathAndTheReason() {
        QCOMPARE(cannotWrite("a/b", EACCES).message, "Cannot write \"a/b\": Permission denied.");
        QVERIFY(cannotWrite("a/b", ENOENT).code == ErrorCode::Io);
        QCOMPARE(cannotDo("lock", "a/b", EACCES).message, "Cannot lock \"a/b\": Permission denied.");
    }
    void missingFileIsNotFoundWhereItIsRead() {
        QVERIFY(cannotRead("a", ENOENT).code == ErrorCode::NotFound);
        QVERIFY(cannotRead("a", ENOTDIR).code == ErrorCode::NotFound);
        QVERIFY(cannotRead("a", EACCES).code == ErrorCode::Io);
    }
    void errorKeepsItsCodeBehindAPath() {
        const Error error = withPath("Cannot read", "a/b", {ErrorCode::BadInput, "It is empty."});
        QVERIFY(error.code == ErrorCode::BadInput);
        QCOMPARE(error.message, "Cannot read \"a/b\": It is empty.");
    }
    void temporaryNameIsReplaced() {
        QCOMPARE(namedAs("shown", "x.tmp", cannotWrite("x.tmp", EACCES)).message,
                 "Cannot write \"shown\": Permission denied.");
        QCOMPARE(namedAs("shown", "other", cannotWrite("x.tmp", EACCES)).message,
                 "Cannot write \"x.tmp\": Permission denied.");
    }
    void entriesOfAFolderAreListed() {
        const QTemporaryDir temporary;
        const fs::path place = temporary.path().toStdString();
        QVERIFY(writeFileAtomically(place / "a", "") && writeFileAtomically(place / ".hidden", ""));
        fs::create_symlink("missing", place / "link");
        const auto entries = entriesOf(place);
        QVERIFY(entries);
        std::set<std::string> names;
        for (const fs::directory_entry& entry : *entries) names.insert(entry.path().filename().string());
        QCOMPARE(names, (std::set<std::string>{"a", ".hidden", "link"}));
        QVERIFY(isLink(place / "link"));
        QVERIFY(!isLink(place / "a") && !isLink(place / "missing"));
        QVERIFY(entriesOf(""));
    }
    void folderThatCannotBeReadIsAnError() {
        const QTemporaryDir temporary;
        const fs::path place = temporary.path().toStdString();
        QVERIFY(entriesOf(place / "missing").error().code == ErrorCode::NotFound);
        QVERIFY(writeFileAtomically(place / "a", ""));
        QVERIFY(!entriesOf(place / "a"));
    }
};

RUBBLE_TEST(FileErrorsTest)
#include "FileErrorsTest.moc"
