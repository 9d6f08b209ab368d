#include "core/io/project/ProjectDifferenceJson.h"

#include "core/io/json/JsonWriter.h"

#include <array>

namespace rubble {
namespace {

constexpr std::array<const char*, kFragmentChanges> kChanges{"gone", "added", "moved", "reshaped"};

const char* stateOf(const AssetDifference& difference) {
    if (!difference.pair.before) return "added";
    if (!difference.pair.after) return "gone";
    return difference.isEmpty() ? "same" : "changed";
}

void writeState(JsonWriter& json, std::string_view key, const std::string& text) {
    if (text.empty()) return json.null(key);
    json.text(key, text);
}

void writeChange(JsonWriter& json, const RecipeChange& change) {
    json.openObject({}, JsonLayout::Inline);
    json.text("what", change.what);
    writeState(json, "before", change.before);
    writeState(json, "after", change.after);
    json.close();
}

void writeLevelDifference(JsonWriter& json, std::size_t number, const LevelDifference& level) {
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("level", std::uint64_t{number});
    json.wholeNumber("before", std::uint64_t{level.before});
    json.wholeNumber("after", std::uint64_t{level.after});
    for (std::size_t k = 0; k < kChanges.size(); ++k) json.wholeNumber(kChanges[k], std::uint64_t{level.changed[k]});
    json.close();
}

void writeFragment(JsonWriter& json, const FragmentDifference& fragment) {
    json.openObject({}, JsonLayout::Inline);
    json.text("path", fragment.path);
    json.text("change", kChanges[static_cast<std::size_t>(fragment.change)]);
    if (fragment.change == FragmentChange::Moved) json.number("shift", fragment.shift);
    if (fragment.before != kNone) json.number("volumeBefore", fragment.volumeBefore);
    if (fragment.after != kNone) json.number("volumeAfter", fragment.volumeAfter);
    json.close();
}

}  // namespace

std::string projectDifferenceJson(const ProjectDifference& all) {
    JsonWriter json;
    json.openObject();
    json.boolean("isSame", all.isEmpty());
    json.openArray("assets");
    for (const AssetDifference& difference : all.assets) {
        json.openObject();
        json.text("name", difference.pair.name());
        json.text("state", stateOf(difference));
        json.list("recipe", difference.recipe, writeChange);
        json.openArray("levels");
        const std::vector<LevelDifference>& levels = difference.fragments.levels;
        for (std::size_t k = 0; k < levels.size(); ++k) writeLevelDifference(json, k, levels[k]);
        json.close();
        json.list("pieces", difference.fragments.fragments, writeFragment);
        json.close();
    }
    json.close();
    json.list("settings", all.settings, writeChange);
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
