#include "core/io/output/ExportCheck.h"
#include "core/io/output/ExportFolder.h"
#include "core/io/pack/OutputFolder.h"
#include "core/io/pack/PackExport.h"

#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileName.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

using namespace rubble;
namespace fs = std::filesystem;

namespace {

/// Assets with the given names and ids 11, 12, ...: squares of 1 m with 6 fragments each.
Project projectOf(const std::vector<std::string>& names) {
    Project project;
    project.materials = {{.id = 1, .name = "brick"}};
    Id id = 10;
    for (const std::string& name : names) {
        Asset asset = assetOf(unitSquare(), 0.5);
        asset.id = ++id;
        asset.name = name;
        asset.material = 1;
        asset.pattern = scatterOf(6, 100 + id);
        project.assets.push_back(asset);
    }
    project.nextId = 1000;
    return project;
}

std::vector<Id> allAssets(const Project& project) {
    std::vector<Id> ids;
    for (const Asset& asset : project.assets) ids.push_back(asset.id);
    return ids;
}

/// All files below a folder with their bytes.
std::map<std::string, std::string> treeOf(const fs::path& folder) {
    std::map<std::string, std::string> tree;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) tree[fs::relative(entry.path(), folder)] = readFile(entry.path()).value();
    }
    return tree;
}

/// The source of the first asset's pack.
ContentHash sourceOf(const Project& project, const PackOptions& options = {}) {
    const Asset& asset = project.assets[0];
    return packSourceHash(project, asset, packNames(project).at({asset.id}), options);
}

}  // namespace

class PackExportTest : public QObject {
    Q_OBJECT
private slots:
    void shortNamesFitOtherPrograms() {
        const std::string name(80, 'a');
        const Project project = projectOf({name + "b", name + "c", "wall"});
        const PackOptions options{.hasShortNames = true};
        QTemporaryDir folder;
        const fs::path out = folder.path().toStdString();
        QVERIFY(exportPacks(project, allAssets(project), out, options, EditedFiles::Kept).hasValue());
        std::set<std::string> folders;
        for (const PackListing& pack : packListings(project, allAssets(project), options)) {
            QVERIFY(pack.folder.size() <= kShortestName && fs::exists(out / pack.folder / "pack.json"));
            for (const std::string& file : pack.files.names) QVERIFY(file.size() < 63);
            folders.insert(pack.folder);
        }
        QVERIFY(folders.size() == 3 && folders.contains("wall"));
        QVERIFY(packListings(project, allAssets(project), {})[0].folder == name + "b");
    }
    void init() {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_out = m_temporary->path().toStdString() + "/packs";
    }

