#include "core/io/project/ProjectDifferenceJson.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <nlohmann/json.hpp>

using namespace rubble;

namespace {

nlohmann::json differenceJson(const ProjectDifference& difference) {
    return nlohmann::json::parse(projectDifferenceJson(difference));
}

}  // namespace

class ProjectDifferenceJsonTest : public QObject {
    Q_OBJECT
private slots:
    void equalProjectsAreTheSame() {
        const nlohmann::json json = differenceJson({});
        QCOMPARE(json["isSame"].get<bool>(), true);
        QVERIFY(json["assets"].empty() && json["settings"].empty());
    }
    void stateIsThatOfThePair() {
        Asset front;
        front.name = "front";
        const auto stateOf = [&](const Asset* before, const Asset* after) {
            ProjectDifference difference;
            difference.assets.push_back({.pair = {before, after}, .recipe = {}, .fragments = {}});
            return differenceJson(difference)["assets"][0]["state"].get<std::string>();
        };
        QCOMPARE(stateOf(&front, &front), "same");
        QCOMPARE(stateOf(nullptr, &front), "added");
        QCOMPARE(stateOf(&front, nullptr), "gone");
    }
    void changesAreWritten() {
        Asset front;
        front.name = "front";
        ProjectDifference difference;
        AssetDifference& asset = difference.assets.emplace_back();
        asset.pair = {&front, &front};
        asset.recipe.push_back({"depth", "1 m", ""});
        LevelDifference& level = asset.fragments.levels.emplace_back();
        level.before = 3;
        level.after = 4;
        level.changed[static_cast<std::size_t>(FragmentChange::Moved)] = 2;
        asset.fragments.fragments.push_back({.path = "5.17",
                                             .change = FragmentChange::Moved,
                                             .before = 0,
                                             .after = 1,
                                             .shift = 0.25,
                                             .volumeBefore = 0.5,
                                             .volumeAfter = 0.75});
        const nlohmann::json json = differenceJson(difference), &first = json["assets"][0];
        QCOMPARE(json["isSame"].get<bool>(), false);
        QCOMPARE(first["state"].get<std::string>(), "changed");
        QVERIFY(first["recipe"][0] == (nlohmann::json{{"what", "depth"}, {"before", "1 m"}, {"after", nullptr}}));
        QCOMPARE(first["levels"][0]["moved"].get<int>(), 2);
        QCOMPARE(first["levels"][0]["after"].get<int>(), 4);
        QVERIFY(
            first["pieces"][0] ==
            (nlohmann::json{
                {"path", "5.17"}, {"change", "moved"}, {"shift", 0.25}, {"volumeBefore", 0.5}, {"volumeAfter", 0.75}}));
    }
    void addedFragmentHasOneVolume() {
        Asset front;
        ProjectDifference difference;
        AssetDifference& asset = difference.assets.emplace_back();
        asset.pair = {&front, &front};
        asset.fragments.fragments.push_back(
            {.path = "5.3", .change = FragmentChange::Added, .after = 1, .volumeAfter = 0.75});
        QVERIFY(differenceJson(difference)["assets"][0]["pieces"][0] ==
                (nlohmann::json{{"path", "5.3"}, {"change", "added"}, {"volumeAfter", 0.75}}));
    }
};

RUBBLE_TEST(ProjectDifferenceJsonTest)
#include "ProjectDifferenceJsonTest.moc"
