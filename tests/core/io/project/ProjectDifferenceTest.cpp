// Tests core/io/project/ProjectDifference.cpp.
#include "core/base/Random.h"
#include "core/io/project/ProjectDifference.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/fracture/PatternSamples.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <set>

using namespace rubble;

namespace {

using Json = nlohmann::json;

/// A project with all features and all kinds of layers.
Project richProject() {
    Project project = fullProject();
    for (const LayerParameters& parameters : patternSamples())
        project.assets[0].pattern.layers.push_back({.id = project.nextId++, .randomSeed = 3, .parameters = parameters});
    return project;
}

/// The positions of all values that are no containers, and of all elements of lists.
std::vector<Json::json_pointer> placesIn(const Json& value, const Json::json_pointer& at = Json::json_pointer()) {
    std::vector<Json::json_pointer> places;
    const auto addAll = [&](const Json& child, const Json::json_pointer& place) {
        if (!child.is_structured() || value.is_array()) places.push_back(place);
        const auto inner = placesIn(child, place);
        places.insert(places.end(), inner.begin(), inner.end());
    };
    if (value.is_object())
        for (const auto& [key, child] : value.items()) addAll(child, at / key);
    if (value.is_array())
        for (std::size_t k = 0; k < value.size(); ++k) addAll(value[k], at / k);
    return places;
}

/// All words that the schema has for enumerations, and all ids of the project.
std::vector<Json> othersFor(const Json& value, Random& random) {
    if (value.is_boolean()) return {!value.get<bool>()};
    if (value.is_null()) return {1, 0.25, 2};
    if (value.is_number_integer())
        return {value.get<std::int64_t>() + 1, value.get<std::int64_t>() - 1, 1, 2, 3, nullptr};
    if (value.is_number()) return {value.get<double>() * (1.0 + 1e-9 * random.between(1.0, 1e9)), 0.5, nullptr};
    if (!value.is_string()) return {nullptr};
    std::vector<Json> words{value.get<std::string>() + "x"};
    for (const char* word :
         {"momentum", "impact",    "survives", "breaks",    "outline",  "box",          "boundingBox",    "ball",
          "plank",    "merge",     "keep",     "dropSeeds", "area",     "volume",       "partOfMean",     "partOfWhole",
          "stack",    "stretcher", "bright",   "dark",      "strength", "crossSection", "standsUntouched"})
        words.push_back(word);
    return words;
}

/// Changes or removes one value of a project's JSON; nothing if no project results, or the same one.
std::optional<Project> mutated(const Json& json, const std::string& text, const Json::json_pointer& place,
                               Random& random) {
    std::vector<Json> others = othersFor(json.at(place), random);
    const std::uint32_t first = static_cast<std::uint32_t>(random.below(others.size() + 1));
    for (std::size_t k = 0; k <= others.size(); ++k) {
        const std::size_t which = (first + k) % (others.size() + 1);
        Json changed = json;
        if (which < others.size()) {
            changed[place] = others[which];
        } else {
            Json& parent = changed[place.parent_pointer()];
            if (!parent.is_array()) continue;
            parent.erase(std::stoul(place.back()));
        }
        Result<Project> project = readProjectText(changed.dump());
        if (project && projectText(*project) != text) return std::move(*project);
    }
    return std::nullopt;
}

bool isSame(const Project& before, const Project& after) {
    if (!settingChanges(before, after).empty()) return false;
    for (const AssetPair& pair : assetPairs(before, after)) {
        if (!pair.before || !pair.after) return false;
        if (!assetChanges(before, *pair.before, after, *pair.after).empty()) return false;
    }
    return true;
}

QString joined(const std::vector<RecipeChange>& changes) {
    std::string text;
    for (const RecipeChange& change : changes) text += sentenceOf(change) + '\n';
    return QString::fromStdString(text);
}

}  // namespace

