#include "core/io/pack/OutputFolder.h"

#include "core/asset/library/StarterProject.h"
#include "core/io/pack/PackFile.h"
#include "core/io/pack/SceneFile.h"
#include "core/io/project/ProjectIdentity.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FolderNames.h"
#include "tests/support/play/BondedWalls.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <filesystem>
#include <fstream>
#include <thread>

using namespace rubble;

namespace {

namespace fs = std::filesystem;

/// The folder of the starter project's asset, and its id.
constexpr const char* kOnlyPack = "wall";
const std::vector<Id> kAssets{starterProject().assets.front().id};

std::string textOf(const fs::path& path) { return readFile(path).value(); }

}  // namespace

class OutputFolderTest : public QObject {
    Q_OBJECT
private slots:
    void sceneIsLeftOutAndRemoved() {
        const QTemporaryDir place;
        OutputRequest request{.folder = place.path().toStdString(), .project = "wall.rubble"};
        const std::vector<std::string> withScene{"export.json", "scene.json", kOnlyPack};
        QCOMPARE(namesAfterExport(starterProject(), request), withScene);
        request.isWithScene = false;
        const std::vector<std::string> withoutScene{"export.json", kOnlyPack};
        QCOMPARE(outputFileNames(request, starterProject()), std::vector<std::string>{"export.json"});
        QCOMPARE(namesAfterExport(starterProject(), request), withoutScene);
    }
    void namesAreThoseOfTheFilesWritten() {
        Project empty = starterProject();
        empty.instances.clear();
        for (const Project& project : {starterProject(), empty}) {
            for (const bool hasAllAssets : {true, false}) {
                for (const ExportTarget* target : {static_cast<const ExportTarget*>(nullptr), targetNamed("godot")}) {
                    const QTemporaryDir place;
                    const OutputRequest request{.folder = place.path().toStdString(),
                                                .project = "wall.rubble",
                                                .options = {.meshes = {.formats = {}}},
                                                .target = target,
                                                .hasAllAssets = hasAllAssets};
                    QCOMPARE(namesAfterExport(project, request), listedNames(project, request));
                }
            }
        }
    }
    void filesThatNoExportWroteAreNeverReplaced() {
        for (const EditedFiles edited : {EditedFiles::Kept, EditedFiles::Replaced}) {
            for (const char* name : {kReadmeName, kSceneName}) {
                const QTemporaryDir place;
                OutputRequest request = requestFor(place);
                request.edited = edited;
                std::ofstream(request.folder / name) << "mine";
                const auto refused = exportToFolder(request, starterProject(), kAssets);
                QVERIFY(!refused && refused.error().code == ErrorCode::BadInput);
                QVERIFY(refused.error().message.find("was not written by an export") != std::string::npos);
                QCOMPARE(namesIn(request.folder), std::vector<std::string>{name});  // no pack without an index
            }
        }
    }
    void editedFilesAreRefusedBeforeAnythingIsWritten() {
        const QTemporaryDir place;
        OutputRequest request = requestFor(place);
        QVERIFY(exportToFolder(request, starterProject(), kAssets)->finished.hasValue());
        std::ofstream(request.folder / kReadmeName) << "mine";
        Project changed = starterProject();
        changed.assets.front().prism().depth *= 2.0;
        const std::string before = textOf(request.folder / kOnlyPack / "manifest.json");
        const auto refused = exportToFolder(request, changed, kAssets);
        QVERIFY(!refused && refused.error().code == ErrorCode::Edited);
        QCOMPARE(textOf(request.folder / kOnlyPack / "manifest.json"), before);
        request.edited = EditedFiles::Replaced;
        QVERIFY(exportToFolder(request, changed, kAssets)->finished.hasValue());
    }
    /// One that is as it was written is not made again, since its bonds take a bake.
    void editedScenesWithBondsAreMadeAgain() {
        const QTemporaryDir place;
        OutputRequest request = requestFor(place);
        request.edited = EditedFiles::Replaced;
        const Project project = test::bondedWall(10);
        const std::vector<Id> assets{project.assets.front().id};
        QVERIFY(exportToFolder(request, project, assets)->finished.hasValue());
        const std::string scene = textOf(request.folder / kSceneName);
        std::ofstream(request.folder / kSceneName, std::ios::app) << "\n";
        QVERIFY(exportToFolder(request, project, assets)->finished.hasValue());
        QCOMPARE(textOf(request.folder / kSceneName), scene);
    }
    void projectsOfOneNameAreToldApartByTheirIdentities() {
        const QTemporaryDir place;
        OutputRequest request = requestFor(place);
        request.isPruning = true;
        Project first = starterProject(), second = starterProject();
        first.identity = newIdentity();
        second.identity = newIdentity();
        QVERIFY(first.identity != second.identity);
        second.assets.front().name = "another";
        QVERIFY(exportToFolder(request, first, kAssets)->finished.hasValue());
        const auto refused = exportToFolder(request, second, kAssets);
        QVERIFY(!refused && refused.error().code == ErrorCode::Edited);
        request.edited = EditedFiles::Replaced;
        const auto exported = exportToFolder(request, second, kAssets);
        QVERIFY(exported && exported->finished.hasValue() && exported->pruned.empty());
        QVERIFY(fs::exists(request.folder / kOnlyPack));
        request.project = "renamed.rubble";
        second.assets.front().name = "third";
        QCOMPARE(exportToFolder(request, second, kAssets)->renamed.size(), 1U);
        QVERIFY(fs::exists(request.folder / kOnlyPack) && !fs::exists(request.folder / "another"));
        second.assets.front().id = second.nextId++;  // a new asset in place of that
        const std::vector<Id> assets{second.assets.front().id};
        second.instances.clear();
        second.assets.front().name = "fourth";
        QCOMPARE(exportToFolder(request, second, assets)->pruned.size(), 1U);
        QVERIFY(fs::exists(request.folder / kOnlyPack) && !fs::exists(request.folder / "third"));
    }
    void foldersOfOtherProjectsAreKept() {
        const QTemporaryDir place;
        OutputRequest request{.folder = place.path().toStdString(), .project = "a.rubble", .isWithScene = false};
        Project first = starterProject(), second = starterProject();
        first.identity = newIdentity();
        second.identity = newIdentity();
        second.assets.front().prism().depth *= 2.0;
        QVERIFY(exportToFolder(request, first, kAssets)->finished.hasValue());
        const std::string before = textOf(request.folder / kOnlyPack / "manifest.json");
        request.project = "b.rubble";
        const auto refused = exportToFolder(request, second, kAssets);
        QVERIFY(!refused && refused.error().code == ErrorCode::Edited);
        QVERIFY(refused.error().message.ends_with(
            "/wall\" is of the export of another project, \"a.rubble\", and would be lost; export elsewhere."));
        QCOMPARE(textOf(request.folder / kOnlyPack / "manifest.json"), before);
        second.assets.front().name = "another";  // they may share the folder
        QVERIFY(exportToFolder(request, second, kAssets)->finished.hasValue());
    }
    /// Also where a pack could not be replaced; the scene, which would name it, stays as it was.
    void theReadmeIsOfTheLastProgram() {
        const QTemporaryDir place;
        OutputRequest request = requestFor(place);
        Project project = starterProject();
        project.assets.push_back(project.assets.front());
        project.assets.back().id = project.nextId++;
        project.assets.back().name = "roof";
        const std::vector<Id> assets{project.assets[0].id, project.assets[1].id};
        QVERIFY(exportToFolder(request, project, assets)->finished.hasValue());
        const std::string scene = textOf(request.folder / kSceneName);
        std::ofstream(request.folder / kOnlyPack / "notes.txt") << "mine";
        request.target = targetNamed("unity");
        request.options = request.target->options();
        for (Asset& asset : project.assets) asset.prism().depth *= 2.0;
        for (int round = 0; round < 2; ++round) {  // the second one finds what the first one listed
            const auto exported = exportToFolder(request, project, assets);
            QVERIFY(exported && exported->finished.hasValue());
            QVERIFY(!exported->packs[0].status && exported->packs[1].status);
            QVERIFY(textOf(request.folder / kReadmeName).starts_with("# Destructible assets for Unity\n"));
            QCOMPARE(textOf(request.folder / kSceneName), scene);
        }
        fs::remove(request.folder / kOnlyPack / "notes.txt");
        QVERIFY(exportToFolder(request, project, assets)->packs[0].status);
        QVERIFY(textOf(request.folder / kSceneName) != scene);
    }
    void foldersAreRenamedWithTheirAssets() {
        const QTemporaryDir place;
        const OutputRequest request = requestFor(place);
        Project project = starterProject();
        QVERIFY(exportToFolder(request, project, kAssets)->finished.hasValue());
        std::ofstream(request.folder / "wall" / "wall-intact.glb.import") << "of the engine";
        project.assets.front().name = "facade";
        const auto renamed = exportToFolder(request, project, kAssets);
        QVERIFY(renamed && renamed->finished.hasValue() && renamed->packs[0].status && renamed->stale.empty());
        QCOMPARE(renamed->renamed.size(), 1U);
        QVERIFY(!fs::exists(request.folder / "wall"));
        QCOMPARE(textOf(request.folder / "facade" / "facade-intact.glb.import"), "of the engine");
        QVERIFY(!fs::exists(request.folder / "facade" / "wall-intact.glb"));
        QCOMPARE(readExportIndex(request.folder)->value().folders, std::vector<std::string>{"facade"});
        project.assets.front().name = "wall";
        fs::create_directory(request.folder / "wall");
        std::ofstream(request.folder / "wall" / "mine.txt") << "mine";
        const auto refused = exportToFolder(request, project, kAssets);
        QVERIFY(refused && !refused->packs[0].status && refused->renamed.empty());
        QVERIFY(fs::exists(request.folder / "facade") && fs::exists(request.folder / "wall" / "mine.txt"));
    }
    /// Another asset has the former name of one.
    void foldersOfNamesInUseAreNotRenamed() {
        const QTemporaryDir place;
        const OutputRequest request = requestFor(place);
        Project project = starterProject();
        QVERIFY(exportToFolder(request, project, kAssets)->finished.hasValue());
        project.assets.push_back(project.assets.front());
        project.assets.front().name = "tower";
        project.assets.back().id = project.nextId++;
        const std::vector<Id> assets{project.assets.front().id, project.assets.back().id};
        const auto exported = exportToFolder(request, project, assets);
        QVERIFY(exported->finished.hasValue() && exported->renamed.empty());
        QVERIFY(fs::exists(request.folder / kOnlyPack) && fs::exists(request.folder / "tower"));
    }
    void foldersOfDeletedAssetsAreReported() {
        const QTemporaryDir place;
        OutputRequest request = requestFor(place);
        Project project = starterProject();
        Asset second = project.assets.front();
        second.id = project.nextId++;
        second.name = "second";
        for (PatternLayer& layer : second.pattern.layers) layer.id = project.nextId++;
        project.assets.push_back(second);
        QVERIFY(exportToFolder(request, project, std::vector<Id>{kAssets[0], second.id})->finished.hasValue());
        project.assets.pop_back();
        QCOMPARE(exportToFolder(request, project, kAssets)->stale, std::vector<std::string>{"second"});
        QVERIFY(fs::exists(request.folder / "second"));
    }
    void versionsExportedAtOnceIntoANewFolderTakeTurns() {
        constexpr int kRounds = 10, kVersions = 8;
        for (int round = 0; round < kRounds; ++round) {
            const QTemporaryDir place;
            OutputRequest request = requestFor(place);
            request.folder /= "new/folder";
            std::array<std::string, kVersions> failures;
            std::vector<std::jthread> threads;
            for (int version = 0; version < kVersions; ++version) {
                threads.emplace_back([&, version] {
                    Project project = starterProject();
                    project.assets.front().prism().depth *= 1.0 + 0.1 * version;
                    const auto exported = exportToFolder(request, project, kAssets);
                    if (!exported || !exported->finished)
                        failures[version] = (exported ? exported->finished.error() : exported.error()).message;
                });
            }
            threads.clear();
            for (const std::string& failure : failures) QCOMPARE(failure, "");
            const auto scene = verifyScene(request.folder);
            QVERIFY2(!scene, scene.value_or("").c_str());
        }
    }

private:
    static OutputRequest requestFor(const QTemporaryDir& place) {
        return {.folder = place.path().toStdString(), .project = "wall.rubble", .target = targetNamed("godot")};
    }
    /// Why the scene in a folder does not fit its packs; nothing if it does.
    static std::optional<std::string> verifyScene(const fs::path& folder) {
        PackPhysicsHashes present;
        const Result<Pack> pack = readPack(textOf(folder / kOnlyPack / kPackName));
        if (!pack) return pack.error().message;
        present[kOnlyPack] = pack->physicsHash;
        return scenePacksFault(textOf(folder / kSceneName), present);
    }
    static std::vector<std::string> namesAfterExport(const Project& project, const OutputRequest& request) {
        const std::vector<Id> assets{project.assets.front().id};
        const Result<OutputExport> exported = exportToFolder(request, project, assets);
        if (!exported || !exported->finished) return {};
        return namesIn(request.folder);
    }
    static std::vector<std::string> listedNames(const Project& project, const OutputRequest& request) {
        std::vector<std::string> names = outputFileNames(request, project);
        names.push_back(kOnlyPack);
        std::ranges::sort(names);
        return names;
    }
};

RUBBLE_TEST(OutputFolderTest)
#include "OutputFolderTest.moc"
