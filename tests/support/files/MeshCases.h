#pragma once

#include "core/asset/import/AssetImport.h"
#include "core/geometry/polygon/Polygon.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/mesh/MeshImport.h"
#include "core/io/system/AtomicFile.h"

#include <QTest>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rubble::test {

// The meshes of tests/corpus/MeshCases, whose right values stand beside them.
inline const std::filesystem::path kMeshCases = RUBBLE_SOURCE_DIR "/tests/corpus/MeshCases";

struct ExpectedAsset {
    std::string name;
    double volume = 0.0;
    std::optional<Vec3> at;  // of the first instance
    std::size_t instances = 1;
};

struct MeshCase {
    std::string file, error;
    std::vector<ExpectedAsset> assets;
    std::vector<std::string> rejected, notes;
    double tolerance = 1e-4;  // relative of volumes, m of places
};

inline std::vector<std::string> textsOf(const JsonValue& value) {
    return value.isPresent() ? value.list(&JsonValue::text) : std::vector<std::string>();
}

inline ExpectedAsset assetOf(const JsonValue& value) {
    ExpectedAsset asset{value["name"].text(), value["volume"].number(), {}, value["instances"].index()};
    if (!value["at"].isPresent()) return asset;
    const auto [x, y, z] = value["at"].numbers<3>();
    asset.at = Vec3(x, y, z);
    return asset;
}

/// The case of a file, which must be there.
inline MeshCase caseOf(const std::string& file) {
    const Result<std::string> text = readFile(kMeshCases / "cases.json");
    if (!text) qFatal("%s", text.error().message.c_str());
    Result<JsonDocument> document = JsonDocument::parse(*text);
    if (!document) qFatal("%s", document.error().message.c_str());
    const JsonValue value = document->root()[file];
    if (!value.isPresent()) qFatal("cases.json does not have %s.", file.c_str());
    MeshCase found{.file = file, .rejected = textsOf(value["rejected"]), .notes = textsOf(value["notes"])};
    if (value["error"].isPresent()) found.error = value["error"].text();
    if (value["assets"].isPresent()) found.assets = value["assets"].list(assetOf);
    if (value["tolerance"].isPresent()) found.tolerance = value["tolerance"].number();
    if (document->firstError()) qFatal("%s", document->firstError()->message.c_str());
    return found;
}

/// Adds a row for each mesh of the folder with one of these suffixes to a test; all of them have a case.
inline void addMeshCases(const std::vector<std::string>& suffixes) {
    QTest::addColumn<QString>("file");
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kMeshCases)) {
        if (std::ranges::find(suffixes, entry.path().extension().string()) != suffixes.end())
            names.push_back(std::filesystem::relative(entry.path(), kMeshCases).string());
    }
    std::ranges::sort(names);
    for (const std::string& name : names) QTest::newRow(name.c_str()) << QString::fromStdString(name);
}

inline double volumeOf(const Prism& prism) {
    double area = std::abs(signedArea(prism.outline.outer));
    for (const auto& hole : prism.outline.holes) area -= std::abs(signedArea(hole));
    return area * prism.depth;
}

inline QStringList sentences(const std::vector<std::string>& texts) {
    QStringList list;
    for (const std::string& text : texts) list.append(QString::fromStdString(text));
    return list;
}

inline void compareAsset(const Project& project, const Asset& asset, const MeshCase& all, std::size_t index) {
    const ExpectedAsset& expected = all.assets[index];
    std::vector<Vec3> places;
    for (const Instance& instance : project.instances)
        if (instance.asset == asset.id) places.push_back(instance.pose.position);
    QCOMPARE(places.size(), expected.instances);
    const double volume = volumeOf(asset.prism());
    QVERIFY2(std::abs(volume - expected.volume) <= all.tolerance * expected.volume,
             qPrintable(QString::number(volume)));
    QVERIFY(!expected.at || glm::distance(places[0], *expected.at) <= all.tolerance);
}

/// Compares what the importer makes of a mesh with its values.
inline void compareMeshCase(const std::string& file) {
    const MeshCase expected = caseOf(file);
    const std::filesystem::path path = kMeshCases / expected.file;
    const Result<SourceScene> scene = importMesh(path, RUBBLE_IMPORTER, {});
    QCOMPARE(QString::fromStdString(scene ? "" : scene.error().message), QString::fromStdString(expected.error));
    if (!scene) return;
    QCOMPARE(sentences(scene->notes), sentences(expected.notes));

    const Result<ImportOutcome> outcome =
        importedInto({}, *scene, path.stem().string(), {.as = ImportShape::Prism}, {});
    QVERIFY2(outcome.hasValue(), outcome ? "" : outcome.error().message.c_str());
    std::vector<std::string> rejected, names, expectedNames;
    for (const RejectedObject& object : outcome->rejected) rejected.push_back(object.error.message);
    QCOMPARE(sentences(rejected), sentences(expected.rejected));
    const Project& project = outcome->project;
    for (const Asset& asset : project.assets) names.push_back(asset.name);
    for (const ExpectedAsset& asset : expected.assets) expectedNames.push_back(asset.name);
    QCOMPARE(sentences(names), sentences(expectedNames));
    for (std::size_t i = 0; i < names.size(); ++i) compareAsset(project, project.assets[i], expected, i);
}

}  // namespace rubble::test