    void everyAssetGetsAFolder() {
        const Project project = projectOf({"wall", "old roof"});
        const auto assets = exportPacks(project, allAssets(project), m_out, {});
        QVERIFY(assets);
        QCOMPARE(assets->size(), std::size_t{2});
        QVERIFY((*assets)[1].status);
        QCOMPARE((*assets)[1].folder, m_out / "old_roof");
        QCOMPARE((*assets)[1].fragmentCount, std::size_t{6});
        QCOMPARE((*assets)[1].volume, 0.5);
        for (const char* file :
             {"wall/pack.json", "wall/manifest.json", "wall/wall-fragments.obj", "wall/wall.mtl",
              "wall/wall-fragments.glb", "wall/wall-intact.obj", "old_roof/old_roof-fragments.glb"}) {
            QVERIFY2(fs::exists(m_out / file), file);
        }
    }
    void longNamesAreExported() {
        const Project project = projectOf({std::string(5000, 'x'), std::string(5000, 'x') + 'y'});
        const auto assets =
            exportPacks(project, allAssets(project), m_out, {.meshes = {.split = FileSplit::PerFragment}});
        QVERIFY(assets);
        for (const AssetExport& asset : *assets) {
            QVERIFY2(asset.status, asset.status ? "" : asset.status.error().message.c_str());
            QVERIFY(!verifyExportFolder(asset.folder));
        }
    }
    void bytesDoNotDependOnThreads() {
        const Project project = projectOf({"a", "b", "c", "d", "e"});
        TaskContext task;
        QVERIFY(exportPacks(project, allAssets(project), m_out, {}, EditedFiles::Kept, task));
        task.threads = 4;
        QVERIFY(exportPacks(project, allAssets(project), m_out / "again", {}, EditedFiles::Kept, task));
        const auto again = treeOf(m_out / "again");
        fs::remove_all(m_out / "again");
        QVERIFY(!again.empty() && treeOf(m_out) == again);
    }
    void unchangedExportIsNotRewritten() {
        Project project = projectOf({"a", "b"});
        QVERIFY(exportPacks(project, allAssets(project), m_out, {}));
        const auto written = fs::last_write_time(m_out / "a" / "pack.json");
        project.assets[1].threshold = 7.0;
        const auto assets = exportPacks(project, allAssets(project), m_out, {}).value();
        QVERIFY(assets[0].isUnchanged && !assets[1].isUnchanged);
        QVERIFY(fs::last_write_time(m_out / "a" / "pack.json") == written);
    }
    void planIsWhatTheExportDoes() {
        Project project = projectOf({"a", "b", "c", "d"});
        const auto exportOf = [&project](const char* name) {
            return std::vector<Id>{std::ranges::find(project.assets, name, &Asset::name)->id};
        };
        QVERIFY(exportPacks(project, exportOf("a"), m_out, {}));
        QVERIFY(exportPacks(project, exportOf("b"), m_out, {}));
        QVERIFY(exportPacks(project, exportOf("c"), m_out, {}));
        project.assets[1].threshold = 7.0;
        project.assets[2].threshold = 7.0;
        QVERIFY(writeFileAtomically(m_out / "c" / "notes.txt", "mine"));
        const auto before = treeOf(m_out);
        const auto planned = planPacks(project, allAssets(project), m_out, {}).value();
        QVERIFY(treeOf(m_out) == before);
        const auto exported = exportPacks(project, allAssets(project), m_out, {}).value();
        QCOMPARE(planned.size(), exported.size());
        for (std::size_t k = 0; k < planned.size(); ++k) {
            QCOMPARE(planned[k].folder, exported[k].folder);
            QCOMPARE(planned[k].isUnchanged, exported[k].isUnchanged);
            QCOMPARE(planned[k].isReplacing, exported[k].isReplacing);
            QCOMPARE(planned[k].status.hasValue(), exported[k].status.hasValue());
        }
        QVERIFY(planned[0].isUnchanged && planned[1].isReplacing && !planned[2].status && !planned[3].isReplacing);
        QVERIFY(!planPacks(project, std::vector<Id>{999}, m_out, {}));
    }
    void listingsAreWhatTheExportWrites() {
        Project project = projectOf({"wall", "old roof"});
        project.instances = {{.id = 50, .asset = 11, .variant = 3}};
        for (const PackFiles files : {PackFiles::Json, PackFiles::Binary, PackFiles::Both}) {
            PackOptions options{.files = files};
            if (files != PackFiles::Both) options.meshes.formats.erase("glb");
            QVERIFY(exportPacks(project, allAssets(project), m_out, options));
            std::vector<std::string> written, listed;
            for (const auto& [path, bytes] : treeOf(m_out)) written.push_back(path);
            for (const PackListing& pack : packListings(project, allAssets(project), options)) {
                QVERIFY(pack.files.areAll);
                for (const std::string& name : pack.files.names) listed.push_back(pack.folder + "/" + name);
            }
            std::ranges::sort(listed);
            QCOMPARE(listed, written);
        }
        QCOMPARE(packListings(project, std::vector<Id>{12, 999}, {}).size(), std::size_t{1});
    }
    void modifiedOrMissingFilesAreRewritten() {
        const Project project = projectOf({"a"});
        QVERIFY(exportPacks(project, allAssets(project), m_out, {}));
        const auto whole = treeOf(m_out);
        QVERIFY(writeFileAtomically(m_out / "a" / "a-fragments.obj", "o nothing\n"));
        const AssetExport kept = exportPacks(project, allAssets(project), m_out, {}).value()[0];
        QCOMPARE(kept.status.error().code, ErrorCode::Edited);
        QCOMPARE(*readFile(m_out / "a" / "a-fragments.obj"), std::string("o nothing\n"));
        const auto replaced = exportPacks(project, allAssets(project), m_out, {}, EditedFiles::Replaced);
        QVERIFY(replaced && replaced.value()[0].status && !replaced.value()[0].isUnchanged);
        QVERIFY(treeOf(m_out) == whole);
        fs::remove(m_out / "a" / "a.glb");
        QVERIFY(exportPacks(project, allAssets(project), m_out, {}));
        QVERIFY(treeOf(m_out) == whole);
    }
    void sourceHashDependsOnAllInputs() {
        const Project project = projectOf({"a"});
        const ContentHash source = sourceOf(project);
        const auto differs = [&](const auto& change) {
            Project other = project;
            change(other, other.assets[0]);
            return sourceOf(other) != source;
        };
        QVERIFY(differs([](Project&, Asset& a) { a.prism().depth = 0.25; }));
        QVERIFY(differs([](Project&, Asset& a) { a.insideUvScale = 2.0; }));
        QVERIFY(differs([](Project&, Asset& a) { a.threshold = 2.0; }));
        QVERIFY(differs([](Project&, Asset& a) { a.shaping.roughness.amplitude = 0.01; }));
        QVERIFY(differs([](Project&, Asset& a) { a.shaping.gap = 0.01; }));
        QVERIFY(differs([](Project&, Asset& a) { a.insideMaterial = a.material; }));
        QVERIFY(differs([](Project&, Asset& a) { a.name = "b"; }));
        QVERIFY(differs([](Project&, Asset& a) {
            a.surface = std::make_shared<const Surface>(Surface{{"paint"}, {}, {}, {}});
        }));
        QVERIFY(differs([](Project& p, Asset&) { p.materials[0].density = 2.0; }));
        QVERIFY(differs([](Project& p, Asset&) { p.materials[0].inside.red = 0.1; }));
        QVERIFY(differs([](Project& p, Asset& a) {
            p.materials[0].tensileStrength = 1e6;
            a.contactTime = 1e-3;
        }));
        QVERIFY(differs([](Project& p, Asset&) { p.materials[0].fractureToughness = 1e6; }));
        QVERIFY(differs([](Project& p, Asset&) { p.debris.lifetime = 2.0; }));
        QVERIFY(differs([](Project& p, Asset&) { p.damage.rule = DamageRule::Momentum; }));
        QVERIFY(differs([](Project&, Asset& a) { a.cutAtImpact.emplace(); }));
        QVERIFY(!differs([](Project& p, Asset&) { p.gravity.y = -1.0; }));
        QVERIFY(!differs([](Project& p, Asset&) { p.nextId = 2000; }));
        QVERIFY(!differs([](Project&, Asset& a) { a.requirements.resize(1); }));
        QVERIFY(!differs([](Project&, Asset& a) { a.bonding.radius = 2.0; }));
        QVERIFY(differs([](Project&, Asset& a) { a.breakAs = BreakAs::Bonded; }));
        for (const MeshOptions& options :
             {MeshOptions{.formats = {"glb"}}, MeshOptions{.formats = {"obj"}},
              MeshOptions{.formats = {"obj", "glb", "usd"}}, MeshOptions{.formats = {"obj", "glb", "mjcf"}},
              MeshOptions{.split = FileSplit::PerFragment}, MeshOptions{.place = PartPlacement::Centred},
              MeshOptions{.faces = FaceShape::Triangles}, MeshOptions{.glbKind = GlbKind::Physics},
              MeshOptions{.glbKind = GlbKind::Compact}, MeshOptions{.glbKind = GlbKind::Named}}) {
            QVERIFY(sourceOf(project, {.meshes = options}) != source);
        }
        const MeshOptions obj{.formats = {"obj"}}, objWithPhysics{.formats = {"obj"}, .glbKind = GlbKind::Physics};
        QVERIFY(sourceOf(project, {.meshes = obj}) == sourceOf(project, {.meshes = objWithPhysics}));
        QVERIFY(sourceOf(project, {.inset = 0.0}) != source);
        QVERIFY(sourceOf(project, {.topology = PackTopology::Loops}) != source);
    }
    void sourceHashOfBondedAssetsDependsOnTheirBonds() {
        Project project = projectOf({"a"});
        project.assets[0].breakAs = BreakAs::Bonded;
        const ContentHash source = sourceOf(project);
        const auto differs = [&](const auto& change) {
            Project other = project;
            change(other, other.assets[0]);
            return sourceOf(other) != source;
        };
        QVERIFY(differs([](Project&, Asset& a) { a.bonding.radius = 2.0; }));
        QVERIFY(differs([](Project&, Asset& a) { a.bonding.impulsePerArea = 2.0; }));
        QVERIFY(differs([](Project&, Asset& a) { a.cutAtImpact.emplace(); }));  // its bake has another damageHash()
        QVERIFY(differs([](Project& p, Asset&) {
            p.materials[0].fractureToughness = 1e6;
            p.materials[0].youngsModulus = 1e9;
            p.materials[0].tensileStrength = 1e6;
        }));
        QVERIFY(!differs([](Project& p, Asset&) { p.gravity.y = -1.0; }));
    }
    void errorOfOneAssetDoesNotStopOthers() {
        const Project project = projectOf({"a", "b", "c"});
        fs::create_directories(m_out / "b");
        QVERIFY(writeFileAtomically(m_out / "b" / "mine.txt", "mine"));
        const auto assets = exportPacks(project, allAssets(project), m_out, {}).value();
        QVERIFY(assets[0].status && assets[2].status);
        QCOMPARE(assets[1].status.error().code, ErrorCode::BadInput);
        QVERIFY(fs::exists(m_out / "a" / "pack.json") && fs::exists(m_out / "c" / "pack.json"));
        QCOMPARE(treeOf(m_out / "b").size(), std::size_t{1});
    }
    void noFolderHasTheNameOfTheIndex() {
        const Project project = projectOf({"export.json", "Export.JSON"});
        const auto assets = exportPacks(project, allAssets(project), m_out, {}).value();
        QCOMPARE(assets[0].folder, m_out / "export.json-2");
        QCOMPARE(assets[1].folder, m_out / "Export.JSON-3");
    }
    void noFolderHasTheNameOfAFileBesideThePacks() {
        const Project project = projectOf({"scene.json", "readme.md", "import_into_unreal.py", "wall"});
        const auto assets = exportPacks(project, allAssets(project), m_out, {}).value();
        for (const std::size_t k : {0u, 1u, 2u}) QVERIFY(assets[k].folder.filename().string().ends_with("-2"));
        QCOMPARE(assets[3].folder, m_out / "wall");
        const OutputRequest request{.folder = m_out, .project = "p.rubble", .target = targetNamed("unreal")};
        QVERIFY(exportToFolder(request, project, allAssets(project))->finished);
        for (const char* name : {"README.md", "import_into_unreal.py"})
            QVERIFY2(fs::is_regular_file(m_out / name), name);
    }
    void foldersDependOnAllAssetsOfTheProject() {
        const Project project = projectOf({"a/b", "a:B"});
        const auto second = exportPacks(project, std::vector<Id>{12}, m_out, {}).value();
        QCOMPARE(second.front().folder, m_out / "a_B-2");
        const auto both = exportPacks(project, allAssets(project), m_out, {}).value();
        QCOMPARE(both[0].folder, m_out / "a_b");
        QVERIFY(both[1].folder == second.front().folder && both[1].isUnchanged);
    }
    void unknownAssetIsRejected() {
        const auto refused = exportPacks(projectOf({"a"}), std::vector<Id>{5}, m_out, {});
        QCOMPARE(refused.error().code, ErrorCode::NotFound);
        QCOMPARE(refused.error().message, std::string("The project has no asset with the id 5."));
    }
    void cancellingLeavesOnlyCompleteFolders() {
        const Project project = projectOf({"a", "b", "c", "d"});
        TaskContext task;
        task.threads = 2;
        double last = 0.0;
        task.progress = [&](double fraction) {
            if (fraction >= 0.4) task.cancel.cancel();
            last = fraction;
        };
        QCOMPARE(exportPacks(project, allAssets(project), m_out, {}, EditedFiles::Kept, task).error().code,
                 ErrorCode::Cancelled);
        QVERIFY(last >= 0.4);
        fs::create_directories(m_out);
        for (const fs::directory_entry& entry : fs::directory_iterator(m_out)) {
            const Asset& asset = *findAsset(project, entry.path().filename().string());
            QVERIFY(isExportOf(entry.path(), packSourceHash(project, asset, packNames(project).at({asset.id}), {})));
        }
    }
    void cancellingLateLeavesNoEmptyFolder() {
        // After the files of one are generated, before its folder is written.
        for (const int threads : {1, 2}) {
            TaskContext task;
            task.threads = threads;
            task.progress = [&](double fraction) {
                if (fraction >= 0.89 / threads) task.cancel.cancel();
            };
            const Project project =
                projectOf(threads == 1 ? std::vector<std::string>{"a"} : std::vector<std::string>{"a", "b"});
            QCOMPARE(exportPacks(project, allAssets(project), m_out / "deep", {}, EditedFiles::Kept, task).error().code,
                     ErrorCode::Cancelled);
            QVERIFY(!fs::exists(m_out));
        }
    }
    void progressGrowsToTheEnd() {
        const Project project = projectOf({"a", "b", "c"});
        TaskContext task;
        std::vector<double> reported;
        task.progress = [&](double fraction) { reported.push_back(fraction); };
        QVERIFY(exportPacks(project, allAssets(project), m_out, {}, EditedFiles::Kept, task));
        QVERIFY(std::ranges::is_sorted(reported));
        QVERIFY(reported.back() > 1.0 - 1e-9);
    }

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_out;
};

RUBBLE_TEST(PackExportTest)
#include "PackExportTest.moc"
