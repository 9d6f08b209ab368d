// Tests core/io/pack/SceneFile.cpp, core/io/output/OutputFiles.cpp, and the scenes of docs/formats/rubble_pack.hpp.
#include "core/asset/strength/Threshold.h"
#include "core/io/output/OutputFiles.h"
#include "core/io/pack/PackFile.h"
#include "core/io/pack/SceneFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "docs/formats/rubble_pack.hpp"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Schemas.h"

#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

using namespace rubble;

namespace {

Project projectNamed(const std::string& name) {
    return readProjectText(readFile(RUBBLE_SOURCE_DIR "/projects/" + name).value()).value();
}

}  // namespace

class SceneFileTest : public QObject {
    Q_OBJECT
private slots:
    void everyDemoFitsTheSchema() {
        const test::Schema schema("scene.schema.json");
        for (const char* name : {"house.rubble", "joined-house.rubble", "two-storey-house.rubble", "arcade.rubble"}) {
            const Project project = projectNamed(name);
            QVERIFY(hasScene(project));
            const std::string json = sceneFileJson(project, {});
            QCOMPARE(schema.fault(nlohmann::json::parse(json)), std::string());
            rubble_pack::Scene scene;
            std::string fault;
            QVERIFY2(rubble_pack::parseScene(json, scene, fault), fault.c_str());
            QCOMPARE(scene.instances.size(), project.instances.size());
        }
        QVERIFY(!hasScene(Project()));
    }
    void headerReadsWhereTheBlocksStand() {
        Project project = projectNamed("house.rubble");
        project.instances[0].threshold = 123.0;
        project.instances[0].variant = 2;
        project.instances[1].isFixed = true;
        rubble_pack::Scene scene;
        std::string fault;
        QVERIFY2(rubble_pack::parseScene(sceneFileJson(project, {}), scene, fault), fault.c_str());
        QCOMPARE(scene.instances.size(), std::size_t{77});
        const auto names = packNames(project);
        for (std::size_t k = 0; k < scene.instances.size(); ++k) {
            const Instance& ours = project.instances[k];
            const rubble_pack::SceneInstance& read = scene.instances[k];
            QCOMPARE(read.id, ours.id);
            QCOMPARE(read.name, ours.name);
            QCOMPARE(scene.packs[read.pack].folder, names.at(variantOf(ours)).folder);
            QCOMPARE(read.position.x, ours.pose.position.x);
            QCOMPARE(read.rotation.w, ours.pose.orientation.w);
            QCOMPARE(read.rotation.y, ours.pose.orientation.y);
            QCOMPARE(read.isFixed, ours.isFixed);
        }
        QCOMPARE(scene.instances[0].threshold, 123.0);
        QCOMPARE(scene.instances[1].threshold, thresholdOf(project, *findAsset(project, project.instances[1].asset)));
        QVERIFY(scene.ground && scene.gravity.y == -9.81);
        QCOMPARE(scene.ground->friction, project.ground.friction);
        QCOMPARE(scene.shots.size(), project.shots.size());
        QCOMPARE(scene.shots[0].speed, std::get<Throw>(project.shots[0].action).speed);
        QCOMPARE(scene.shots[0].mass, std::get<Throw>(project.shots[0].action).mass);
    }
    void hashesAreThoseOfThePacks() {
        const QTemporaryDir place;
        const std::filesystem::path out = place.path().toStdString();
        const Project project = projectNamed("house.rubble");
        std::vector<Id> assets;
        for (const Asset& asset : project.assets) assets.push_back(asset.id);
        const PackOptions options{.meshes = {.formats = {}}, .inset = 2e-4};
        QVERIFY(exportPacks(project, assets, out, options));
        rubble_pack::Scene scene;
        std::string fault;
        QVERIFY2(rubble_pack::parseScene(sceneFileJson(project, options), scene, fault), fault.c_str());
        for (const rubble_pack::ScenePack& pack : scene.packs) {
            rubble_pack::Pack read;
            QVERIFY2(rubble_pack::load((out / pack.folder / "pack.json").string(), read, fault), fault.c_str());
            QCOMPARE(read.physicsHash, pack.physicsHash);
        }
    }
    void packsOfOtherExportsAreFound() {
        const Project project = projectNamed("house.rubble");
        const std::string json = sceneFileJson(project, {});
        PackPhysicsHashes present;
        const nlohmann::json packs = nlohmann::json::parse(json)["packs"];
        for (const nlohmann::json& pack : packs)
            present[pack["folder"].get<std::string>()] = pack["physicsHash"].get<std::string>();
        present["another"] = "0123";
        QCOMPARE(scenePacksFault(json, present).value_or(""), std::string());
        const auto fault = [&](const PackPhysicsHashes& hashes) { return scenePacksFault(json, hashes).value_or(""); };
        const std::string used = packs[0]["folder"];
        PackPhysicsHashes other = present;
        other[used] = sceneSource(project, {}).hex();
        QCOMPARE(fault(other),
                 "The pack \"" + used + "\" is of another export than the scene; export all assets again.");
        present.erase(used);
        QCOMPARE(fault(present), "There is no pack \"" + used + "\", which the scene uses.");
        QVERIFY(scenePacksFault("{}", present) && scenePacksFault("", present));
    }
    void wrongScenesAreRefused() {
        const std::string json = sceneFileJson(projectNamed("house.rubble"), {});
        const auto faultWith = [&](const char* pointer, const nlohmann::json& value) {
            nlohmann::json changed = nlohmann::json::parse(json);
            changed[nlohmann::json::json_pointer(pointer)] = value;
            rubble_pack::Scene scene;
            std::string fault;
            return rubble_pack::parseScene(changed.dump(), scene, fault) ? std::string() : fault;
        };
        QCOMPARE(faultWith("/version", 2), std::string("version: this header reads version 1."));
        QCOMPARE(faultWith("/instances/3/pack", "door"),
                 std::string("instances[3].pack: \"door\" is no pack of the scene."));
        QCOMPARE(faultWith("/instances/3/fixed", 1), std::string("instances[3].fixed: expected true or false."));
        QCOMPARE(faultWith("/new", 1), std::string());
    }
    void editedFilesAreKept() {
        const QTemporaryDir place;
        const std::filesystem::path out = place.path().toStdString();
        const std::vector<ExportFile> first{{"scene.json", "one"}}, second{{"scene.json", "two"}};
        std::size_t announced = 0;
        const auto announce = [&](std::span<const ManifestEntry> entries) {
            announced = entries.size();
            return success();
        };
        const auto write = [&](const std::vector<ExportFile>& files, const std::vector<ManifestEntry>& listed,
                               EditedFiles edited = EditedFiles::Kept) {
            const ExportIndex index{.project = {.name = "p.rubble"}, .folders = {}, .files = listed};
            announced = 0;
            return writeOutputFiles(out, files, index, {.name = "p.rubble"}, edited, announce);
        };
        const auto entries = write(first, {});
        QCOMPARE(*readFile(out / "scene.json"), std::string("one"));
        QCOMPARE(announced, std::size_t{1});
        QVERIFY(write(first, *entries));
        QCOMPARE(announced, std::size_t{0});
        QVERIFY(write(second, *entries));
        QCOMPARE(announced, std::size_t{2});  // the old one, and the new
        QCOMPARE(*readFile(out / "scene.json"), std::string("two"));
        const auto refused = write(first, *entries);  // which lists "one"
        QVERIFY(!refused && refused.error().code == ErrorCode::Edited);
        QCOMPARE(*readFile(out / "scene.json"), std::string("two"));
        QVERIFY(writeOutputFiles(
                    out, first,
                    ExportIndex{.project = {.name = "other.rubble"}, .folders = {}, .files = *write(second, {})},
                    {.name = "p.rubble"}, EditedFiles::Kept, announce)
                    .error()
                    .code == ErrorCode::Edited);
        QVERIFY(write({}, {manifestEntry("scene.json", "one")}));  // an edited file is not removed
        QVERIFY(std::filesystem::exists(out / "scene.json"));
        QVERIFY(write({}, {manifestEntry("scene.json", "two")}));
        QVERIFY(!std::filesystem::exists(out / "scene.json"));
        QVERIFY(write(first, {}, EditedFiles::Replaced));
        QCOMPARE(*readFile(out / "scene.json"), std::string("one"));
    }
};

RUBBLE_TEST(SceneFileTest)
#include "SceneFileTest.moc"
