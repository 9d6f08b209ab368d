// Tests app/importer/files/MeshFiles.cpp, which files the importer opens for a mesh, with
// app/importer/files/PercentEncoding.cpp and app/importer/files/TextEncoding.cpp.
#include "core/io/mesh/MeshImport.h"
#include "core/io/system/ChildProcess.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

using namespace rubble;

namespace {

/// A folder with a mesh in it, in a folder with other files.
class Folder {
public:
    Folder() {
        std::filesystem::create_directories(path("sub"));
        const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        std::string bytes(sizeof corners, '\0');
        std::memcpy(bytes.data(), corners, sizeof corners);
        for (const char* name : {"inside.bin", "sub/deep.bin", "../outside.bin"}) write(name, bytes);
        std::filesystem::create_symlink("../outside.bin", path("out.bin"));
        std::filesystem::create_symlink("sub/deep.bin", path("in.bin"));
        ::mkfifo(path("fifo.bin").c_str(), 0600);
    }
    std::filesystem::path path(const std::string& name) const { return m_root.path().toStdString() + "/mesh/" + name; }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    /// Writes a triangle whose corners are in another file.
    std::filesystem::path writeGltf(const std::string& buffer) const {
        return write("wall.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + buffer +
                                      R"(","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],
            "scenes":[{"nodes":[0]}],"scene":0})");
    }

private:
    QTemporaryDir m_root;
};

Result<SourceScene> imported(const std::filesystem::path& file) { return importMesh(file, RUBBLE_IMPORTER, {}); }

/// The importer's own log of the files that it opened and refused.
QString logOf(const std::filesystem::path& file) {
    return QString::fromStdString(runChild(RUBBLE_IMPORTER, {"--log-files", file.string()}, {}, {})->error);
}

/// Runs the importer, with its log, on a kernel where a system call fails.
ProgramOutcome withFailingCall(int call, int code, const std::filesystem::path& file) {
    QProcessEnvironment environment;
    environment.insert("LD_PRELOAD", RUBBLE_FAULTS);
    environment.insert("RUBBLE_FAULT_SYSTEM_CALL", QString::number(call));
    environment.insert("RUBBLE_FAULT_CODE", QString::number(code));
    return runProgram(RUBBLE_IMPORTER, {"--log-files", QString::fromStdString(file.string())},
                      {.environment = environment});
}

/// ASCII as UTF-16 with a byte order mark.
std::string utf16(const std::string& text, bool isBigEndian) {
    std::string bytes = isBigEndian ? "\xfe\xff" : "\xff\xfe";
    for (const char letter : text) bytes += isBigEndian ? std::string{'\0', letter} : std::string{letter, '\0'};
    return bytes;
}

}  // namespace

