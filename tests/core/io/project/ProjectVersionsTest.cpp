// Tests core/io/project/ProjectFile.cpp: files of older versions, and of newer ones.
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <nlohmann/json.hpp>

#include <QTemporaryDir>

using namespace rubble;

namespace {

namespace fs = std::filesystem;

std::string versionFault(const nlohmann::json& json) { return errorText(readProjectText(json.dump())); }

/// A project with all features of version 1.
nlohmann::json jsonOfVersion1() {
    return nlohmann::json::parse(*readFile(RUBBLE_SOURCE_DIR "/tests/corpus/Project/version-1.rubble"));
}

/// In version 2, without variants.
nlohmann::json jsonOfVersion2() {
    nlohmann::json json = jsonOfVersion1();
    json["version"] = 2;
    json["debris"] = {{"lifetime", nullptr}, {"fade", 1}, {"mostPieces", nullptr}};
    for (nlohmann::json& asset : json["assets"]) {
        asset["cutAtImpact"] = nullptr;
        asset["intents"] = nlohmann::json::array();
    }
    return json;
}

/// In version 3, without shaping.
nlohmann::json jsonOfVersion3() {
    nlohmann::json json = jsonOfVersion2();
    json["version"] = 3;
    for (nlohmann::json& instance : json["instances"]) {
        instance["variant"] = 0;
        instance["hidden"] = instance["locked"] = false;
    }
    return json;
}

/// In version 4, without strength.
nlohmann::json jsonOfVersion4() {
    nlohmann::json json = jsonOfVersion3();
    json["version"] = 4;
    for (nlohmann::json& asset : json["assets"]) {
        asset["insideMaterial"] = nullptr;
        asset["shaping"] = {{"smallPieces", {{"rule", "keep"}, {"measure", "partOfMean"}, {"limit", 0.1}}},
                            {"gap", 0},
                            {"roughness", {{"amplitude", 0}, {"frequency", 10}, {"octaves", 3}, {"randomSeed", 0}}}};
        asset["leaves"] = asset["edits"] = nlohmann::json::array();
    }
    return json;
}

/// In version 5.
nlohmann::json jsonOfVersion5() {
    nlohmann::json json = jsonOfVersion4();
    json["version"] = 5;
    for (nlohmann::json& material : json["materials"]) {
        material["tensileStrength"] = material["fractureToughness"] = nullptr;
    }
    for (nlohmann::json& asset : json["assets"]) asset["contactTime"] = nullptr;
    return json;
}

}  // namespace

class ProjectVersionsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    fs::path inFolder(const char* name) const { return fs::path(m_folder.path().toStdString()) / name; }

private slots:
    void newerVersionsAreRejected() {
        nlohmann::json json = nlohmann::json::parse(projectText(fullProject()));
        json["version"] = kProjectVersion + 1;
        json["a key of tomorrow"] = 1;  // the rest is not read
        QCOMPARE(readProjectText(json.dump()).error().code, ErrorCode::Unsupported);
    }
    void version1IsReadWithDefaults() {
        const Result<Project> project = readProjectText(jsonOfVersion1().dump());
        QVERIFY2(project, project ? "" : project.error().message.c_str());
        QVERIFY(project->debris == Debris{});
        for (const Asset& asset : project->assets) QVERIFY(!asset.cutAtImpact && asset.requirements.empty());
    }
    void version2IsReadWithDefaults() {
        const Result<Project> project = readProjectText(jsonOfVersion2().dump());
        QVERIFY2(project, project ? "" : project.error().message.c_str());
        QVERIFY(!project->instances.empty());
        for (const Instance& instance : project->instances) {
            QVERIFY(instance.variant == 0 && !instance.isHidden && !instance.isLocked);
        }
    }
    void version3IsReadWithDefaults() {
        const Result<Project> project = readProjectText(jsonOfVersion3().dump());
        QVERIFY2(project, project ? "" : project.error().message.c_str());
        for (const Asset& asset : project->assets) {
            QVERIFY(asset.shaping == Shaping{} && asset.fragmentLevels.empty() && asset.edits.empty());
            QCOMPARE(asset.insideMaterial, Id{0});
        }
    }
    void version4IsReadWithDefaults() {
        const Result<Project> project = readProjectText(jsonOfVersion4().dump());
        QVERIFY2(project, project ? "" : project.error().message.c_str());
        for (const Material& material : project->materials) {
            QVERIFY(!material.tensileStrength && !material.fractureToughness);
        }
        for (const Asset& asset : project->assets) QVERIFY(!asset.contactTime);
    }
    void olderVersionsAreSavedAsVersion5() {
        const nlohmann::json expected = jsonOfVersion5();
        for (const nlohmann::json& old : {jsonOfVersion1(), jsonOfVersion2(), jsonOfVersion3(), jsonOfVersion4()}) {
            QVERIFY(writeFileAtomically(inFolder("old.rubble"), old.dump()));
            const Result<Project> project = loadProject(inFolder("old.rubble"));
            QVERIFY(project && saveProject(inFolder("old.rubble"), *project));
            QVERIFY(nlohmann::json::parse(*readFile(inFolder("old.rubble"))) == expected);
            QVERIFY(*loadProject(inFolder("old.rubble")) == *project);
        }
    }
    void versionsAcceptOnlyTheirOwnKeys() {
        nlohmann::json json = jsonOfVersion1();
        json["debris"] = nlohmann::json::parse(projectText(fullProject()))["debris"];
        QCOMPARE(versionFault(json), std::string("The document: unknown key \"debris\"."));
        json = jsonOfVersion1();
        json["assets"][0]["intents"] = nlohmann::json::array();
        QCOMPARE(versionFault(json), std::string("assets[0]: unknown key \"intents\"."));
        json = jsonOfVersion1();
        json["version"] = 2;
        QCOMPARE(versionFault(json), std::string("The document: the key \"debris\" is missing."));
        json = jsonOfVersion2();
        json["instances"][0]["variant"] = 1;
        QCOMPARE(versionFault(json), std::string("instances[0]: unknown key \"variant\"."));
        json = jsonOfVersion2();
        json["version"] = 3;
        QCOMPARE(versionFault(json), std::string("instances[0]: the key \"variant\" is missing."));
        json = jsonOfVersion3();
        json["assets"][0]["leaves"] = nlohmann::json::array();
        QCOMPARE(versionFault(json), std::string("assets[0]: unknown key \"leaves\"."));
        json = jsonOfVersion3();
        json["version"] = 4;
        QCOMPARE(versionFault(json), std::string("assets[0]: the key \"insideMaterial\" is missing."));
        json = jsonOfVersion4();
        json["materials"][0]["tensileStrength"] = 1e6;
        QCOMPARE(versionFault(json), std::string("materials[0]: unknown key \"tensileStrength\"."));
        json = jsonOfVersion4();
        json["version"] = 5;
        QCOMPARE(versionFault(json), std::string("materials[0]: the key \"tensileStrength\" is missing."));
    }
};

RUBBLE_TEST(ProjectVersionsTest)
#include "ProjectVersionsTest.moc"
