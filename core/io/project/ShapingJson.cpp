#include "core/io/project/ShapingJson.h"

#include <array>

namespace rubble {
namespace {

// In the order of their enumerators and of the alternatives of FragmentEdit.
constexpr std::array<std::string_view, 3> kSmallPieceRules{"keep", "merge", "dropSeeds"};
constexpr std::array<std::string_view, 4> kMeasures{"area", "volume", "partOfMean", "partOfWhole"};
constexpr std::array<std::string_view, 2> kEdits{"merge", "split"};
static_assert(kEdits.size() == std::variant_size_v<FragmentEdit>);

void writeSmallPieces(JsonWriter& json, const SmallPieces& small) {
    json.openObject("smallPieces", JsonLayout::Inline);
    json.text("rule", kSmallPieceRules[static_cast<std::size_t>(small.rule)]);
    json.text("measure", kMeasures[static_cast<std::size_t>(small.measure)]);
    json.number("limit", small.limit);
    json.close();
}

SmallPieces readSmallPieces(const JsonValue& value) {
    value.requireObject({"rule", "measure", "limit"});
    return {.rule = static_cast<SmallPieceRule>(value["rule"].oneOf(kSmallPieceRules)),
            .measure = static_cast<PieceMeasure>(value["measure"].oneOf(kMeasures)),
            .limit = value["limit"].number()};
}

void writeMembers(JsonWriter& json, const FragmentMerge& merge) {
    json.text("into", merge.into);
    json.openArray("merged", JsonLayout::Inline);
    for (const FragmentPath& path : merge.merged) json.text({}, path);
    json.close();
}

void writeMembers(JsonWriter& json, const FragmentSplit& split) {
    json.text("fragment", split.fragment);
    json.numbers("point", {split.line.point.x, split.line.point.y});
    json.numbers("direction", {split.line.direction.x, split.line.direction.y});
}

}  // namespace

void writeRoughness(JsonWriter& json, const Roughness& roughness) {
    json.openObject("roughness", JsonLayout::Inline);
    json.number("amplitude", roughness.amplitude);
    json.number("frequency", roughness.frequency);
    json.wholeNumber("octaves", roughness.octaves);
    json.wholeNumber("randomSeed", roughness.randomSeed);
    json.close();
}

Roughness readRoughness(const JsonValue& value) {
    value.requireObject({"amplitude", "frequency", "octaves", "randomSeed"});
    return {.amplitude = value["amplitude"].number(),
            .frequency = value["frequency"].number(),
            .octaves = value["octaves"].index(),
            .randomSeed = value["randomSeed"].wholeNumber()};
}

void writeShaping(JsonWriter& json, const Shaping& shaping) {
    json.openObject("shaping");
    writeSmallPieces(json, shaping.smallPieces);
    json.number("gap", shaping.gap);
    writeRoughness(json, shaping.roughness);
    json.close();
}

Shaping readShaping(const JsonValue& value) {
    value.requireObject({"smallPieces", "gap", "roughness"});
    return {.smallPieces = readSmallPieces(value["smallPieces"]),
            .gap = value["gap"].number(),
            .roughness = readRoughness(value["roughness"])};
}

void writeEdit(JsonWriter& json, const FragmentEdit& edit) {
    json.openObject({}, JsonLayout::Inline);
    json.text("kind", kEdits[edit.index()]);
    std::visit([&](const auto& alternative) { writeMembers(json, alternative); }, edit);
    json.close();
}

FragmentEdit readEdit(const JsonValue& value) {
    value.requireObject({"kind"}, {"into", "merged", "fragment", "point", "direction"});
    if (value["kind"].oneOf(kEdits) == 0) {
        value.requireObject({"kind", "into", "merged"});
        return FragmentMerge{.into = value["into"].text(), .merged = value["merged"].list(&JsonValue::text)};
    }
    value.requireObject({"kind", "fragment", "point", "direction"});
    return FragmentSplit{.fragment = value["fragment"].text(),
                         .line = {.point = value["point"].point(), .direction = value["direction"].point()}};
}

}  // namespace rubble
