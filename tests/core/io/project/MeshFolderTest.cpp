// Tests core/io/project/MeshFolder.cpp, and projects with meshes in core/io/project/ProjectFile.cpp and
// core/io/project/AssetJson.cpp.
#include "core/io/project/MeshFolder.h"

#include "core/io/project/MeshFile.h"
#include "core/io/project/ProjectDifference.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectJournal.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshProjects.h"
#include "tests/support/files/FileLimits.h"
#include "tests/support/files/JsonMutations.h"
#include "tests/support/files/Schemas.h"

#include <nlohmann/json.hpp>

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace rubble;
using test::meshProject;

namespace {

namespace fs = std::filesystem;

ContentHash meshHash(const Project& project) { return project.assets[1].mesh()->hash; }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

class MeshFolderTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    fs::path inFolder(const fs::path& name) const { return fs::path(m_folder->path().toStdString()) / name; }
    fs::path meshFile(const Project& project, const fs::path& name = "house.rubble") const {
        return meshPath(meshFolderOf(inFolder(name)), meshHash(project));
    }

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void foldersLieBesideTheProject() {
        QCOMPARE(meshFolderOf("a/house.rubble"), fs::path("a/house.rubble.meshes"));
        fs::create_symlink("other/house.rubble", inFolder("link.rubble"));
        QCOMPARE(meshFolderOf(inFolder("link.rubble")), inFolder("other/house.rubble.meshes"));
        QVERIFY(isInMeshFolder("a/house.rubble.meshes/wall.glb"));
        QVERIFY(!isInMeshFolder("a/house.meshes/wall.glb") && !isInMeshFolder("house.rubble.meshes"));
    }
    void projectsComeBackWithTheirMeshes() {
        const Project project = meshProject();
        QVERIFY(saveProject(inFolder("house.rubble"), project));
        const Result<Project> read = loadProject(inFolder("house.rubble"));
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QVERIFY(*read == project && read->assets[1].mesh()->mesh.triangles == project.assets[1].mesh()->mesh.triangles);
        QCOMPARE(projectText(*read), projectText(project));
        QCOMPARE(*readFile(inFolder("house.rubble")), projectText(project));
        const std::string line =
            "      \"mesh\": {\"hash\": \"" + meshHash(project).hex() + "\", \"points\": 32, \"triangles\": 60},\n";
        QVERIFY2(contains(projectText(project), line), projectText(project).c_str());
    }
    void equalMeshesAreReadOnce() {
        Project project = meshProject();
        Asset second = project.assets[1];
        second.id = 60;
        second.name = "copy";
        second.pattern.layers[0].id = 61;
        project.assets.push_back(second);
        QVERIFY(saveProject(inFolder("house.rubble"), project));
        const Result<Project> read = loadProject(inFolder("house.rubble"));
        QVERIFY(read && read->assets[1].mesh() == read->assets[2].mesh());
    }
    void onlyProjectsWithMeshesAreOfVersion6() {
        Project project = meshProject();
        QCOMPARE(nlohmann::json::parse(projectText(project))["version"].get<int>(), 6);
        project.assets.pop_back();
        QCOMPARE(nlohmann::json::parse(projectText(project))["version"].get<int>(), 5);
        QVERIFY(saveProject(inFolder("house.rubble"), project));
        QVERIFY(!fs::exists(meshFolderOf(inFolder("house.rubble"))));
        nlohmann::json json = nlohmann::json::parse(projectText(project));
        json["version"] = 6;
        QVERIFY(*readProjectText(json.dump()) == project);
        json = nlohmann::json::parse(projectText(meshProject()));
        json["version"] = 5;
        QCOMPARE(errorText(readProjectText(json.dump())), std::string("assets[1]: unknown key \"mesh\"."));
    }
    void assetsHaveOneShape() {
        const nlohmann::json json = nlohmann::json::parse(projectText(meshProject()));
        nlohmann::json other = json;
        other["assets"][1].erase("mesh");
        QCOMPARE(errorText(readProjectText(other.dump())), std::string("assets[1]: the key \"prism\" is missing."));
        other = json;
        other["assets"][1]["prism"] = other["assets"][0]["prism"];
        QCOMPARE(errorText(readProjectText(other.dump())), std::string("assets[1]: unknown key \"prism\"."));
        other = json;
        other["assets"][1]["mesh"]["hash"] = "../../etc/passwd";
        QCOMPARE(errorText(readProjectText(other.dump())),
                 std::string("assets[1].mesh.hash: expected a hash of 32 hexadecimal digits."));
        other = json;
        other["assets"][1]["mesh"]["points"] = 0;
        QVERIFY(errorText(readProjectText(other.dump())).starts_with("assets[1].mesh.points: "));
    }
    void writtenMeshesMatchTheSchema() {
        const test::Schema schema("project.schema.json");
        const nlohmann::json json = nlohmann::json::parse(projectText(meshProject()));
        QCOMPARE(schema.fault(json), std::string());
        nlohmann::json other = json;
        other["version"] = 5;
        QVERIFY(!schema.fault(other).empty());
        other = json;
        other["assets"][1].erase("mesh");
        QVERIFY(!schema.fault(other).empty());
        other = json;
        other["assets"][1]["prism"] = other["assets"][0]["prism"];
        QVERIFY(!schema.fault(other).empty());
        other = json;
        other["assets"][1]["mesh"]["hash"] = "sphere";
        QVERIFY(!schema.fault(other).empty());
    }
    void textsWithoutAFileHaveNoMeshes() {
        const Result<Project> read = readProjectText(projectText(meshProject()));
        QCOMPARE(read.error().code, ErrorCode::Unsupported);
        QCOMPARE(read.error().message,
                 std::string("Asset \"sculpture\": Its mesh lies in a folder beside the project's file; give the file, "
                             "not its text."));
    }
    void filesAreWrittenOnceAndStay() {
        Project project = meshProject();
        const fs::path path = inFolder("house.rubble"), mesh = meshFile(project);
        QVERIFY(saveProject(path, project));
        const auto written = fs::last_write_time(mesh) - std::chrono::hours(1);
        fs::last_write_time(mesh, written);
        project.ground.height = 2.0;
        QVERIFY(saveProject(path, project));
        QVERIFY(fs::last_write_time(mesh) == written);
        const std::string bytes = *readFile(mesh);
        fs::resize_file(mesh, bytes.size() - 5);  // damaged: the next save mends it
        QVERIFY(saveProject(path, project));
        QCOMPARE(*readFile(mesh), bytes);
        project.assets.pop_back();
        QVERIFY(saveProject(path, project) && fs::exists(mesh));
    }
    void anotherPathHasItsOwnFolder() {
        const Project project = meshProject();
        QVERIFY(saveProject(inFolder("house.rubble"), project));
        fs::create_directory(inFolder("b"));
        QVERIFY(saveProject(inFolder("b/copy.rubble"), *loadProject(inFolder("house.rubble"))));
        fs::remove_all(meshFolderOf(inFolder("house.rubble")));
        QVERIFY(*loadProject(inFolder("b/copy.rubble")) == project);
        fs::create_symlink(inFolder("b/copy.rubble"), inFolder("link.rubble"));
        QVERIFY(*loadProject(inFolder("link.rubble")) == project);
        QVERIFY(saveProject(inFolder("link.rubble"), meshProject(test::torus(8, 6))));
        QVERIFY(!fs::exists(inFolder("link.rubble.meshes")));
        QVERIFY(*loadProject(inFolder("b/copy.rubble")) == meshProject(test::torus(8, 6)));
    }
    void missingFilesAreReported() {
        const Project project = meshProject();
        const fs::path path = inFolder("house.rubble"), mesh = meshFile(project);
        QVERIFY(saveProject(path, project));
        fs::remove(mesh);
        const Result<Project> read = loadProject(path);
        QCOMPARE(read.error().code, ErrorCode::NotFound);
        QCOMPARE(read.error().message,
                 "Cannot read \"" + path.string() + "\": Asset \"sculpture\": The file of its mesh is missing, \"" +
                     mesh.string() + "\"; copy the folder \"house.rubble.meshes\" beside the project.");
        QVERIFY(recoverProject(path).error().code == ErrorCode::NotFound);
    }
    void damagedAndForeignFilesAreReported() {
        const Project project = meshProject(), other = meshProject(test::torus(8, 6));
        const fs::path path = inFolder("house.rubble"), mesh = meshFile(project);
        QVERIFY(saveProject(path, project));
        const auto fault = [&] { return errorText(loadProject(path)); };
        std::string bytes = *readFile(mesh);
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
        QVERIFY(writeFileAtomically(mesh, bytes));
        QVERIFY(
            contains(fault(), "Asset \"sculpture\": Cannot read \"" + mesh.string() + "\": The mesh cannot be read: "));
        QVERIFY(contains(fault(), "; restore the file from a copy of the project."));
        QVERIFY(writeFileAtomically(mesh, meshBytes(*other.assets[1].mesh())));
        QVERIFY(contains(fault(), "it is another one"));
        fs::remove(mesh);
        fs::create_symlink(path, mesh);
        QVERIFY(contains(fault(), mesh.string()));
        fs::remove(mesh);
        fs::create_directory(mesh);
        QVERIFY(contains(fault(), mesh.string()));
    }
    void sizesAreCompared() {
        const Project project = meshProject();
        const fs::path path = inFolder("house.rubble");
        QVERIFY(saveProject(path, project));
        nlohmann::json json = nlohmann::json::parse(projectText(project));
        json["assets"][1]["mesh"]["triangles"] = 61;
        QVERIFY(writeFileAtomically(path, json.dump()));
        QVERIFY(contains(errorText(loadProject(path)), "assets[1].mesh.triangles: the mesh of this hash has 60."));
    }
    void fullDisksKeepTheOldProject() {
        const Project old = meshProject();
        const fs::path path = inFolder("house.rubble");
        QVERIFY(saveProject(path, old));
        const Project large = meshProject(test::bumpySphere(30));
        {
            const FileSizeLimit limit(static_cast<long>(projectText(large).size()) + 1000);
            QCOMPARE(saveProject(path, large).error().code, ErrorCode::Io);
            QCOMPARE(saveProject(inFolder("new.rubble"), large).error().code, ErrorCode::Io);
        }
        QVERIFY(*loadProject(path) == old);
        QVERIFY(!fs::exists(inFolder("new.rubble")) && !fs::exists(meshFolderOf(inFolder("new.rubble"))));
    }
    void meshesThatCannotBeReadAgainAreNotSaved() {
        Project project = meshProject();
        TriangleMesh open = test::bumpySphere(6);
        open.triangles.pop_back();
        auto mesh = std::make_shared<ClosedMesh>(*project.assets[1].mesh());
        mesh->mesh = open;
        mesh->hash = contentHash("open");
        project.assets[1].shape = std::shared_ptr<const ClosedMesh>(mesh);
        const Status saved = saveProject(inFolder("house.rubble"), project);
        QCOMPARE(saved.error().code, ErrorCode::Degenerate);
        QVERIFY(saved.error().message.starts_with("Asset \"sculpture\": "));
        QVERIFY(!fs::exists(inFolder("house.rubble")) && !fs::exists(meshFolderOf(inFolder("house.rubble"))));
    }
    void journalsHaveMeshes() {
        const Project before = meshProject(), after = meshProject(test::torus(8, 6));
        const fs::path path = inFolder("house.rubble"), journal = inFolder("house.journal");
        QVERIFY(saveProject(path, before));
        ContentHash seal = contentHash(projectText(before));
        std::string records = journalStart(seal);
        ProjectPart part{.values = after};
        records += journalRecord(part, seal);
        QVERIFY(writeFileAtomically(journal, records));
        const auto without = recoverProject(path, journal);
        QVERIFY(without && without->project == before && without->faults.size() == 1);
        QVERIFY(contains(without->faults[0], "The file of its mesh is missing, "));
        QVERIFY(saveMeshes(after, meshFolderOf(path)));
        const auto recovered = recoverProject(path, journal);
        QVERIFY(recovered && recovered->project == after && recovered->faults.empty());
    }
    void differencesOfMeshesAreNamedOnce() {
        const Project before = meshProject(), after = meshProject(test::torus(8, 6));
        Project prism = before;
        prism.assets[1].shape = prism.assets[0].shape;
        const auto changes = assetChanges(before, before.assets[1], after, after.assets[1]);
        QCOMPARE(changes.size(), std::size_t{1});
        QCOMPARE(changes[0].what, std::string("mesh"));
        QVERIFY2(changes[0].before.starts_with("60 triangles, ") && changes[0].after.starts_with("96 triangles, "),
                 (changes[0].before + changes[0].after).c_str());
        QVERIFY(assetChanges(before, before.assets[1], before, before.assets[1]).empty());
        QVERIFY(settingChanges(before, after).empty());
        QVERIFY(settingChanges(before, prism).empty());  // another version of the file is no change of the project
        QVERIFY(!assetChanges(before, before.assets[1], prism, prism.assets[1]).empty());
    }
};

RUBBLE_TEST(MeshFolderTest)
#include "MeshFolderTest.moc"
