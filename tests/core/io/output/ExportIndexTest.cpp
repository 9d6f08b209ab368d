#include "core/io/output/ExportIndex.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/Schemas.h"

#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

using namespace rubble;

namespace {

namespace fs = std::filesystem;

const ExportIndex kHouseIndex{
    .project = {.name = "house.rubble"}, .folders = {"wall", "roof", "old"}, .files = {{"scene.json", 12, "ab"}}};
const std::vector<std::string> kHouseFolders{"wall", "gable", "roof"};

/// An output folder with a text as its index.
fs::path folderWith(const QTemporaryDir& place, const std::string& text) {
    const fs::path folder = place.path().toStdString();
    std::ofstream(folder / kIndexName) << text;
    return folder;
}

Status setIndex(const fs::path& folder, const ExportIndex& index) {
    return changeExportIndex(folder, [&index](const std::optional<ExportIndex>&) { return index; });
}

}  // namespace

class ExportIndexTest : public QObject {
    Q_OBJECT
private slots:
    void indexIsReadAsWritten() {
        const QTemporaryDir place;
        const fs::path folder = place.path().toStdString();
        QVERIFY(!readExportIndex(folder)->has_value());
        QVERIFY(setIndex(folder, kHouseIndex).hasValue());
        QVERIFY(**readExportIndex(folder) == kHouseIndex);
    }
    void indexFitsTheSchema() {
        const test::Schema schema("export.schema.json");
        QCOMPARE(schema.fault(nlohmann::json::parse(exportIndexJson(kHouseIndex))), "");
        QCOMPARE(schema.fault(nlohmann::json::parse(exportIndexJson({}))), "");
        QVERIFY(!schema.fault(nlohmann::json::parse(R"({"format": "rubble-export", "version": 1})")).empty());
    }
    void sameIndexIsNotWrittenAgain() {
        const QTemporaryDir place;
        const fs::path folder = place.path().toStdString();
        QVERIFY(setIndex(folder, kHouseIndex).hasValue());
        const fs::file_time_type before = fs::last_write_time(folder / kIndexName) - std::chrono::hours(1);
        fs::last_write_time(folder / kIndexName, before);
        QVERIFY(setIndex(folder, kHouseIndex).hasValue());
        QVERIFY(fs::last_write_time(folder / kIndexName) == before);
        QVERIFY(setIndex(folder, {.project = {.name = "house.rubble"}, .folders = {}, .files = {}}).hasValue());
        QVERIFY(fs::last_write_time(folder / kIndexName) != before);
    }
    void emptyIndexIsNotCreated() {
        const QTemporaryDir place;
        const fs::path folder = place.path().toStdString();
        QVERIFY(setIndex(folder, {.project = {.name = "house.rubble"}, .folders = {}, .files = {}}).hasValue());
        QVERIFY(!fs::exists(folder / kIndexName));
    }
    void otherFilesAreNotReplaced() {
        const QTemporaryDir place;
        const fs::path folder = folderWith(place, "mine");
        QVERIFY(!setIndex(folder, kHouseIndex).hasValue());
        QCOMPARE(fs::file_size(folder / kIndexName), 4U);
    }
    void otherFilesAreRefused_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isNewer");
        QTest::newRow("no JSON") << "notes" << false;
        QTest::newRow("no object") << "[1]" << false;
        QTest::newRow("empty") << "{}" << false;
        QTest::newRow("no version") << R"({"format": "rubble-export"})" << false;
        QTest::newRow("another format") << R"({"format": "rubble-manifest", "version": 1})" << false;
        QTest::newRow("a newer version") << R"({"format": "rubble-export", "version": 2, "more": 1})" << true;
        QTest::newRow("a missing key") << R"({"format": "rubble-export", "version": 1, "project": "a", "folders": []})"
                                       << false;
        for (const char* name : {"../secret", "a/b", "..", ".", "", "/etc"}) {
            QTest::addRow("the folder %s", name)
                << QString(
                       R"({"format": "rubble-export", "version": 1, "project": "a", "folders": ["%1"], "files": []})")
                       .arg(name)
                << false;
            QTest::addRow("the file %s", name) << QString(R"({"format": "rubble-export", "version": 1, "project": "a",
                "folders": [], "files": [{"name": "%1", "size": 1, "hash": ""}]})")
                                                      .arg(name)
                                               << false;
        }
    }
    void otherFilesAreRefused() {
        QFETCH(const QString, text);
        QFETCH(const bool, isNewer);
        const QTemporaryDir place;
        const auto index = readExportIndex(folderWith(place, text.toStdString()));
        QVERIFY(!index.hasValue());
        QVERIFY(index.error().code == (isNewer ? ErrorCode::Unsupported : ErrorCode::BadInput));
        QVERIFY2(index.error().message.find("export.json\" is not the index of an export: ") != std::string::npos,
                 index.error().message.c_str());
    }
    void staleFoldersHaveNoAsset() {
        QVERIFY(staleFolders(kHouseIndex, {"house.rubble", {}}, kHouseFolders) == std::vector<std::string>{"old"});
        QVERIFY(staleFolders(kHouseIndex, {"barn.rubble", {}}, kHouseFolders).empty());
        QVERIFY(staleFolders(std::nullopt, {"house.rubble", {}}, kHouseFolders).empty());
    }
    void identityTellsProjectsOfOneNameApart() {
        const ExportIndex index{.project = {"house.rubble", "aa"}, .folders = {"old"}, .files = {}};
        QVERIFY(isIndexOf(index, {"house.rubble", "aa"}));
        QVERIFY(isIndexOf(index, {"renamed.rubble", "aa"}));
        QVERIFY(isIndexOf(index, {"house.rubble", ""}));  // before it had one
        QVERIFY(!isIndexOf(index, {"barn.rubble", ""}));
        QVERIFY(!isIndexOf(index, {"house.rubble", "bb"}));
        QVERIFY(staleFolders(index, {"house.rubble", "bb"}, kHouseFolders).empty());
        const QTemporaryDir place;
        QVERIFY(setIndex(place.path().toStdString(), index).hasValue());
        QVERIFY(**readExportIndex(place.path().toStdString()) == index);
    }
    void indexKeepsWhatWasExportedBefore() {
        const std::vector<std::string> kept{"old"};
        const ExportIndex index = indexAfterExport(kHouseIndex, {"house.rubble", {}}, kHouseFolders, {"gable"}, kept);
        QVERIFY((index.folders == std::vector<std::string>{"wall", "gable", "roof", "old"}));
        QVERIFY(index.files == kHouseIndex.files);
    }
    void indexOfAnotherProjectIsReplaced() {
        const ExportIndex index = indexAfterExport(kHouseIndex, {"barn.rubble", {}}, kHouseFolders, {"roof"}, {});
        QVERIFY((index == ExportIndex{.project = {.name = "barn.rubble"}, .folders = {"roof"}, .files = {}}));
        QVERIFY((indexAfterExport(std::nullopt, {"a", {}}, kHouseFolders, {}, {}) ==
                 ExportIndex{.project = {.name = "a"}, .folders = {}, .files = {}}));
    }
};

RUBBLE_TEST(ExportIndexTest)
#include "ExportIndexTest.moc"