class ProjectDifferenceTest : public QObject {
    Q_OBJECT
private slots:
    void equalProjectsAreTheSame() {
        QVERIFY(isSame(fullProject(), fullProject()));
        QVERIFY(isSame(richProject(), richProject()));
    }
    void everyChangedValueIsFound() {
        constexpr std::uint64_t kSeed = 20261125;
        constexpr int kChanges = 500;
        const Project project = richProject();
        const std::string text = projectText(project);
        const Json json = Json::parse(text);
        const std::vector<Json::json_pointer> places = placesIn(json);
        Random random(kSeed);
        std::set<std::string> kept;
        int changes = 0, tried = 0;
        while (changes < kChanges) {
            const Json::json_pointer place = places[random.below(places.size())];
            ++tried;
            const std::optional<Project> other = mutated(json, text, place, random);
            if (!other) {
                kept.insert(place.to_string());
                continue;
            }
            ++changes;
            QVERIFY2(!isSame(project, *other), (place.to_string() + " is not compared").c_str());
            QVERIFY2(!isSame(*other, project), (place.to_string() + " is not compared backwards").c_str());
        }
        qInfo("seed %llu: %d changes in %d attempts at %zu places, %zu of them cannot change alone",
              static_cast<unsigned long long>(kSeed), changes, tried, places.size(), kept.size());
        QVERIFY(tried < 3 * kChanges);
    }
    /// Every value once: what can change alone is found.
    void everyPlaceIsCompared() {
        const Project project = fullProject();
        const std::string text = projectText(project);
        const Json json = Json::parse(text);
        Random random(1);
        for (const Json::json_pointer& place : placesIn(json)) {
            const std::optional<Project> other = mutated(json, text, place, random);
            if (other) QVERIFY2(!isSame(project, *other), (place.to_string() + " is not compared").c_str());
        }
    }
    void changesAreNamed() {
        const Project before = boxProject(UniformScatter{.count = 2});
        Project after = before;
        after.ground.friction = 0.25;
        after.materials[0].restitution = 0.5;
        after.instances.push_back({.id = after.nextId++, .name = "door", .asset = after.assets[0].id});
        QCOMPARE(joined(settingChanges(before, after)),
                 "material \"stone\", restitution: 0.5, was 0\n"
                 "instance \"door\" added: asset box, position [0, 0, 0], orientation [1, 0, 0, 0], threshold none, "
                 "fixed off, variant 0, hidden off, locked off\n"
                 "ground, friction: 0.25, was 0.6\n");
        Project moved = after;
        moved.instances.back().pose.position = {1.0, 2.0, 3.0};
        QCOMPARE(joined(settingChanges(after, moved)), "instance \"door\", position: [1, 2, 3], was [0, 0, 0]\n");
    }
    void mortarsAreNamed() {
        const Project before = fullProject();
        Project after = before;
        after.mortars[1].instances = {20};
        after.mortars.erase(after.mortars.begin());
        QCOMPARE(joined(settingChanges(before, after)),
                 "mortar \"all\" removed: instance none, tolerance 0.005, least area 0.0001, impulse per area 500\n"
                 "mortar \"joints\", instance: [left], was [left, right]\n");
        Project none = after;
        none.mortars.clear();
        QCOMPARE(
            joined(settingChanges(none, after)),
            "mortar \"joints\" added: instance [left], tolerance 0.001953125, least area 0.3333333333333333, impulse "
            "per area 62.5\n");
    }
    void sameNameWithAnotherIdIsMatched() {
        const Project before = fullProject();
        Project after = before;
        after.shots.back().id = after.nextId++;
        for (PlayTest& test : after.playTests)
            std::ranges::replace(test.shots, before.shots.back().id, after.shots.back().id);
        const QString changes = joined(settingChanges(before, after));
        QVERIFY2(changes.contains("id: " + QString::number(after.shots.back().id) + ", was "), qPrintable(changes));
    }
    void nextIdAloneIsADifference() {
        const Project before = fullProject();
        Project after = before;
        ++after.nextId;
        QCOMPARE(settingChanges(before, after).size(), std::size_t{1});
        after.ground.isOn = !after.ground.isOn;
        QCOMPARE(settingChanges(before, after).size(), std::size_t{1});
    }
};

RUBBLE_TEST(ProjectDifferenceTest)
#include "ProjectDifferenceTest.moc"
