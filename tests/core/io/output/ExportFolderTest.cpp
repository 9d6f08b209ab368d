#include "core/io/output/ExportFolder.h"

#include "core/io/output/ExportCheck.h"
#include "core/io/output/ExportManifest.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileLimits.h"
#include "tests/support/files/FolderNames.h"

#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <vector>

using namespace rubble;
namespace fs = std::filesystem;

namespace {

const ContentHash kFirst = contentHash("first");
const ContentHash kSecond = contentHash("second");
const std::vector<ExportFile> kFiles = {{"wall.obj", "v 0 0 0\n"}, {"wall.mtl", "newmtl a\n"}};

using Names = std::vector<std::string>;

}  // namespace

class ExportFolderTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_place = m_temporary->path().toStdString();
        m_pack = m_place / "packs" / "wall";
    }

    void everyFileIsWrittenWithTheManifest() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QCOMPARE(namesIn(m_pack), (Names{"manifest.json", "wall.mtl", "wall.obj"}));
        QCOMPARE(*readFile(m_pack / "wall.obj"), std::string("v 0 0 0\n"));
        QCOMPARE(namesIn(m_place / "packs"), Names{"wall"});
    }

    void exportReplacesAnEarlierOne() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(writeExportFolder(m_pack, kSecond, std::vector<ExportFile>{{"wall.glb", "glTF"}}));
        QCOMPARE(namesIn(m_pack), (Names{"manifest.json", "wall.glb"}));
        QCOMPARE(namesIn(m_place / "packs"), Names{"wall"});
        QVERIFY(isExportOf(m_pack, kSecond));
    }

    void checkSaysWhatWritingWouldDo() {
        QVERIFY(checkExportFolder(m_pack));
        QVERIFY(!fs::exists(m_place / "packs"));
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(checkExportFolder(m_pack));
        QVERIFY(writeFileAtomically(m_pack / "wall.obj", "edited"));
        QCOMPARE(checkExportFolder(m_pack).error().code, ErrorCode::Edited);
        QVERIFY(checkExportFolder(m_pack, EditedFiles::Replaced));
        QVERIFY(writeFileAtomically(m_pack / "notes.txt", "mine"));
        QCOMPARE(checkExportFolder(m_pack, EditedFiles::Replaced).error().code, ErrorCode::BadInput);
        QCOMPARE(namesIn(m_pack), (Names{"manifest.json", "notes.txt", "wall.mtl", "wall.obj"}));
    }
    void unmodifiedExportsAreRemoved() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(writeFileAtomically(m_pack / "wall.obj.import", "of Godot"));
        fs::remove(m_pack / "wall.mtl");  // nothing is lost
        QVERIFY(checkRemovable(m_pack));
        QVERIFY(fs::exists(m_pack));
        QVERIFY(removeExportFolder(m_pack));
        QCOMPARE(namesIn(m_place / "packs"), Names{});
    }
    void modifiedExportsAreNotRemoved_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("edited") << "wall.obj";
        QTest::newRow("added") << "notes.txt";
        QTest::newRow("no manifest") << "manifest.json";
    }
    void modifiedExportsAreNotRemoved() {
        QFETCH(const QString, file);
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(writeFileAtomically(m_pack / file.toStdString(), "mine"));
        const Names before = namesIn(m_pack);
        QCOMPARE(checkRemovable(m_pack).error().code, ErrorCode::Edited);
        const Status removed = removeExportFolder(m_pack);
        QCOMPARE(removed.error().code, ErrorCode::Edited);
        QVERIFY2(removed.error().message.find(" is not removed: ") != std::string::npos,
                 removed.error().message.c_str());
        QCOMPARE(namesIn(m_pack), before);
        QCOMPARE(namesIn(m_place / "packs"), Names{"wall"});
    }
    void linksToExportsAreNotRemoved() {
        QVERIFY(writeExportFolder(m_place / "elsewhere", kFirst, kFiles));
        fs::create_directory(m_place / "packs");
        fs::create_directory_symlink(m_place / "elsewhere", m_pack);
        QCOMPARE(removeExportFolder(m_pack).error().code, ErrorCode::BadInput);
        QVERIFY(fs::is_symlink(m_pack) && isExportOf(m_place / "elsewhere", kFirst));
    }

    void unexpectedFilesAreNeverReplaced() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(writeFileAtomically(m_pack / "notes.txt", "mine"));
        const Status status = writeExportFolder(m_pack, kSecond, kFiles);
        QCOMPARE(status.error().code, ErrorCode::BadInput);
        QCOMPARE(status.error().message,
                 "The folder \"" + m_pack.string() +
                     "\" contains \"notes.txt\", which is not part of an export; move it first or "
                     "export elsewhere.");
        QCOMPARE(*readFile(m_pack / "notes.txt"), std::string("mine"));
        QCOMPARE(namesIn(m_place / "packs"), Names{"wall"});
    }

    void editedFilesAreKept() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(writeFileAtomically(m_pack / "wall.obj", "mine"));
        const Status status = writeExportFolder(m_pack, kSecond, kFiles);
        QCOMPARE(status.error().code, ErrorCode::Edited);
        QCOMPARE(status.error().message, "\"" + (m_pack / "wall.obj").string() +
                                             "\" was modified after the export and would be lost; move it first or "
                                             "export elsewhere.");
        QCOMPARE(*readFile(m_pack / "wall.obj"), std::string("mine"));
        QVERIFY(writeExportFolder(m_pack, kSecond, kFiles, EditedFiles::Replaced));
        QVERIFY(isExportOf(m_pack, kSecond));
    }

    void filesOfEnginesAreKept() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        for (const char* name : {"wall.obj.import", "wall.obj.uid", "wall.mtl.meta"})
            QVERIFY(writeFileAtomically(m_pack / name, name));
        QVERIFY(isExportOf(m_pack, kFirst));
        QCOMPARE(verifyExportFolder(m_pack).value_or(""), std::string());
        QVERIFY(writeExportFolder(m_pack, kSecond, kFiles));
        QVERIFY(isExportOf(m_pack, kSecond));
        for (const char* name : {"wall.obj.import", "wall.obj.uid", "wall.mtl.meta"})
            QCOMPARE(*readFile(m_pack / name), std::string(name));
        fs::create_directory(m_pack / "folder.meta");
        QVERIFY(!writeExportFolder(m_pack, kFirst, kFiles));
    }

    void linkToAFolderStaysOne() {
        const fs::path real = m_place / "elsewhere" / "real";
        QVERIFY(writeExportFolder(real, kFirst, kFiles));
        fs::create_directories(m_pack.parent_path());
        fs::create_directory_symlink(real, m_pack);
        QVERIFY(writeExportFolder(m_pack, kSecond, kFiles));
        QVERIFY(fs::is_symlink(m_pack));
        QVERIFY(isExportOf(real, kSecond));
        QCOMPARE(namesIn(m_place / "elsewhere"), Names{"real"});
        QCOMPARE(namesIn(m_pack.parent_path()), Names{"wall"});
    }

    void permissionsOfTheFolderAreKept() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        fs::permissions(m_pack, fs::perms(0750));
        QVERIFY(writeExportFolder(m_pack, kSecond, kFiles));
        QCOMPARE(fs::status(m_pack).permissions(), fs::perms(0750));
    }

    void permissionsOfFilesAreKept() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        fs::permissions(m_pack / "wall.obj", fs::perms(0600));
        fs::permissions(m_pack / kManifestName, fs::perms(0640));
        QVERIFY(writeExportFolder(m_pack, kSecond, kFiles));
        QCOMPARE(fs::status(m_pack / "wall.obj").permissions(), fs::perms(0600));
        QCOMPARE(fs::status(m_pack / kManifestName).permissions(), fs::perms(0640));
    }

    void newFolderHasThePermissionsOfTheUser() {
        const mode_t before = ::umask(027);
        const Status written = writeExportFolder(m_pack, kFirst, kFiles);
        ::umask(before);
        QVERIFY(written);
        QCOMPARE(fs::status(m_pack).permissions(), fs::perms(0750));
        QCOMPARE(fs::status(m_pack / "wall.obj").permissions(), fs::perms(0640));
    }

    void ownerAndGroupAreKept() {
        if (::geteuid() != 0) QSKIP("Only root can give files away.");
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QCOMPARE(::chown(m_pack.c_str(), 1234, 4321), 0);
        QCOMPARE(::chown((m_pack / "wall.obj").c_str(), 1235, 4322), 0);
        std::vector<ExportFile> files = kFiles;
        files.push_back({"new.obj", "v 1 1 1\n"});
        QVERIFY(writeExportFolder(m_pack, kSecond, files));
        QCOMPARE(ownerOf(m_pack), (std::pair<uid_t, gid_t>{1234, 4321}));
        QCOMPARE(ownerOf(m_pack / "wall.obj"), (std::pair<uid_t, gid_t>{1235, 4322}));
        QCOMPARE(ownerOf(m_pack / "new.obj"), (std::pair<uid_t, gid_t>{1234, 4321}));
    }

    void protectedPackIsNotReplaced_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("permissions");
        QTest::newRow("folder") << "" << 0555;
        QTest::newRow("file") << "wall.obj" << 0444;
    }
    void protectedPackIsNotReplaced() {
        QFETCH(QString, name);
        QFETCH(int, permissions);
        fs::permissions(m_place, fs::perms(0777));
        fs::create_directory(m_place / "packs");
        fs::permissions(m_place / "packs", fs::perms(0777));
        const fs::path path = name.isEmpty() ? m_pack : m_pack / name.toStdString();
        {
            const AsNobody nobody;
            QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
            fs::permissions(path, fs::perms(permissions));
            QCOMPARE(writeExportFolder(m_pack, kSecond, kFiles).error().message,
                     "Cannot write \"" + path.string() + "\": Permission denied.");
            QVERIFY(isExportOf(m_pack, kFirst));
            fs::permissions(path, fs::perms(0777));
        }
        QCOMPARE(namesIn(m_place / "packs"), Names{"wall"});
    }

    void leftoversBesideTheTargetOfALinkAreRemoved() {
        const fs::path real = m_place / "elsewhere" / "real";
        QVERIFY(writeExportFolder(real, kFirst, kFiles));
        fs::create_directories(m_pack.parent_path());
        fs::create_directory_symlink(real, m_pack);
        QVERIFY(writeFileAtomically(m_place / "elsewhere" / ".rubble-1-0123456789abcdef.tmp", "x"));
        fs::create_directory(m_place / "elsewhere" / ".rubble-1-1123456789abcdef.old");
        fs::rename(real, m_place / "elsewhere" / ".rubble-1-1123456789abcdef.old" / "real");
        QVERIFY(writeExportFolder(m_pack, kSecond, kFiles));
        QVERIFY(isExportOf(real, kSecond));
        QCOMPARE(namesIn(m_place / "elsewhere"), Names{"real"});
    }

    void emptyFolderIsReplacedAndFileIsNot() {
        fs::create_directories(m_pack);
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        const fs::path file = m_place / "file";
        QVERIFY(writeFileAtomically(file, "mine"));
        QCOMPARE(writeExportFolder(file, kFirst, kFiles).error().code, ErrorCode::BadInput);
        QCOMPARE(writeExportFolder(file / "below", kFirst, kFiles).error().code, ErrorCode::Io);
    }

    void cancellingKeepsTheEarlierExport() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(writeExportFolder(m_pack, kSecond, kFiles, EditedFiles::Kept, task).error().code,
                 ErrorCode::Cancelled);
        QVERIFY(isExportOf(m_pack, kFirst));
        QCOMPARE(namesIn(m_place / "packs"), Names{"wall"});
    }

    void cancellingRemovesCreatedFolders() {
        TaskContext task;
        task.cancel.cancel();
        fs::create_directory(m_place / "there");
        QVERIFY(
            !writeExportFolder(m_place / "there" / "deep" / "packs" / "wall", kFirst, kFiles, EditedFiles::Kept, task));
        QCOMPARE(namesIn(m_place), Names{"there"});
        QCOMPARE(namesIn(m_place / "there"), Names{});
    }

    void fullDiskKeepsTheEarlierExport() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit before{};
        QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
        const rlimit small{4096, before.rlim_max};
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
        const Status status =
            writeExportFolder(m_pack, kSecond, std::vector<ExportFile>{{"wall.obj", std::string(5000, 'v')}});
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
        QCOMPARE(status.error().code, ErrorCode::Io);
        QVERIFY(status.error().message.ends_with("wall.obj\": File too large."));
        QVERIFY(isExportOf(m_pack, kFirst));
        QCOMPARE(namesIn(m_place / "packs"), Names{"wall"});
    }

    void readOnlyFolderIsAnError() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QCOMPARE(chmod(m_place.c_str(), 0755), 0);
        QCOMPARE(chmod(m_pack.parent_path().c_str(), 0555), 0);
        const uid_t user = geteuid();
        if (user == 0) QCOMPARE(seteuid(65534), 0);  // root may write anywhere; become nobody
        const Status status = writeExportFolder(m_pack, kSecond, kFiles);
        if (user == 0) QCOMPARE(seteuid(user), 0);
        QCOMPARE(chmod(m_pack.parent_path().c_str(), 0755), 0);
        QCOMPARE(status.error().message,
                 "Cannot write into \"" + m_pack.parent_path().string() + "\": Permission denied.");
        QVERIFY(isExportOf(m_pack, kFirst));
    }

private:
    static std::pair<uid_t, gid_t> ownerOf(const fs::path& path) {
        struct stat status {};
        return ::stat(path.c_str(), &status) == 0 ? std::pair(status.st_uid, status.st_gid) : std::pair<uid_t, gid_t>();
    }

    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_place;
    fs::path m_pack;
};

RUBBLE_TEST(ExportFolderTest)
#include "ExportFolderTest.moc"
