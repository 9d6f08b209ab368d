#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileLimits.h"

#include <sys/stat.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace rubble;

namespace {

namespace fs = std::filesystem;

std::size_t entryCount(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

class AtomicFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    fs::path inFolder(const char* name) const { return fs::path(m_folder.path().toStdString()) / name; }

private slots:
    void cleanup() {
        for (const fs::directory_entry& entry : fs::directory_iterator(inFolder(""))) fs::remove_all(entry);
    }
    void bytesRoundTrip() {
        const std::string bytes("a\0b\n", 4);
        QVERIFY(writeFileAtomically(inFolder("file"), bytes));
        QCOMPARE(*readFile(inFolder("file")), bytes);
        QVERIFY(writeFileAtomically(inFolder("file"), ""));
        QCOMPARE(*readFile(inFolder("file")), std::string());
        QCOMPARE(entryCount(inFolder("")), std::size_t{1});
    }
    void fileHashIsThatOfItsBytes() {
        for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{65536}, std::size_t{200001}}) {
            std::string bytes(size, 'x');
            for (std::size_t i = 0; i < size; i += 7) bytes[i] = static_cast<char>(i % 251);
            QVERIFY(writeFileAtomically(inFolder("file"), bytes));
            const FileHash file = hashOfFile(inFolder("file")).value();
            QCOMPARE(file.size, std::uint64_t{size});
            QCOMPARE(file.hash.hex(), contentHash(bytes).hex());
        }
        QCOMPARE(hashOfFile(inFolder("none")).error().code, ErrorCode::NotFound);
        QVERIFY(hashOfFile(inFolder("")).error().message.ends_with("Is a directory."));
    }
    void fullDiskKeepsTheOldFile() {
        QVERIFY(writeFileAtomically(inFolder("file"), "old"));
        const FileSizeLimit limit(1000);
        const Status status = writeFileAtomically(inFolder("file"), std::string(1001, 'x'));
        QCOMPARE(status.error().code, ErrorCode::Io);
        QCOMPARE(status.error().message, "Cannot write \"" + inFolder("file").string() + "\": File too large.");
        QCOMPARE(*readFile(inFolder("file")), std::string("old"));
        QCOMPARE(entryCount(inFolder("")), std::size_t{1});
    }
    void fullDeviceIsReported() {
        const Status status = writeFileOrStream("/dev/full", "x");
        QCOMPARE(status.error().code, ErrorCode::Io);
        QCOMPARE(status.error().message, std::string("Cannot write \"/dev/full\": No space left on device."));
    }
    void deviceIsNotReplaced() {
        QVERIFY(writeFileOrStream("/dev/null", "x"));
        QVERIFY(fs::is_character_file("/dev/null"));
        QCOMPARE(writeFileAtomically("/dev/null", "x").error().message,
                 std::string("Cannot write \"/dev/null\": it is a device, not a file."));
    }
    void folderInsteadOfAFileIsRejected() {
        fs::create_directory(inFolder("folder"));
        const Status status = writeFileAtomically(inFolder("folder"), "x");
        QCOMPARE(status.error().message, "Cannot write \"" + inFolder("folder").string() + "\": Is a directory.");
        QCOMPARE(entryCount(inFolder("")), std::size_t{1});
    }
    void missingFolderIsRejected() {
        const Status status = writeFileAtomically(inFolder("none/file"), "x");
        QCOMPARE(status.error().message,
                 "Cannot write \"" + inFolder("none/file").string() + "\": No such file or directory.");
    }
    void unwritableFolderIsRejected() {
        fs::permissions(inFolder(""), fs::perms(0755));
        fs::create_directory(inFolder("locked"));
        QVERIFY(writeFileAtomically(inFolder("locked/file"), "old"));
        fs::permissions(inFolder("locked/file"), fs::perms(0666));
        fs::permissions(inFolder("locked"), fs::perms(0555));
        {
            const AsNobody nobody;
            const Status status = writeFileAtomically(inFolder("locked/file"), "new");
            QCOMPARE(status.error().message,
                     "Cannot write \"" + inFolder("locked/file").string() + "\": Permission denied.");
            QCOMPARE(*readFile(inFolder("locked/file")), std::string("old"));
        }
        fs::permissions(inFolder("locked"), fs::perms(0755));
    }
    void protectedFileIsRejected() {
        fs::permissions(inFolder(""), fs::perms(0777));
        QVERIFY(writeFileAtomically(inFolder("file"), "old"));
        fs::permissions(inFolder("file"), fs::perms(0444));
        const AsNobody nobody;
        QCOMPARE(writeFileAtomically(inFolder("file"), "new").error().code, ErrorCode::Io);
        QCOMPARE(*readFile(inFolder("file")), std::string("old"));
    }
    void permissionsAndLinksAreKept() {
        QVERIFY(writeFileAtomically(inFolder("file"), "old"));
        fs::permissions(inFolder("file"), fs::perms(0660));
        fs::create_symlink("file", inFolder("link"));
        QVERIFY(writeFileAtomically(inFolder("link"), "new"));
        QVERIFY(fs::is_symlink(inFolder("link")));
        QCOMPARE(*readFile(inFolder("file")), std::string("new"));
        QCOMPARE(fs::status(inFolder("file")).permissions(), fs::perms(0660));
    }
    void missingFileIsNotFound() {
        const Result<std::string> read = readFile(inFolder("none"));
        QCOMPARE(read.error().code, ErrorCode::NotFound);
        QCOMPARE(read.error().message, "Cannot read \"" + inFolder("none").string() + "\": No such file or directory.");
    }
    void folderCannotBeRead() { QCOMPARE(readFile(inFolder("")).error().code, ErrorCode::Io); }
    void hugeFileIsRejected() {
        std::ofstream(inFolder("huge")).put('x');
        fs::resize_file(inFolder("huge"), (std::uintmax_t{1} << 30) + 1);  // a sparse file
        const Result<std::string> read = readFile(inFolder("huge"));
        QCOMPARE(read.error().code, ErrorCode::Limit);
        QCOMPARE(read.error().message, "Cannot read \"" + inFolder("huge").string() + "\": it is larger than 1 GiB.");
    }
    void pipesAndDevicesAreRefusedAtOnce() {
        QCOMPARE(::mkfifo(inFolder("pipe").c_str(), 0600), 0);
        QCOMPARE(readFile(inFolder("pipe")).error().message,
                 "Cannot read \"" + inFolder("pipe").string() + "\": it is a pipe, not a file.");
        QCOMPARE(writeFileAtomically(inFolder("pipe"), "x").error().message,
                 "Cannot write \"" + inFolder("pipe").string() + "\": it is a pipe, not a file.");
        QCOMPARE(readFile("/dev/zero").error().message,
                 std::string("Cannot read \"/dev/zero\": it is a device, not a file."));
    }
    void linkToAMissingFileStaysOne() {
        fs::create_symlink("file", inFolder("link"));
        QVERIFY(writeFileAtomically(inFolder("link"), "new"));
        QVERIFY(fs::is_symlink(inFolder("link")));
        QCOMPARE(*readFile(inFolder("file")), std::string("new"));
    }
    void hardLinksAreKept() {
        QVERIFY(writeFileAtomically(inFolder("file"), "longer than the new one"));
        fs::create_hard_link(inFolder("file"), inFolder("other"));
        QVERIFY(writeFileAtomically(inFolder("file"), "new"));
        QCOMPARE(*readFile(inFolder("other")), std::string("new"));
        QCOMPARE(entryCount(inFolder("")), std::size_t{2});
    }
    void fullDiskKeepsAFileWithHardLinks() {
        QVERIFY(writeFileAtomically(inFolder("file"), "old"));
        fs::create_hard_link(inFolder("file"), inFolder("other"));
        const FileSizeLimit limit(1000);
        QVERIFY(!writeFileAtomically(inFolder("file"), std::string(1001, 'x')));
        QCOMPARE(*readFile(inFolder("other")), std::string("old"));
        QCOMPARE(entryCount(inFolder("")), std::size_t{2});
    }
    void copyOfAnInterruptedSaveIsKept() {
        const std::string torn("\0orn", 4);
        QVERIFY(writeFileAtomically(inFolder("file"), torn));
        QVERIFY(isInterruptedSave(torn) && !isInterruptedSave("new") && !isInterruptedSave(""));
        fs::create_hard_link(inFolder("file"), inFolder("other"));
        QVERIFY(writeFileAtomically(copyBeforeSave(inFolder("file")), "old"));
        const QString reported = QString::fromStdString(writeFileAtomically(inFolder("file"), "new").error().message);
        QVERIFY2(
            reported.contains("Saving it was interrupted; \"" + QString(inFolder("file.before-save").c_str()) + '"'),
            qPrintable(reported));
        const QString byLink = QString::fromStdString(writeFileAtomically(inFolder("other"), "new").error().message);
        QVERIFY2(byLink.contains("look beside its hard links"), qPrintable(byLink));
        QCOMPARE(*readFile(copyBeforeSave(inFolder("file"))), std::string("old"));
        QCOMPARE(*readFile(inFolder("file")), torn);
    }
    void copyOfAFileThatIsWholeIsReplaced() {
        QVERIFY(writeFileAtomically(inFolder("file"), "old"));
        fs::create_hard_link(inFolder("file"), inFolder("other"));
        QVERIFY(writeFileAtomically(copyBeforeSave(inFolder("file")), "older"));
        QVERIFY(writeFileAtomically(inFolder("file"), "new"));
        QCOMPARE(*readFile(inFolder("other")), std::string("new"));
        QCOMPARE(entryCount(inFolder("")), std::size_t{2});
    }
    void longNamesAreWrittenInPlace() {
        const fs::path longest = inFolder("") / (std::string(248, 'x') + ".rubble");
        QVERIFY(writeFileAtomically(longest, "old"));
        fs::create_hard_link(longest, inFolder("other"));
        QVERIFY(writeFileAtomically(longest, "new"));
        QCOMPARE(*readFile(inFolder("other")), std::string("new"));
        QCOMPARE(entryCount(inFolder("")), std::size_t{2});
    }
    void ownerIsKept() {
        if (::geteuid() != 0) QSKIP("Only root can give files away.");
        QVERIFY(writeFileAtomically(inFolder("file"), "old"));
        QCOMPARE(::chown(inFolder("file").c_str(), 1234, 4321), 0);
        QVERIFY(writeFileAtomically(inFolder("file"), "new"));
        struct stat status {};
        QCOMPARE(::stat(inFolder("file").c_str(), &status), 0);
        QCOMPARE(status.st_uid, uid_t{1234});
        QCOMPARE(status.st_gid, gid_t{4321});
    }
    void ownerThatCannotBeGivenIsKept() {
        if (::geteuid() != 0) QSKIP("Only root can make a file of another user.");
        fs::permissions(inFolder(""), fs::perms(0777));
        QVERIFY(writeFileAtomically(inFolder("file"), "old"));
        fs::permissions(inFolder("file"), fs::perms(0666));
        struct stat status {};
        {
            const AsNobody nobody;
            QVERIFY(writeFileAtomically(inFolder("file"), "new"));
        }
        QCOMPARE(::stat(inFolder("file").c_str(), &status), 0);
        QCOMPARE(status.st_uid, uid_t{0});
        QCOMPARE(*readFile(inFolder("file")), std::string("new"));
        QCOMPARE(entryCount(inFolder("")), std::size_t{1});
    }
};

RUBBLE_TEST(AtomicFileTest)
#include "AtomicFileTest.moc"
