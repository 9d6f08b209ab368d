// Tests core/io/project/ProjectFile.cpp with the readers and writers of its parts: core/io/project/AssetJson.cpp,
// core/io/project/ColourJson.cpp, core/io/project/GreyImageJson.cpp, core/io/project/PatternJson.cpp,
// core/io/project/SceneJson.cpp, core/io/project/ShapingJson.cpp,
// core/io/project/ShotJson.cpp, core/io/project/StrengthRequirementJson.cpp, core/io/json/FormatVersion.cpp and
// core/io/json/VectorJson.cpp.
#include "core/asset/strength/Threshold.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/FileLimits.h"
#include "tests/support/files/JsonMutations.h"
#include "tests/support/files/Schemas.h"
#include "tests/support/files/WrongValues.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

namespace fs = std::filesystem;

constexpr const char* kEmptyProject = R"({
  "format": "rubble-project",
  "version": 5,
  "nextId": 2,
  "materials": [
    {
      "id": 1,
      "name": "brick",
      "density": 1000,
      "friction": 0.6,
      "restitution": 0,
      "tensileStrength": null,
      "fractureToughness": null,
      "outside": [0.8, 0.8, 0.8],
      "inside": [0.8, 0.8, 0.8]
    }
  ],
  "assets": [],
  "instances": [],
  "ground": {
    "on": true,
    "height": 0,
    "friction": 0.6,
    "restitution": 0
  },
  "gravity": [0, -9.81, 0],
  "damage": {
    "rule": "impact",
    "thesis": false,
    "thesisThreshold": 1000
  },
  "debris": {
    "lifetime": null,
    "fade": 1,
    "mostPieces": null
  },
  "shots": [],
  "playTests": []
}
)";

std::string projectFault(std::string_view text) { return errorText(readProjectText(text)); }

nlohmann::json fullJson() { return nlohmann::json::parse(projectText(fullProject())); }

/// Paths at which another type is valid, or none: optional values and keys.
bool isOptionalValue(const std::string& place, const nlohmann::json& value) {
    if (value.is_discarded()) {
        if (place == "shots[2].action.radius") return true;  // the hammer's
        if (place == "events" || place == "mortars" || place.ends_with("].state")) return true;
        if (place.ends_with(".bonding.clusters") || place.ends_with("].breakAs") || place.ends_with("].bonding") ||
            place.ends_with("bondStrength"))
            return true;
        return place.ends_with("].unbreakable") || place.ends_with("].anchored") ||
               place.ends_with("].youngsModulus") || place.ends_with("].fragmentThresholds") ||
               (place.find("].level") != std::string::npos && place.ends_with(".threshold"));
    }
    if (place.ends_with("].surface") || place.ends_with("].cutAtImpact")) return value.is_null();
    if (place.ends_with("].insideMaterial")) return value.is_null() || value == 1;
    if (place.starts_with("assets[0].leaves") && place.ends_with("].level")) return value.is_null();
    if (place.ends_with(".image") || place.ends_with(".opacity")) return value.is_null();
    if (place.ends_with(".bonding.strengthImage")) return value.is_null();
    if (place.ends_with(".bonding.impulsePerArea")) return value.is_null() || value.is_number();
    if (place == "debris.lifetime" || place == "debris.mostPieces") return value.is_null();
    const bool isStrength =
        place.ends_with("ensileStrength") || place.ends_with("fractureToughness") || place.ends_with("].contactTime");
    if (isStrength) return value.is_null() || value.is_number();
    const bool isOwnThreshold = place.starts_with("instances") && place.ends_with(".threshold");
    return isOwnThreshold && (value.is_null() || value.is_number());
}

/// Kinds of layers and their parameters, which the schema leaves to the program's own table.
bool isOfKind(const std::string& place) {
    return place.ends_with("].kind") || place.find("].parameters") != std::string::npos;
}

}  // namespace

class ProjectFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    fs::path inFolder(const char* name) const { return fs::path(m_folder.path().toStdString()) / name; }

