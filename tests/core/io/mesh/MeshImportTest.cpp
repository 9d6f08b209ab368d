#include "core/geometry/mesh/MeshWelding.h"
#include "core/io/mesh/MeshImport.h"
#include "tests/support/TestProgram.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>

using namespace rubble;

namespace {

const std::filesystem::path kMeshes = RUBBLE_SOURCE_DIR "/tests/data/meshes";

Result<SourceScene> imported(const std::filesystem::path& file) { return importMesh(file, RUBBLE_IMPORTER, {}); }

/// A program instead of the importer.
class FakeImporter {
public:
    explicit FakeImporter(const char* script) : m_path(m_folder.filePath("importer").toStdString()) {
        std::ofstream(m_path) << "#!/bin/sh\n" << script << '\n';
        std::filesystem::permissions(m_path, std::filesystem::perms::owner_all);
    }
    QString fault() const {
        return QString::fromStdString(importMesh(kMeshes / "wall.ply", m_path, {}).error().message);
    }

private:
    QTemporaryDir m_folder;
    std::filesystem::path m_path;
};

}  // namespace

class MeshImportTest : public QObject {
    Q_OBJECT
private slots:
    void everyFormatGivesTheSameWall_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<double>("metresPerUnit");
        QTest::newRow("glb") << "glb" << 1.0;
        QTest::newRow("gltf") << "gltf" << 1.0;
        QTest::newRow("obj") << "obj" << 0.0;
        QTest::newRow("fbx") << "fbx" << 0.01;
        QTest::newRow("stl") << "stl" << 0.0;
        QTest::newRow("ply") << "ply" << 0.0;
    }
    void everyFormatGivesTheSameWall() {
        QFETCH(QString, ending);
        QFETCH(double, metresPerUnit);
        const Result<SourceScene> scene = imported(kMeshes / ("wall." + ending.toStdString()));
        QVERIFY2(scene.hasValue(), scene ? "" : scene.error().message.c_str());
        QCOMPARE(scene->metresPerUnit, metresPerUnit);
        QCOMPARE(scene->objects.size(), std::size_t{1});
        QCOMPARE(scene->objects[0].triangles.size(), std::size_t{12});
        const Box3 box = boundsOf(TriangleMesh{scene->objects[0].points, {}});
        const double unit = metresPerUnit > 0.0 ? metresPerUnit : 1.0;
        QVERIFY(std::abs(box.diagonal() * unit - 1.5) < 1e-6);
    }
    void objectsMaterialsAndTexturesAreRead() {
        const Result<SourceScene> scene = imported(kMeshes / "textured.glb");
        QCOMPARE(scene->objects[0].name, std::string("Wall"));
        QVERIFY(scene->objects[0].hasUvs);
        QCOMPARE(scene->materials[0].name, std::string("Plaster"));
        QCOMPARE(scene->materials[1].name, std::string("Brick"));
        QVERIFY(glm::distance(scene->materials[0].colour, Vec3(0.955, 0.906, 0.584)) < 1e-12);
        QCOMPARE(imported(kMeshes / "pair.fbx")->objects.size(), std::size_t{2});
    }
    void contentIsRecognizedDespiteAWrongSuffix() {
        QTemporaryDir folder;
        const std::filesystem::path wrong = folder.filePath("wall.dat").toStdString();
        std::filesystem::copy(kMeshes / "wall.ply", wrong);
        QVERIFY(imported(wrong).hasValue());
    }
    void otherFilesAreRejected() {
        QTemporaryDir folder;
        const std::filesystem::path text = folder.filePath("text.ply").toStdString();
        std::ofstream(text) << "nothing of the kind\n";
        QVERIFY(imported(text).error().code == ErrorCode::Unsupported);
        QVERIFY(imported(text).error().message.starts_with("\"text.ply\" cannot be read as PLY: "));
        QCOMPARE(imported("none.obj").error().message,
                 std::string("Cannot read \"none.obj\": No such file or directory."));
        QVERIFY(imported(kMeshes).error().message.ends_with("Is a directory."));
    }
    void damagedFilesAreRejected() {
        QTemporaryDir folder;
        const auto fault = [&](const char* points, const char* face) {
            const std::filesystem::path file = folder.filePath("bad.ply").toStdString();
            std::ofstream(file) << "ply\nformat ascii 1.0\nelement vertex " << points
                                << "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                                   "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
                                << face << '\n';
            return QString::fromStdString(imported(file).error().message);
        };
        QCOMPARE(fault("3", "3 0 1 77777777"),
                 "\"bad.ply\" cannot be read as PLY: a face refers to point 77777777 of 3.");
        QCOMPARE(fault("4000000000", "3 0 1 2"),
                 "\"bad.ply\" cannot be read as PLY: the file ends in \"vertex\" 5 of 4000000000.");
    }
    /// Takes 100 MB on the disk and 1.5 GB of memory.
    void mostTrianglesOfAnStlFileAreRead() {
        if (!qEnvironmentVariableIsSet("RUBBLE_LONG"))
            QSKIP("Takes 1.5 GB of memory: set RUBBLE_LONG, as tools/test --all does.");
        QTemporaryDir folder;
        const auto stl = [&](std::uint32_t count) {
            const std::filesystem::path file = folder.filePath("grid.stl").toStdString();
            std::ofstream stream(file, std::ios::binary);
            stream << std::string(80, 'x');
            stream.write(reinterpret_cast<const char*>(&count), sizeof count);
            for (std::uint32_t k = 0; k < count; ++k) {
                const float x = static_cast<float>(k % 1500);
                const float y = static_cast<float>(k / 1500);
                const float values[12] = {0, 0, 1, x, y, 0, x + 1, y, 0, x, y + 1, 0};
                stream.write(reinterpret_cast<const char*>(values), sizeof values);
                stream.write("\0\0", 2);
            }
            return file;
        };
        const Result<SourceScene> most = imported(stl(2'000'000));
        QVERIFY2(most.hasValue(), most ? "" : most.error().message.c_str());
        QCOMPARE(most->objects[0].triangles.size(), std::size_t{2'000'000});
        QCOMPARE(imported(stl(2'000'001)).error().message,
                 std::string("\"grid.stl\" contains more than 2000000 triangles."));
    }
    void failureOfTheImporterIsAnError() {
        QCOMPARE(
            FakeImporter("kill -SEGV $$").fault(),
            "The importer crashed while reading \"wall.ply\" (signal 11). The file may be damaged or not supported "
            "by the reader.");
        QCOMPARE(FakeImporter("exit 3").fault(),
                 "\"wall.ply\" needs more than 2 GiB of memory; it is too large or damaged.");
        QCOMPARE(FakeImporter("echo 'It is blue.' >&2; exit 1").fault(), "It is blue.");
        QCOMPARE(FakeImporter("exit 1").fault(),
                 "\"wall.ply\" cannot be read: the mesh reader failed with exit status 1.");
        QCOMPARE(FakeImporter("echo rubble mesh 1").fault(),
                 "\"wall.ply\" cannot be read: the mesh reader returned invalid data.");
        QCOMPARE(FakeImporter("kill -XCPU $$").fault(),
                 "\"wall.ply\" takes longer than 30 s to read; it is too large or damaged.");
    }
    void messagesOfTheImporterAreShortLinesInUtf8() {
        QCOMPARE(FakeImporter("printf 'w\\344nde\\n' >&2; exit 1").fault(), "w?nde");
        QCOMPARE(FakeImporter("printf 'w\\303\\244nde\\033[1m\\nmore' >&2; exit 1").fault(),
                 QString::fromUtf8("w\u00e4nde?[1m"));
        const char* script = "head -c 999 /dev/zero | tr '\\0' a >&2; printf '\\303\\244bc' >&2; exit 1";
        QCOMPARE(FakeImporter(script).fault(), QString(999, 'a') + "...");  // not half of a character
    }
    void importerSeesNoEnvironment() {
        qputenv("RUBBLE_TEST_VARIABLE", "visible");
        QCOMPARE(FakeImporter("echo \"[$RUBBLE_TEST_VARIABLE]\" >&2; exit 1").fault(), "[]");
        qunsetenv("RUBBLE_TEST_VARIABLE");
    }
    void importerWritesNoFiles() {
        QTemporaryDir folder;
        const QString file = folder.filePath("written");
        FakeImporter(qPrintable("echo text > '" + file + "'")).fault();
        QCOMPARE(QFileInfo(file).size(), 0);
    }
    void importerOfTheCurrentFolderIsNotStarted() {
        QTemporaryDir folder;
        const std::filesystem::path here = std::filesystem::current_path();
        std::filesystem::current_path(folder.path().toStdString());
        std::ofstream("rubble-importer") << "#!/bin/sh\ntouch started\n";
        std::filesystem::permissions("rubble-importer", std::filesystem::perms::owner_all);
        const Result<SourceScene> scene = importMesh(kMeshes / "wall.ply", "rubble-importer", {});
        const bool isStarted = std::filesystem::exists("started");
        const std::filesystem::path withoutFolder = importerPath({}), ofCurrentFolder = importerPath(".");
        std::filesystem::current_path(here);
        QVERIFY(!isStarted);
        QCOMPARE(scene.error().message, std::string("Cannot start \"rubble-importer\": its folder is unknown."));
        QVERIFY(withoutFolder == "/usr/libexec/rubble/rubble-importer");
        QVERIFY(ofCurrentFolder.is_absolute());
    }
};

RUBBLE_TEST(MeshImportTest)
#include "MeshImportTest.moc"
