#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileLimits.h"

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
        const Status status = writeFileAtomically("/dev/full", "x");
        QCOMPARE(status.error().code, ErrorCode::Io);
        QCOMPARE(status.error().message, std::string("Cannot write \"/dev/full\": No space left on device."));
    }
    void deviceIsNotReplaced() {
        QVERIFY(writeFileAtomically("/dev/null", "x"));
        QVERIFY(fs::is_character_file("/dev/null"));
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
    void pipeIsReadToItsEnd() {
        int ends[2];
        QCOMPARE(::pipe(ends), 0);
        const std::string bytes(50000, 'x');
        QCOMPARE(::write(ends[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
        ::close(ends[1]);
        QCOMPARE(*readFile("/dev/fd/" + std::to_string(ends[0])), bytes);
        ::close(ends[0]);
    }
};

RUBBLE_TEST(AtomicFileTest)
#include "AtomicFileTest.moc"
