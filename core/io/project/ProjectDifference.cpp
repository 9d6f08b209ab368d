#include "core/io/project/ProjectDifference.h"

#include "core/base/MessageText.h"
#include "core/io/project/ProjectFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace rubble {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxShown = 4;  // elements of a list; longer ones are counted

/// The keys of an asset whose changes recipeChanges() describes.
constexpr std::array<std::string_view, 19> kInRecipe{
    "name",          "prism",       "mesh",    "material", "insideMaterial",    "threshold", "contactTime",
    "insideUvScale", "cutAtImpact", "pattern", "levels",   "shaping",           "leaves",    "edits",
    "intents",       "surface",     "breakAs", "bonding",  "fragmentThresholds"};

/// Keys that are no words for users, and the lists whose elements are called by another word.
constexpr std::array<std::array<std::string_view, 2>, 13> kWords{{{"materials", "material"},
                                                                  {"assets", "asset"},
                                                                  {"instances", "instance"},
                                                                  {"shots", "shot"},
                                                                  {"playTests", "test"},
                                                                  {"mortars", "mortar"},
                                                                  {"expectations", "expectation"},
                                                                  {"mostPieces", "maximum fragments"},
                                                                  {"maxRecords", "events per step"},
                                                                  {"thesis", "thesis preset"},
                                                                  {"thesisThreshold", "thesis threshold"},
                                                                  {"uvScale", "UV scale"},
                                                                  {"intents", "strength requirements"}}};
constexpr std::array<std::string_view, 6> kReferences{"asset",    "material", "insideMaterial",
                                                      "instance", "shots",    "instances"};

/// A key in words: "fractureToughness" becomes "fracture toughness".
std::string wordsOf(std::string_view key) {
    const auto known = std::ranges::find(kWords, key, [](const auto& pair) { return pair[0]; });
    if (known != kWords.end()) return std::string((*known)[1]);
    std::string words;
    for (const char letter : key) {
        const bool isCapital = letter >= 'A' && letter <= 'Z';
        if (isCapital) words += ' ';
        words += isCapital ? static_cast<char>(letter - 'A' + 'a') : letter;
    }
    return words;
}

/// The JSON of a project without the surfaces and textures of imported meshes, which may be large.
Json jsonOf(Project project) {
    project.nextId = std::numeric_limits<Id>::max();
    for (Asset& asset : project.assets) {
        asset.surface.reset();
        asset.texture.reset();
    }
    Json json = Json::parse(projectText(project));
    json["events"] = {{"leastEnergy", project.events.leastEnergy}, {"maxRecords", project.events.maxRecords}};
    if (project.mortars.empty()) json["mortars"] = Json::array();  // so that each one that is added is listed
    return json;
}

/// The names of all elements of a project by id.
std::map<std::uint64_t, std::string> namesOf(const Json& project) {
    std::map<std::uint64_t, std::string> names;
    for (const char* list : {"materials", "assets", "instances", "shots"}) {
        for (const Json& element : project[list]) names[element["id"]] = shownName(element["name"].get<std::string>());
    }
    return names;
}

/// Compares two JSON values and describes what differs.
class JsonChanges {
public:
    JsonChanges(const Json& before, const Json& after) : m_names{namesOf(before), namesOf(after)} {}

    void compare(const std::string& place, std::string_view key, const Json& before, const Json& after) {
        if (before == after) return;
        if (before.is_object() && after.is_object()) return compareObjects(place, before, after);
        if (before.is_array() && after.is_array() && holdObjects(before, after))
            return compareLists(place, before, after);
        const std::string earlier = textOf(key, before, 0), later = textOf(key, after, 1);
        add(place, earlier, later == earlier ? later + ", changed" : later);
    }
    void compareObjects(const std::string& place, const Json& before, const Json& after) {
        const std::string prefix = place.empty() ? "" : place + ", ";
        for (const auto& [key, value] : before.items()) {
            const auto other = after.find(key);
            if (other != after.end()) {
                compare(prefix + wordsOf(key), key, value, *other);
            } else {
                add(prefix + wordsOf(key), textOf(key, value, 0), {});
            }
        }
        for (const auto& [key, value] : after.items()) {
            if (!before.contains(key)) add(prefix + wordsOf(key), {}, textOf(key, value, 1));
        }
    }
    std::vector<RecipeChange> list() && { return std::move(m_list); }

private:
    static bool holdObjects(const Json& before, const Json& after) {
        const auto isObject = [](const Json& element) { return element.is_object(); };
        return std::ranges::all_of(before, isObject) && std::ranges::all_of(after, isObject);
    }
    static bool isNamed(const Json& element) { return element.contains("id") && element.contains("name"); }

    void add(const std::string& what, const std::string& before, const std::string& after) {
        m_list.push_back({what, before, after});
    }

    /// The element of a list that is another state of this one: of the same id, else of the same name; else null.
    static const Json* matchOf(const Json& element, const Json& list, const Json& own) {
        const auto find = [](const Json& in, const char* key, const Json& value) -> const Json* {
            const auto found = std::ranges::find_if(in, [&](const Json& each) { return each[key] == value; });
            return found == in.end() ? nullptr : &*found;
        };
        if (const Json* same = find(list, "id", element["id"])) return same;
        const Json* called = find(list, "name", element["name"]);
        return called && !find(own, "id", (*called)["id"]) ? called : nullptr;
    }