class MeshFilesTest : public QObject {
    Q_OBJECT
private slots:
    void filesInTheFolderAndBelowAreRead_data() {
        QTest::addColumn<QString>("buffer");
        for (const char* buffer : {"inside.bin", "./inside.bin", "sub/deep.bin", "sub/../inside.bin", "in.bin"})
            QTest::newRow(buffer) << buffer;
    }
    void filesInTheFolderAndBelowAreRead() {
        QFETCH(const QString, buffer);
        const Folder folder;
        const std::filesystem::path mesh = folder.writeGltf(buffer.toStdString());
        const Result<SourceScene> scene = imported(mesh);
        QVERIFY2(scene.hasValue(), scene ? "" : scene.error().message.c_str());
        QVERIFY(logOf(mesh).contains("opened " + buffer + '\n'));
    }
    void filesOutsideAreRefusedByName_data() {
        QTest::addColumn<QString>("buffer");
        for (const char* buffer : {"../outside.bin", "../../../../../../etc/passwd", "/etc/passwd",
                                   "sub/../../outside.bin", "/proc/self/environ", "file:///etc/passwd"})
            QTest::newRow(buffer) << buffer;
    }
    void filesOutsideAreRefusedByName() {
        QFETCH(const QString, buffer);
        const Folder folder;
        const std::filesystem::path mesh = folder.writeGltf(buffer.toStdString());
        QCOMPARE(QString::fromStdString(imported(mesh).error().message),
                 "\"wall.gltf\" refers to \"" + buffer +
                     "\", which lies outside its folder; only files in the folder of a mesh and below are read.");
        QVERIFY(logOf(mesh).contains("refused " + buffer + '\n'));
        QVERIFY(!logOf(mesh).contains("opened " + buffer));
    }
    void escapedNamesOutsideAreRefused_data() {
        QTest::addColumn<QString>("buffer");
        QTest::addColumn<QString>("decoded");
        QTest::newRow("slash") << "..%2Foutside.bin"
                               << "../outside.bin";
        QTest::newRow("dots") << "%2e%2e/outside.bin"
                              << "../outside.bin";
        QTest::newRow("root") << "%2Fetc%2Fpasswd"
                              << "/etc/passwd";
        QTest::newRow("link") << "sub%2F..%2Fout.bin"
                              << "sub/../out.bin";
    }
    void escapedNamesOutsideAreRefused() {
        QFETCH(const QString, buffer);
        QFETCH(const QString, decoded);
        const Folder folder;
        const std::filesystem::path mesh = folder.writeGltf(buffer.toStdString());
        const QString message = QString::fromStdString(imported(mesh).error().message);
        QVERIFY2(message.startsWith("\"wall.gltf\" refers to \"" + buffer + "\", "), qPrintable(message));
        const QString log = logOf(mesh);
        QVERIFY2(log.contains("refused " + decoded + '\n') && !log.contains("outside.bin\nopened"), qPrintable(log));
        QCOMPARE(log.count("opened "), 1);  // the mesh
    }
    /// Each sentence is true whether the kernel has openat2 or not.
    void linksAreRefusedWithTheirReason_data() {
        QTest::addColumn<QString>("buffer");
        QTest::addColumn<QString>("reason");
        const QString absolute =
            "a link that is absolute or leads out of its folder; only relative links within the folder of a mesh are "
            "followed.";
        QTest::newRow("out") << "out.bin" << absolute;
        QTest::newRow("absolute inside") << "absolute.bin" << absolute;
        QTest::newRow("absolute folder inside") << "absolute/deep.bin" << absolute;
        QTest::newRow("loop") << "loop.bin"
                              << "a link that leads back to itself.";
        QTest::newRow("loop of two") << "loop-1.bin"
                                     << "a link that leads back to itself.";
    }
    void linksAreRefusedWithTheirReason() {
        QFETCH(const QString, buffer);
        QFETCH(const QString, reason);
        const Folder folder;
        std::filesystem::create_symlink(folder.path("sub/deep.bin"), folder.path("absolute.bin"));
        std::filesystem::create_directory_symlink(folder.path("sub"), folder.path("absolute"));
        std::filesystem::create_symlink("loop.bin", folder.path("loop.bin"));
        std::filesystem::create_symlink("loop-2.bin", folder.path("loop-1.bin"));
        std::filesystem::create_symlink("loop-1.bin", folder.path("loop-2.bin"));
        const std::filesystem::path mesh = folder.writeGltf(buffer.toStdString());
        const bool areFollowed = imported(folder.writeGltf("in.bin")).hasValue();
        const QString expected = areFollowed ? reason : "a link; this system cannot follow links within a folder only.";
        folder.writeGltf(buffer.toStdString());
        QCOMPARE(QString::fromStdString(imported(mesh).error().message),
                 "\"wall.gltf\" refers to \"" + buffer + "\", " + expected);
        QVERIFY(logOf(mesh).contains("refused " + buffer + '\n'));
    }
    void withoutOpenat2LinksAreRefused_data() {
        QTest::addColumn<QString>("buffer");
        QTest::addColumn<bool>("isRefused");
        QTest::newRow("file") << "sub/deep.bin" << false;
        QTest::newRow("link") << "in.bin" << true;
        QTest::newRow("linked folder") << "linked/deep.bin" << true;
        QTest::newRow("outside") << "../outside.bin" << true;
        QTest::newRow("file as a folder") << "inside.bin/deep.bin" << false;
    }
    void withoutOpenat2LinksAreRefused() {
        QFETCH(const QString, buffer);
        QFETCH(const bool, isRefused);
        const Folder folder;
        std::filesystem::create_directory_symlink("sub", folder.path("linked"));
        const QString log = withFailingCall(SYS_openat2, ENOSYS, folder.writeGltf(buffer.toStdString())).error;
        QCOMPARE(log.contains("refused " + buffer + '\n'), isRefused);
        QCOMPARE(log.contains("opened " + buffer + '\n'), buffer == "sub/deep.bin");
    }
    void nothingIsReadOutsideOfTheSandbox_data() {
        QTest::addColumn<int>("call");
        QTest::addColumn<QString>("part");
        QTest::newRow("seccomp") << int{SYS_seccomp} << "seccomp";
        QTest::newRow("Landlock") << int{SYS_landlock_restrict_self} << "Landlock";
    }
    void nothingIsReadOutsideOfTheSandbox() {
        QFETCH(const int, call);
        QFETCH(const QString, part);
        const QString has = runProgram(RUBBLE_IMPORTER, {"--sandbox"}).output;
        if (has.contains(part + ": none")) QSKIP("The kernel lacks it.");
        const Folder folder;
        const ProgramOutcome outcome = withFailingCall(call, ENOMEM, folder.writeGltf("inside.bin"));
        QCOMPARE(outcome.exit, 1);
        QCOMPARE(outcome.error,
                 "\"wall.gltf\" was not read: " + part + " cannot be put in force: Cannot allocate memory.\n");
    }
    void kernelsWithoutSeccompOrLandlockReadMeshes_data() {
        QTest::addColumn<int>("call");
        QTest::addColumn<int>("code");
        QTest::newRow("seccomp") << int{SYS_seccomp} << EINVAL;
        QTest::newRow("Landlock") << int{SYS_landlock_create_ruleset} << ENOSYS;
        QTest::newRow("Landlock turned off") << int{SYS_landlock_create_ruleset} << EOPNOTSUPP;
    }
    void kernelsWithoutSeccompOrLandlockReadMeshes() {
        QFETCH(const int, call);
        QFETCH(const int, code);
        const Folder folder;
        const ProgramOutcome outcome = withFailingCall(call, code, folder.writeGltf("inside.bin"));
        QCOMPARE(outcome.exit, 0);
        QVERIFY(outcome.error.contains("opened inside.bin\n"));
    }
    void fifoIsNotOpened() {
        const Folder folder;
        const std::filesystem::path mesh = folder.writeGltf("fifo.bin");
        QCOMPARE(imported(mesh).error().message,
                 std::string("\"wall.gltf\" refers to \"fifo.bin\", which is no file that can be read."));
        QVERIFY(!logOf(mesh).contains("opened fifo.bin"));
    }
    void unreadMaterialFileIsNoted() {
        const Folder folder;
        const Result<SourceScene> scene =
            imported(folder.write("wall.obj", "mtllib ../outside.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        QCOMPARE(scene->notes.size(), std::size_t{1});
        QCOMPARE(scene->notes[0],
                 std::string("The file refers to \"../outside.mtl\", which lies outside its folder; only "
                             "files in the folder of a mesh and below are read."));
    }
    void meshMayBeALink() {
        const Folder folder;
        std::filesystem::rename(folder.writeGltf("inside.bin"), folder.path("../elsewhere.gltf"));
        std::filesystem::create_symlink("../elsewhere.gltf", folder.path("linked.gltf"));
        QVERIFY(imported(folder.path("linked.gltf")).hasValue());
    }
    void utf16AndByteOrderMarksAreRead() {
        const Folder folder;
        const std::string obj = "mtllib wall.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl Brick\nf 1 2 3\n";
        const std::string mtl = "newmtl Brick\nKd 1 0 0\n";
        const auto isRead = [&](const std::string& objBytes, const std::string& mtlBytes) {
            folder.write("wall.mtl", mtlBytes);
            const Result<SourceScene> scene = imported(folder.write("wall.obj", objBytes));
            return scene && scene->objects[0].points[1] == Vec3(1, 0, 0) &&
                   scene->materials[scene->objects[0].triangles[0].material].name == "Brick";
        };
        QVERIFY(isRead(obj, mtl));
        QVERIFY(isRead(utf16(obj, false), utf16(mtl, true)));
        QVERIFY(isRead(utf16(obj, true), mtl));
        QVERIFY(isRead("\xef\xbb\xbf" + obj, "\xef\xbb\xbf" + mtl));
    }
    void binaryPlyMayBeginWithALineFeed() {
        // assimp alone crashes on it.
        const Folder folder;
        std::string ply =
            "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
        ply += std::string("\n\0\0\x3f", 4) + std::string(8, '\0');  // x is slightly above 0.5
        ply += std::string("\0\0\x80\x3f", 4) + std::string(8, '\0');
        ply += std::string(4, '\0') + std::string("\0\0\x80\x3f", 4) + std::string(4, '\0');
        ply += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
        const Result<SourceScene> scene = imported(folder.write("wall.ply", ply));
        QVERIFY2(scene.hasValue(), scene ? "" : scene.error().message.c_str());
        QCOMPARE(scene->objects[0].triangles.size(), std::size_t{1});
        QVERIFY(std::abs(scene->objects[0].points[0].x - 0.5) < 1e-6);
        QVERIFY(scene->objects[0].points[1] == Vec3(1, 0, 0) && scene->objects[0].points[2] == Vec3(0, 1, 0));
    }
    void otherFormatsAreRefusedWithoutPaths() {
        const Folder folder;
        for (const char* name : {"cube.dae", "cube.3ds"}) {
            const std::string message = imported(folder.write(name, "<COLLADA/>")).error().message;
            QCOMPARE(message, "\"" + std::string(name) + "\" is not an OBJ, glTF, GLB, FBX, STL or PLY file.");
        }
        const std::string empty = imported(folder.write("empty.ply", "")).error().message;
        QVERIFY2(empty.find("/mesh") == std::string::npos, empty.c_str());
    }
};

RUBBLE_TEST(MeshFilesTest)
#include "MeshFilesTest.moc"
