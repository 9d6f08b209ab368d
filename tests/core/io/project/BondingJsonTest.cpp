#include "core/io/project/BondingJson.h"

#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/BondedProject.h"
#include "tests/support/files/Schemas.h"
#include "tests/support/files/WrongValues.h"

#include <QTest>

using namespace rubble;

namespace {

nlohmann::json bondedJson() { return nlohmann::json::parse(projectText(fullProject())); }

}  // namespace

/// The rest of the project's file is tested by ProjectFileTest, also what bonds have in common with it.
class BondingJsonTest : public QObject {
    Q_OBJECT
private slots:
    void fileOfABondedProjectKeepsItsBytes() {
        const Result<std::string> text = readFile(RUBBLE_SOURCE_DIR "/tests/corpus/Project/bonded.rubble");
        QVERIFY(text);
        Project project = bondedProject();
        project.assets[0].bonding.clusters.clear();  // the file was written before there were clusters
        QCOMPARE(projectText(project), *text);
        QVERIFY(readProjectText(*text).value() == project);
    }
    void bondsAreWrittenWhereTheyDifferFromTheDefaultOnly() {
        const nlohmann::json full = bondedJson();
        QVERIFY(full["assets"][0]["breakAs"] == "bonded" && full["assets"][0]["bonding"].is_object());
        QVERIFY(!full["assets"][1].contains("breakAs") && !full["assets"][1].contains("bonding"));
        QVERIFY(!full["instances"][0].contains("anchored") && !full["instances"][0].contains("bondStrength"));
        QVERIFY(!full["assets"][0]["levels"][1].contains("bondStrength"));
        nlohmann::json json = full;  // as in files written before there were such keys
        json.erase("mortars");
        for (const char* key : {"breakAs", "bonding"}) json["assets"][0].erase(key);
        for (const char* key : {"anchored", "bondStrength"}) json["instances"][1].erase(key);
        json["assets"][0]["levels"][0].erase("bondStrength");
        const Result<Project> read = readProjectText(json.dump());
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QVERIFY(read->mortars.empty() && !read->instances[1].isAnchored && read->instances[1].bondStrength == 1.0);
        QVERIFY(read->assets[0].breakAs == BreakAs::Whole && read->assets[0].bonding == Bonding{});
        QCOMPARE(read->assets[0].levels[0].bondStrength, 1.0);
        QVERIFY(nlohmann::json::parse(projectText(*read)) == json);
    }
    void bondsOfAnAssetThatBreaksWholeAreKept() {
        Project project = fullProject();
        project.assets[0].breakAs = BreakAs::Whole;
        project.assets[1].breakAs = BreakAs::Bonded;
        const nlohmann::json json = nlohmann::json::parse(projectText(project));
        QVERIFY(!json["assets"][0].contains("breakAs") && json["assets"][0].contains("bonding"));
        QVERIFY(json["assets"][1].contains("breakAs") && !json["assets"][1].contains("bonding"));
        QCOMPARE(test::Schema("project.schema.json").fault(json), std::string());
        QVERIFY(*readProjectText(json.dump()) == project);
    }
    void strengthImageMayBeWithoutAPicture() {
        Project project = fullProject();
        project.assets[0].bonding.strengthImage->image = nullptr;
        QVERIFY(*readProjectText(projectText(project)) == project);
        project.assets[0].bonding.strengthImage.reset();
        project.assets[0].bonding.impulsePerArea.reset();
        const nlohmann::json json = nlohmann::json::parse(projectText(project));
        QVERIFY(json["assets"][0]["bonding"]["strengthImage"].is_null());
        QVERIFY(json["assets"][0]["bonding"]["impulsePerArea"].is_null());
        QCOMPARE(test::Schema("project.schema.json").fault(json), std::string());
        QVERIFY(*readProjectText(json.dump()) == project);
    }
    void layoutOfBondsIsReadable() {
        const char* const bonding = R"(
      "breakAs": "bonded",
      "bonding": {
        "impulsePerArea": 1234.5,
        "radius": 0.7,
        "falloff": "smooth",
        "damageFrom": 0.3333333333333333,
        "span": 1.25,
        "collapseDelay": 0.75,
        "minimumIsland": 3,
        "strokes": [
          {
            "brush": "strength",
            "erasing": false,
            "strength": 2.5,
            "radius": 0.2,
            "points": [
              [0.25, 0.3333333333333333]
            ]
          },
)";
        const char* const heights = R"(
        "heightStrengths": [
          {"height": 0.25, "factor": 3},
          {"height": 0.5, "factor": 0.125}
        ],
        "strengthImage": {
          "darkest": 0.25,
          "brightest": 4,
)";
        const char* const clusters = R"(
        "clusters": [
          {
            "level": 0,
            "fragments": [
              "4.1",
              "4.2",
              "4.3"
            ]
          },
          {
            "level": 1,
            "fragments": [
              "4.2",
              "4.3"
            ]
          }
        ]
)";
        const char* const mortar = R"(
    {
      "id": 24,
      "name": "joints",
      "instances": [20, 21],
      "tolerance": 0.001953125,
      "leastArea": 0.3333333333333333,
      "impulsePerArea": 62.5
    }
)";
        const std::string text = projectText(fullProject());
        for (const char* lines : {bonding, heights, clusters, mortar})
            QVERIFY2(text.find(lines) != std::string::npos, lines);
    }
    void wrongValuesAreReported_data() {
        test::addWrongValueColumns();
        test::addWrongValue("assets[0].breakAs: expected \"whole\" or \"bonded\", found \"glued\".",
                            "/assets/0/breakAs", "\"glued\"");
        test::addWrongValue(
            "assets[0].bonding.falloff: expected \"constant\", \"linear\" or \"smooth\", found \"steep\".",
            "/assets/0/bonding/falloff", "\"steep\"");
        test::addWrongValue("assets[0].bonding: the key \"radius\" is missing.", "/assets/0/bonding",
                            "{\"impulsePerArea\": null}");
        test::addWrongValue(
            "assets[0].bonding.strokes[1].brush: expected \"anchor\", \"strength\" or \"neverBreaks\", found \"glue\".",
            "/assets/0/bonding/strokes/1/brush", "\"glue\"");
        test::addWrongValue("assets[0].bonding.strokes[1]: unknown key \"from\".", "/assets/0/bonding/strokes/1/from",
                            "1");
        test::addWrongValue("assets[0].bonding.strengthImage.image.grey[1]: expected 4 hexadecimal digits, 0 to f.",
                            "/assets/0/bonding/strengthImage/image/grey/1", "\"ff\"");
        test::addWrongValue("Asset 3 \"wall\": bond stroke 1 has no points, but it must have at least one.",
                            "/assets/0/bonding/strokes/1/points", "[]");
        test::addWrongValue(
            "Asset 3 \"wall\": the bond strength at height 0.25 comes after that at height 0.25; heights must ascend.",
            "/assets/0/bonding/heightStrengths/1/height", "0.25");
        test::addWrongValue("Asset 3 \"wall\": fragment 4.1, which never breaks, comes after 4.4; paths must ascend.",
                            "/assets/0/bonding/neverBreaks", "[\"4.4\", \"4.1\"]");
        test::addWrongValue("assets[0].bonding.clusters[0]: the key \"level\" is missing.",
                            "/assets/0/bonding/clusters/0", "{\"fragments\": [\"4.1\"]}");
        test::addWrongValue("assets[0].bonding.clusters[1]: unknown key \"name\".", "/assets/0/bonding/clusters/1/name",
                            "\"roof\"");
        test::addWrongValue("Asset 3 \"wall\": cluster 1: fragment 4.3 is in another cluster of level 1 already.",
                            "/assets/0/bonding/clusters/0", "{\"level\": 1, \"fragments\": [\"4.1\", \"4.3\"]}");
        test::addWrongValue("Mortar 24 \"joints\" refers to instance 8, which does not exist.",
                            "/mortars/1/instances/0", "8");
        test::addWrongValue("mortars[0]: the key \"name\" is missing.", "/mortars/0", "{\"id\": 3}");
    }
    void wrongValuesAreReported() {
        QCOMPARE(errorText(readProjectText(test::withWrongValue(bondedJson()))), std::string(QTest::currentDataTag()));
    }
};

RUBBLE_TEST(BondingJsonTest)
#include "BondingJsonTest.moc"