    void compareLists(const std::string& place, const Json& before, const Json& after) {
        const bool areNamed = std::ranges::all_of(before, isNamed) && std::ranges::all_of(after, isNamed);
        if (areNamed) return compareNamed(place, before, after);
        for (std::size_t k = 0; k < std::max(before.size(), after.size()); ++k) {
            const std::string element = place + " " + std::to_string(k + 1);
            if (k >= after.size()) {
                add(element, textOf({}, before[k], 0), {});
            } else if (k >= before.size()) {
                add(element, {}, textOf({}, after[k], 1));
            } else {
                compare(element, {}, before[k], after[k]);
            }
        }
    }
    void compareNamed(const std::string& place, const Json& before, const Json& after) {
        const auto nameOf = [&](const Json& element) {
            return place + " " + quotedName(element["name"].get<std::string>());
        };
        for (const Json& element : before) {
            if (!matchOf(element, after, before)) add(nameOf(element), textOf({}, element, 0), {});
        }
        for (const Json& element : after) {
            if (const Json* same = matchOf(element, before, after)) {
                compare(nameOf(element), {}, *same, element);
            } else {
                add(nameOf(element), {}, textOf({}, element, 1));
            }
        }
    }

    /// A value as text. `state`: 0 for the earlier, 1 for the later, whose names references are shown by.
    std::string textOf(std::string_view key, const Json& value, std::size_t state) const {
        if (value.is_null()) return "none";
        if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
        if (value.is_string()) return shownName(value.get<std::string>());
        if (value.is_object()) return textOfObject(value, state);
        if (value.is_array()) return textOfArray(key, value, state);
        const bool isReference = std::ranges::find(kReferences, key) != kReferences.end();
        const auto name = isReference ? m_names[state].find(value.get<std::uint64_t>()) : m_names[state].end();
        return name != m_names[state].end() ? name->second : value.dump();
    }
    std::string textOfArray(std::string_view key, const Json& array, std::size_t state) const {
        if (array.empty()) return "none";
        if (array.size() > kMaxShown) return std::to_string(array.size()) + " values";
        std::string text;
        for (const Json& element : array) text += (text.empty() ? "[" : ", ") + textOf(key, element, state);
        return text + "]";
    }
    std::string textOfObject(const Json& object, std::size_t state) const {
        std::string text;
        for (const auto& [key, value] : object.items()) {
            if (key == "id" || key == "name") continue;
            text += (text.empty() ? "" : ", ") + wordsOf(key) + " " + textOf(key, value, state);
        }
        return text;
    }

    std::array<std::map<std::uint64_t, std::string>, 2> m_names;
    std::vector<RecipeChange> m_list;
};

/// A project of one asset and the materials.
Project onlyAsset(const Project& project, const Asset& asset) {
    Project single;
    single.materials = project.materials;
    single.assets = {asset};
    return single;
}

void eraseReported(Json& asset) {
    for (const std::string_view key : kInRecipe) asset.erase(std::string(key));
}

}  // namespace

std::vector<RecipeChange> assetChanges(const Project& before, const Asset& earlier, const Project& after,
                                       const Asset& later) {
    std::vector<RecipeChange> changes = recipeChanges(before, earlier, after, later);
    const Json from = jsonOf(onlyAsset(before, earlier)), to = jsonOf(onlyAsset(after, later));
    Json fromAsset = from["assets"][0], toAsset = to["assets"][0];
    if (!changes.empty()) {
        eraseReported(fromAsset);
        eraseReported(toAsset);
    }
    JsonChanges rest(from, to);
    rest.compareObjects({}, fromAsset, toAsset);
    std::ranges::move(std::move(rest).list(), std::back_inserter(changes));
    return changes;
}

std::vector<RecipeChange> settingChanges(const Project& before, const Project& after) {
    Json from = jsonOf(before), to = jsonOf(after);
    JsonChanges changes(from, to);
    for (const char* other : {"assets", "identity", "version"}) {  // compared elsewhere; no settings
        from.erase(other);
        to.erase(other);
    }
    changes.compareObjects({}, from, to);
    std::vector<RecipeChange> list = std::move(changes).list();
    if (list.empty() && before.nextId != after.nextId && before.assets == after.assets)
        list.push_back({"next id", std::to_string(before.nextId), std::to_string(after.nextId)});
    return list;
}

Result<ProjectDifference> projectDifference(const Project& before, const Project& after,
                                            std::span<const AssetPair> pairs, const TaskContext& task) {
    ProjectDifference all;
    for (const AssetPair& pair : pairs) {
        task.report(static_cast<double>(all.assets.size()) / static_cast<double>(pairs.size()));
        Result<AssetDifference> difference = differenceOf(before, after, pair, task);
        if (!difference) return difference.error();
        if (pair.before && pair.after) difference->recipe = assetChanges(before, *pair.before, after, *pair.after);
        all.assets.push_back(std::move(*difference));
    }
    return all;
}

bool ProjectDifference::isEmpty() const {
    return settings.empty() && std::ranges::all_of(assets, &AssetDifference::isEmpty);
}

}  // namespace rubble