private slots:
    void layoutIsReadable() {
        Project project;
        project.nextId = 2;
        project.materials = {{.id = 1, .name = "brick"}};
        QCOMPARE(projectText(project), std::string(kEmptyProject));
    }
    void removedPartsAreOptional() {
        Project project = fullProject();
        QVERIFY(projectText(project).find("\"removed\"") == std::string::npos);
        project.playTests[0].removed = {{project.instances[0].id, {}}, {project.instances[1].id, {"5.1", "5.2/6.0"}}};
        project.playTests[0].expectations = {{.kind = ExpectationKind::StaysUp, .value = 0.1},
                                             {.kind = ExpectationKind::HoleAtMost, .value = 0.5}};
        const Result<Project> read = readProjectText(projectText(project));
        QVERIFY2(read.hasValue(), errorText(read).c_str());
        QCOMPARE(read->playTests, project.playTests);
    }
    void wrongRemovedPartsAreRefused() {
        Project project = fullProject();
        const Id instance = project.instances[0].id;
        const auto fault = [&](const std::vector<InstancePart>& removed) {
            project.playTests[0].removed = removed;
            return errorText(readProjectText(projectText(project)));
        };
        QVERIFY2(fault({{4321, {}}}).find("instance 4321") != std::string::npos, fault({{4321, {}}}).c_str());
        QVERIFY(fault({{instance, {}}, {instance, {}}}).ends_with("must be in ascending order of instances."));
        QVERIFY(fault({{instance, {"5.2", "5.1"}}}).ends_with("must be in ascending order, and each there once."));
        QVERIFY(fault({{instance, {"five"}}}).ends_with("\"five\" is not the path of a fragment."));
    }
    void opacityIsOptional() {
        Project project = readProjectText(kEmptyProject).value();
        QCOMPARE(project.materials[0].opacity, 1.0);
        QVERIFY(projectText(project).find("opacity") == std::string::npos);
        project.materials[0].opacity = 0.25;
        const std::string text = projectText(project);
        QCOMPARE(readProjectText(text).value().materials[0].opacity, 0.25);
        QCOMPARE(test::Schema("project.schema.json").fault(nlohmann::json::parse(text)), std::string());
        project.materials[0].opacity = 0.0;
        QCOMPARE(errorText(readProjectText(projectText(project))),
                 std::string("Material 1 \"brick\": the opacity is 0, but it must be from 0.05 to 1."));
    }
    void countsAreOnOneLineAndPicturesOnOneLineARow() {
        const std::string text = projectText(fullProject());
        const char* const count = R"(
                "count": {"perSquareMetre": 8},
)";
        QVERIFY(text.find(count) != std::string::npos);
        const char* const picture = R"(
                "dense": "bright",
                "image": {
                  "width": 2,
                  "height": 2,
                  "bits": 8,
                  "grey": [
                    "007f",
                    "ffff"
                  ],
                  "opacity": [
                    "ffff",
                    "ff80"
                  ]
                }
)";
        QVERIFY(text.find(picture) != std::string::npos);
    }
    void picturesOf16BitsRoundTrip() {
        Project project = fullProject();
        auto& layer = std::get<DensityImage>(project.assets[0].levels[1].pattern.layers[6].parameters);
        layer.image =
            std::make_shared<GreyImage>(GreyImage{.width = 3, .height = 1, .bits = 16, .grey = {0, 0x12ab, 0xffff}});
        QVERIFY(projectText(project).find("\"000012abffff\"") != std::string::npos);
        QVERIFY(*readProjectText(projectText(project)) == project);
    }
    void cutsAndRequirementsAreOnOneLineEach() {
        const char* const lines = R"(
      "cutAtImpact": {"pieces": 17, "reach": 0.45},
      "intents": [
        {"outcome": "breaks", "kind": "hit", "mass": 2.5, "speed": 0.3333333333333333},
        {"outcome": "survives", "kind": "drop", "height": 1.75},
        {"outcome": "survives", "kind": "impulse", "impulse": 0.375},
        {"outcome": "holeAtMost", "hole": 0.625, "kind": "drop", "height": 2.5}
      ],
)";
        std::string text = projectText(fullProject());
        QVERIFY(text.find(lines) != std::string::npos);
        text.replace(text.find("holeAtMost"), 10, "survives");
        QVERIFY(
            errorText(readProjectText(text)).ends_with("intents[3].hole: belongs to the outcome \"holeAtMost\" only."));
    }
    void shapingIsOnOneLineEach() {
        const char* const lines = R"(
      "edits": [
        {"kind": "merge", "into": "4.2", "merged": ["6.5", "4.6"]},
        {"kind": "split", "fragment": "4.2/8.1", "point": [0.1, -2.5], "direction": [1, 0.3333333333333333]}
      ],
)";
        QVERIFY(projectText(fullProject()).find(lines) != std::string::npos);
    }
    void earlierOutlineOfALayerIsWrittenOnlyIfThereIsOne() {
        Project project = boxProject(UniformScatter{});
        QVERIFY(projectText(project).find("scatteredIn") == std::string::npos);
        project.assets[0].pattern.layers[0].scatteredIn = squareRing();
        const Result<Project> read = readProjectText(projectText(project));
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QVERIFY(*read == project);
    }
    void spatialParametersAndHeightsAreWrittenWhereNotDefaultOnly() {
        Project project = boxProject(JitteredGrid{});
        const nlohmann::json plain =
            nlohmann::json::parse(projectText(project))["assets"][0]["pattern"][0]["parameters"];
        QVERIFY(plain.contains("columns") && !plain.contains("layers") && !plain.contains("cellDepth"));
        PatternLayer& layer = project.assets[0].pattern.layers[0];
        layer.parameters = JitteredGrid{.layers = 4};
        layer.overrides = {{.index = 2, .position = {0.25, 0.5}, .height = -0.75}};
        project.assets[0].pattern.layers.push_back(
            {.id = project.nextId++, .parameters = PlacedSeeds{{{0, {0.1, 0.2}}, {3, {0.4, 0.3}, 0.5}}}});
        const std::string text = projectText(project);
        QVERIFY(text.find("\"layers\": 4") != std::string::npos && text.find("\"cellDepth\"") == std::string::npos);
        const Result<Project> read = readProjectText(text);
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QVERIFY(*read == project);
        QCOMPARE(test::Schema("project.schema.json").fault(nlohmann::json::parse(text)), std::string());
    }
    void everythingRoundTripsBitForBit() {
        const std::string text = projectText(fullProject());
        const Result<Project> read = readProjectText(text);
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QVERIFY(*read == fullProject());
        QCOMPARE(projectText(*read), text);
        QCOMPARE(read->assets[0].pattern.layers[0].randomSeed, ~std::uint64_t{0});
        QCOMPARE(read->assets[0].pattern.layers[2].randomSeed, std::uint64_t{9007199254740993u});
        QVERIFY(std::signbit(read->instances[1].pose.orientation.x));
    }
    void unbreakableIsWrittenWhereTrueOnly() {
        const nlohmann::json instances = fullJson()["instances"];
        QVERIFY(!instances[0].contains("unbreakable"));
        QVERIFY(instances[1]["unbreakable"] == true);
        nlohmann::json json = fullJson();
        json["instances"][1].erase("unbreakable");  // as in files written before there was such a key
        const Result<Project> read = readProjectText(json.dump());
        QVERIFY(read && read->instances[1].isFixed && !read->instances[1].isUnbreakable);
    }
    void radiusOfABlowIsOptional() {
        nlohmann::json json = fullJson();
        QVERIFY(json["shots"][2]["action"]["radius"] == 0.25);
        json["shots"][2]["action"].erase("radius");  // as in files written before there was such a key
        const Result<Project> read = readProjectText(json.dump());
        QVERIFY(read && !std::get<Hammer>(read->shots[2].action).radius);
        QVERIFY(nlohmann::json::parse(projectText(*read)) == json);
        json["shots"][2]["action"]["radius"] = 0.0;
        QVERIFY(!readProjectText(json.dump()));
    }
    void thresholdsFromTheCrossSectionAreRefused() {
        nlohmann::json json = fullJson();
        QVERIFY(json["assets"][0]["strengthRule"] == "bending" && !json["assets"][1].contains("strengthRule"));
        json["assets"][0]["strengthRule"] = "crossSection";
        QCOMPARE(projectFault(json.dump()),
                 std::string("assets[0].strengthRule: expected \"bending\", found \"crossSection\"."));
        json["assets"][0].erase("strengthRule");  // as the first files with derived thresholds
        QCOMPARE(projectFault(json.dump()),
                 std::string("assets[0]: the threshold follows from the cross-section, which is no longer supported; "
                             "add \"strengthRule\": \"bending\", or set \"contactTime\" to null."));
        json["assets"][0]["contactTime"] = nullptr;
        QVERIFY(readProjectText(json.dump()));
    }
    void thresholdsOfLevelsAndFragmentsAreWrittenWhereSetOnly() {
        nlohmann::json json = fullJson();
        QVERIFY(json["assets"][0]["levels"][0]["threshold"] == 17.25);
        QVERIFY(!json["assets"][0]["levels"][1].contains("threshold"));
        QVERIFY(json["assets"][0]["fragmentThresholds"][0] ==
                nlohmann::json({{"fragment", "4.3.1"}, {"threshold", 2.5}}));
        QVERIFY(!json["assets"][1].contains("fragmentThresholds"));
        json["assets"][0]["levels"][0].erase("threshold");  // as in files written before there were such keys
        json["assets"][0].erase("fragmentThresholds");
        const Result<Project> read = readProjectText(json.dump());
        QVERIFY(read && !read->assets[0].levels[0].threshold && read->assets[0].fragmentThresholds.empty());
        QVERIFY(nlohmann::json::parse(projectText(*read)) == json);
    }
    void keysAreReadInAnyOrder() {
        QVERIFY(*readProjectText(fullJson().dump()) == fullProject());  // sorted there
    }
    void writtenProjectsMatchTheSchema() {
        const test::Schema schema("project.schema.json");
        QCOMPARE(schema.fault(fullJson()), std::string());
        QCOMPARE(schema.fault(nlohmann::json::parse(projectText(Project{}))), std::string());
    }
    void everyWrongTypeIsReportedWithItsPath() {
        const test::Schema schema("project.schema.json");
        QCOMPARE(test::unreportedMutation(fullJson(), schema, isOptionalValue, projectFault, isOfKind), std::string());
    }
    void wrongValuesAreReported_data() {
        test::addWrongValueColumns();
        test::addWrongValue("format: expected \"rubble-project\", found \"rubble-pack\".", "/format",
                            "\"rubble-pack\"");
        test::addWrongValue("version: expected a whole number from 1 to 18446744073709551615, found 0.", "/version",
                            "0");
        test::addWrongValue(
            "The project has version 7, but this program reads versions up to 6; open it with a newer one.", "/version",
            "7");
        test::addWrongValue("nextId: expected a whole number from 0 to 4294967295, found 40.5.", "/nextId", "40.5");
        test::addWrongValue("materials[1].id: expected a whole number from 0 to 4294967295, found -1.",
                            "/materials/1/id", "-1");
        test::addWrongValue("gravity: expected an array of 3 numbers, found an array of 2.", "/gravity", "[0, 1]");
        test::addWrongValue("assets[0].prism.depth: expected a number, found \"two\".", "/assets/0/prism/depth",
                            "\"two\"");
        test::addWrongValue("assets[0].prism.outline[2]: expected an array of 2 numbers, found an array of 3.",
                            "/assets/0/prism/outline/2", "[1, 2, 3]");
        test::addWrongValue(
            "assets[0].pattern[0].kind: expected \"uniform\", \"blueNoise\", \"placed\", \"lloyd\", \"jitteredGrid\", "
            "\"clusters\", \"radial\", \"impact\", \"densityImage\", \"bricks\", \"slices\", \"strokes\", \"grain\", "
            "\"weightedLloyd\", \"hexagonal\", \"radialCracks\" or \"surfaceScatter\", found \"tiles\".",
            "/assets/0/pattern/0/kind", "\"tiles\"");
        test::addWrongValue("assets[0].pattern[0].parameters: unknown key \"count\".", "/assets/0/pattern/0/kind",
                            "\"placed\"");
        test::addWrongValue("assets[0].pattern[0].parameters.count: unknown key \"each\".",
                            "/assets/0/pattern/0/parameters/count", "{\"each\": 5}");
        test::addWrongValue("assets[0].pattern[0].parameters.count: unknown key \"perSquareMetre\".",
                            "/assets/0/pattern/0/parameters/count", "{\"perSquareMetre\": 5, \"pieceSize\": 1}");
        test::addWrongValue(
            "Asset 3 \"wall\": Layer 4: \"Count\" is -5 per square metre, but must be finite and above zero.",
            "/assets/0/pattern/0/parameters/count", "{\"perSquareMetre\": -5}");
        test::addWrongValue("assets[0].levels[1].pattern[6].parameters.image.bits: expected 8 or 16.",
                            "/assets/0/levels/1/pattern/6/parameters/image/bits", "12");
        test::addWrongValue(
            "assets[0].levels[1].pattern[6].parameters.image.grey[1]: expected 4 hexadecimal digits, 0 to f.",
            "/assets/0/levels/1/pattern/6/parameters/image/grey/1", "\"ffFF\"");
        test::addWrongValue("assets[0].levels[1].pattern[6].parameters.image.opacity: expected 2 rows.",
                            "/assets/0/levels/1/pattern/6/parameters/image/opacity", "[\"ffff\"]");
        test::addWrongValue("assets[0].surface.triangles[1].uvs: expected an array of 3 points.",
                            "/assets/0/surface/triangles/1/uvs", "[[0, 1], [1, 0]]");
        test::addWrongValue("shots[0].action: unknown key \"asset\".", "/shots/0/kind", "\"hammer\"");
        test::addWrongValue("Asset 3 \"wall\" refers to material 9, which does not exist.", "/assets/0/insideMaterial",
                            "9");
        test::addWrongValue(
            "assets[0].shaping.smallPieces.rule: expected \"keep\", \"merge\" or \"dropSeeds\", found \"eat\".",
            "/assets/0/shaping/smallPieces/rule", "\"eat\"");
        test::addWrongValue(
            "Asset 3 \"wall\": The minimum size of fragments is 2, but it must be above 0 and at most 1.",
            "/assets/0/shaping/smallPieces/limit", "2");
        test::addWrongValue(
            "Asset 3 \"wall\": The shape of fragments: the gap is -1, but it must be 0, or from 0.000001 to 10000.",
            "/assets/0/shaping/gap", "-1");
        test::addWrongValue("Asset 3 \"wall\": The roughness has 9 octaves, but it must have from 1 to 8.",
                            "/assets/0/shaping/roughness/octaves", "9");
        test::addWrongValue("Asset 3 \"wall\": \"4.x\" is not a fragment path.", "/assets/0/leaves/0/fragment",
                            "\"4.x\"");
        test::addWrongValue(
            "Asset 3 \"wall\": the settings of fragment 6.0 come after those of 6.0; paths must ascend.",
            "/assets/0/leaves/0/fragment", "\"6.0\"");
        test::addWrongValue(
            "Asset 3 \"wall\": the threshold of fragment 6.0 comes after that of 6.0; paths must ascend.",
            "/assets/0/fragmentThresholds/0/fragment", "\"6.0\"");
        test::addWrongValue("Asset 3 \"wall\": the threshold is -1, but it must be from 1e-09 to 1e+24.",
                            "/assets/0/fragmentThresholds/1/threshold", "-1");
        test::addWrongValue("Asset 3 \"wall\": the threshold is 0, but it must be from 1e-09 to 1e+24.",
                            "/assets/0/levels/0/threshold", "0");
        test::addWrongValue("Asset 3 \"wall\": the minimum volume is -1, but it must be from 0 to 1000000000000.",
                            "/assets/0/leaves/1/level/minimumVolume", "-1");
        test::addWrongValue("Asset 3 \"wall\": Fragment 6.5/8.0 cannot be merged into 4.2: they are not siblings.",
                            "/assets/0/edits/0/merged/0", "\"6.5/8.0\"");
        test::addWrongValue("assets[0].edits[0]: unknown key \"into\".", "/assets/0/edits/0/kind", "\"split\"");
        test::addWrongValue(
            "Asset 3 \"wall\": The line that splits fragment 4.2/8.1 has no direction, or is not finite.",
            "/assets/0/edits/1/direction", "[0, 0]");
        test::addWrongValue(
            "Material 2 \"gl\xc3\xa4ss \"2\"\\u000a\": the tensile strength is 0, but it must be from 1 to "
            "1000000000000.",
            "/materials/1/tensileStrength", "0");
        test::addWrongValue("materials[1].fractureToughness: expected a number, found \"high\".",
                            "/materials/1/fractureToughness", "\"high\"");
        test::addWrongValue("Asset 3 \"wall\": the contact time is -1, but it must be from 1e-09 to 1000.",
                            "/assets/0/contactTime", "-1");
        test::addWrongValue("assets[0].cutAtImpact: the key \"reach\" is missing.", "/assets/0/cutAtImpact",
                            "{\"pieces\": 5}");
        test::addWrongValue("assets[0].cutAtImpact.pieces: expected a whole number from 0 to 4294967295, found 2.5.",
                            "/assets/0/cutAtImpact/pieces", "2.5");
        test::addWrongValue("assets[0].intents[0]: unknown key \"mass\".", "/assets/0/intents/0/kind", "\"drop\"");
        test::addWrongValue("assets[0].intents[1]: the key \"mass\" is missing.", "/assets/0/intents/1",
                            "{\"outcome\": \"breaks\", \"kind\": \"hit\", \"speed\": 3}");
        test::addWrongValue("assets[0].intents[0].kind: expected \"drop\", \"hit\" or \"impulse\", found \"push\".",
                            "/assets/0/intents/0/kind", "\"push\"");
        test::addWrongValue(
            "assets[0].intents[1].outcome: expected \"survives\", \"breaks\" or \"holeAtMost\", found \"falls\".",
            "/assets/0/intents/1/outcome", "\"falls\"");
        test::addWrongValue("debris.mostPieces: expected a whole number from 0 to 4294967295, found -1.",
                            "/debris/mostPieces", "-1");
        test::addWrongValue("The debris: the fade is -1, but it must be from 0 to 1000000000.", "/debris/fade", "-1");
        test::addWrongValue("damage.rule: expected \"impact\" or \"momentum\", found \"thesis\".", "/damage/rule",
                            "\"thesis\"");
        test::addWrongValue("Asset 3 \"wall\" and Asset 3 \"box\" have the same id.", "/assets/1/id", "3");
        test::addWrongValue("Instance 21 \"right\" refers to asset 8, which does not exist.", "/instances/1/asset",
                            "8");
    }
    void wrongValuesAreReported() {
        QCOMPARE(projectFault(test::withWrongValue(fullJson())), std::string(QTest::currentDataTag()));
    }
    void repeatedPointsAreLeftOutAndReported() {
        const fs::path path = RUBBLE_SOURCE_DIR "/tests/corpus/Project/outlines-with-repeated-points.rubble";
        std::vector<Diagnostic> notes;
        const Result<Project> project = loadProject(path, &notes);
        QVERIFY2(project, project ? "" : project.error().message.c_str());
        const Polygon& frame = project->assets[0].prism().outline;
        QVERIFY((frame.outer == Ring{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
        QVERIFY((frame.holes.at(0) == Ring{{0.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}, {1.5, 0.5}}));
        QCOMPARE(notes.size(), std::size_t{2});
        QCOMPARE(notes[0].message, std::string("3 repeated points of the outline were left out."));
        QVERIFY(notes[0].code == DiagnosticCode::RepeatedPoint && notes[0].severity == Severity::Note);
        QCOMPARE(notes[0].place.asset, project->assets[0].id);
        QCOMPARE(notes[0].value, 3.0);
        QCOMPARE(notes[1].message, std::string("1 repeated point of the outline was left out."));
        QCOMPARE(notes[1].place.asset, project->assets[2].id);
        QVERIFY(saveProject(inFolder("clean.rubble"), *project));
        QVERIFY(*loadProject(inFolder("clean.rubble"), &notes) == *project);
        QVERIFY(notes.empty());
    }
    void faultsOfOutlinesWithRepeatedPointsSayHowPointsAreCounted() {
        nlohmann::json json = fullJson();
        json["assets"][1]["prism"]["outline"] = {{0, 0}, {0, 0}, {1, 1}, {1, 0}, {0, 1}};
        const std::string fault = projectFault(json.dump());
        QVERIFY2(fault.ends_with(" Points are counted without those that repeat others."), fault.c_str());
        json["assets"][1]["prism"]["outline"] = {{0, 0}, {0, 0}, {1, 0}, {0, 1}};
        json["materials"][0]["density"] = -5;
        QVERIFY2(!projectFault(json.dump()).ends_with("repeat others."), projectFault(json.dump()).c_str());
        json["assets"][1]["prism"]["outline"] = {{0, 0}, {1, 1}, {0, 0}, {0, 0}};
        QVERIFY(!projectFault(json.dump()).empty());
    }
    void truncatedTextIsRejected() {
        const std::string text = projectText(fullProject());
        for (std::size_t size = 7; size + 2 < text.size(); size += 7) {
            const std::string fault = projectFault(std::string_view(text).substr(0, size));
            QVERIFY2(fault.starts_with("The text is not JSON at line "), fault.c_str());
        }
    }
    void filesRoundTrip() {
        QVERIFY(saveProject(inFolder("full.rubble"), fullProject()));
        const Result<Project> project = loadProject(inFolder("full.rubble"));
        QVERIFY(project && *project == fullProject());
    }
    void errorsNameTheFile() {
        QCOMPARE(loadProject(inFolder("none.rubble")).error().code, ErrorCode::NotFound);
        QVERIFY(writeFileAtomically(inFolder("cut.rubble"), std::string_view(kEmptyProject).substr(0, 40)));
        const std::string fault = loadProject(inFolder("cut.rubble")).error().message;
        const std::string file = "Cannot read \"" + inFolder("cut.rubble").string() + "\": ";
        QVERIFY2(fault.starts_with(file + "The text is not JSON at line 3, column "), fault.c_str());
    }
    void invalidProjectIsNotSaved() {
        QVERIFY(saveProject(inFolder("old.rubble"), fullProject()));
        Project project = fullProject();
        project.materials[0].density = -1.0;
        const Status saved = saveProject(inFolder("old.rubble"), project);
        QCOMPARE(saved.error().message,
                 "Cannot write \"" + inFolder("old.rubble").string() +
                     "\": Material 1 \"brick\": the density is -1, but it must be from 0.001 to 1000000.");
        QVERIFY(*loadProject(inFolder("old.rubble")) == fullProject());
    }
    void fullDiskKeepsTheOldFile() {
        QVERIFY(saveProject(inFolder("disk.rubble"), Project{}));
        {
            const FileSizeLimit limit(1000);
            QCOMPARE(saveProject(inFolder("disk.rubble"), fullProject()).error().code, ErrorCode::Io);
        }
        QVERIFY(*loadProject(inFolder("disk.rubble")) == Project{});
        QCOMPARE(saveProject("/dev/full", Project{}).error().message,
                 std::string("Cannot write \"/dev/full\": it is a device, not a file."));
    }
    void readOnlyFolderKeepsTheOldFile() {
        fs::permissions(inFolder(""), fs::perms(0755));
        fs::create_directory(inFolder("locked"));
        QVERIFY(saveProject(inFolder("locked/old.rubble"), Project{}));
        fs::permissions(inFolder("locked/old.rubble"), fs::perms(0666));
        fs::permissions(inFolder("locked"), fs::perms(0555));
        {
            const AsNobody nobody;
            QCOMPARE(saveProject(inFolder("locked/old.rubble"), fullProject()).error().code, ErrorCode::Io);
            QVERIFY(*loadProject(inFolder("locked/old.rubble")) == Project{});
        }
        fs::permissions(inFolder("locked"), fs::perms(0755));
    }
};

RUBBLE_TEST(ProjectFileTest)
#include "ProjectFileTest.moc"
