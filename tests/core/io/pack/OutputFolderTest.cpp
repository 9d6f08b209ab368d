#include "core/io/pack/OutputFolder.h"

#include "core/asset/library/StarterProject.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FolderNames.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

/// The folder of the starter project's asset.
constexpr const char* kOnlyPack = "wall";

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
                for (const std::optional<ExportTarget> target :
                     {std::optional<ExportTarget>(), {ExportTarget::Godot}}) {
                    const QTemporaryDir place;
                    const OutputRequest request{.folder = place.path().toStdString(),
                                                .project = "wall.rubble",
                                                .options = {.meshes = {.obj = false, .glb = false}},
                                                .target = target,
                                                .hasAllAssets = hasAllAssets};
                    QCOMPARE(namesAfterExport(project, request), listedNames(project, request));
                }
            }
        }
    }

private:
    static std::vector<std::string> namesAfterExport(const Project& project, const OutputRequest& request) {
        const std::vector<Id> assets{project.assets.front().id};
        const auto earlier = readExportIndex(request.folder).value();
        const auto packs = exportPacks(project, assets, request.folder, request.options).value();
        if (!finishExport(request, project, packs, earlier)) return {};
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
