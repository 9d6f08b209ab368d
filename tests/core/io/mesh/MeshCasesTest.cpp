// Tests the importer with the meshes of tests/corpus/MeshCases, whose right values stand beside them.
#include "core/asset/import/AssetImport.h"
#include "core/geometry/polygon/Polygon.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/mesh/MeshImport.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <filesystem>
#include <optional>
#include <vector>

using namespace rubble;

namespace {

const std::filesystem::path kCases = RUBBLE_SOURCE_DIR "/tests/corpus/MeshCases";

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

std::vector<std::string> textsOf(const JsonValue& value) {
    return value.isPresent() ? value.list(&JsonValue::text) : std::vector<std::string>();
}

ExpectedAsset assetOf(const JsonValue& value) {
    ExpectedAsset asset{value["name"].text(), value["volume"].number(), {}, value["instances"].index()};
    if (!value["at"].isPresent()) return asset;
    const auto [x, y, z] = value["at"].numbers<3>();
    asset.at = Vec3(x, y, z);
    return asset;
}

/// The case of a file, which must be there.
MeshCase caseOf(const std::string& file) {
    const Result<std::string> text = readFile(kCases / "cases.json");
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

/// The meshes of the folder, all of which have a case.
std::vector<std::string> meshes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kCases)) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".gltf" || ending == ".glb" || ending == ".obj" || ending == ".stl" || ending == ".ply")
            names.push_back(std::filesystem::relative(entry.path(), kCases).string());
    }
    std::ranges::sort(names);
    return names;
}

double volumeOf(const Prism& prism) {
    double area = std::abs(signedArea(prism.outline.outer));
    for (const auto& hole : prism.outline.holes) area -= std::abs(signedArea(hole));
    return area * prism.depth;
}

QStringList sentences(const std::vector<std::string>& texts) {
    QStringList list;
    for (const std::string& text : texts) list.append(QString::fromStdString(text));
    return list;
}

}  // namespace

class MeshCasesTest : public QObject {
    Q_OBJECT
private slots:
    void everyMeshIsWhatItsValuesSay_data() {
        QTest::addColumn<QString>("file");
        for (const std::string& name : meshes()) QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
    void everyMeshIsWhatItsValuesSay() {
        QFETCH(const QString, file);
        const MeshCase expected = caseOf(file.toStdString());
        const std::filesystem::path path = kCases / expected.file;
        const Result<SourceScene> scene = importMesh(path, RUBBLE_IMPORTER, {});
        QCOMPARE(QString::fromStdString(scene ? "" : scene.error().message), QString::fromStdString(expected.error));
        if (!scene) return;
        QCOMPARE(sentences(scene->notes), sentences(expected.notes));

        const Result<ImportOutcome> outcome = importedInto({}, *scene, path.stem().string(), {}, {});
        QVERIFY2(outcome.hasValue(), outcome ? "" : outcome.error().message.c_str());
        std::vector<std::string> rejected, names, expectedNames;
        for (const RejectedObject& object : outcome->rejected) rejected.push_back(object.error.message);
        QCOMPARE(sentences(rejected), sentences(expected.rejected));
        const Project& project = outcome->project;
        for (const Asset& asset : project.assets) names.push_back(asset.name);
        for (const ExpectedAsset& asset : expected.assets) expectedNames.push_back(asset.name);
        QCOMPARE(sentences(names), sentences(expectedNames));
        for (std::size_t i = 0; i < names.size(); ++i) compare(project, project.assets[i], expected, i);
    }

private:
    static void compare(const Project& project, const Asset& asset, const MeshCase& all, std::size_t index) {
        const ExpectedAsset& expected = all.assets[index];
        std::vector<Vec3> places;
        for (const Instance& instance : project.instances)
            if (instance.asset == asset.id) places.push_back(instance.pose.position);
        QCOMPARE(places.size(), expected.instances);
        const double volume = volumeOf(asset.prism);
        QVERIFY2(std::abs(volume - expected.volume) <= all.tolerance * expected.volume,
                 qPrintable(QString::number(volume)));
        QVERIFY(!expected.at || glm::distance(places[0], *expected.at) <= all.tolerance);
    }
};

RUBBLE_TEST(MeshCasesTest)
#include "MeshCasesTest.moc"
