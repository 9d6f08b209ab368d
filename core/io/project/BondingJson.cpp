#include "core/io/project/BondingJson.h"

#include "core/io/project/GreyImageJson.h"

#include <array>

namespace rubble {
namespace {

// In the order of their enumerators.
constexpr std::array<std::string_view, 2> kBreakAs{"whole", "bonded"};
constexpr std::array<std::string_view, 3> kFalloffs{"constant", "linear", "smooth"};
constexpr std::array<std::string_view, 3> kBrushes{"anchor", "strength", "neverBreaks"};

template <class Enumeration, std::size_t Count>
std::string_view wordOf(const std::array<std::string_view, Count>& words, Enumeration enumerator) {
    return words[static_cast<std::size_t>(enumerator)];
}

void writeStroke(JsonWriter& json, const BondStroke& stroke) {
    json.openObject();
    json.text("brush", wordOf(kBrushes, stroke.brush));
    json.boolean("erasing", stroke.isErasing);
    json.number("strength", stroke.strength);
    json.number("radius", stroke.radius);
    json.points("points", stroke.points);
    json.close();
}

BondStroke readStroke(const JsonValue& value) {
    value.requireObject({"brush", "erasing", "strength", "radius", "points"});
    return {.brush = static_cast<BondBrush>(value["brush"].oneOf(kBrushes)),
            .isErasing = value["erasing"].boolean(),
            .strength = value["strength"].number(),
            .radius = value["radius"].number(),
            .points = value["points"].points()};
}

void writeHeightStrength(JsonWriter& json, const HeightStrength& strength) {
    json.openObject({}, JsonLayout::Inline);
    json.number("height", strength.height);
    json.number("factor", strength.factor);
    json.close();
}

HeightStrength readHeightStrength(const JsonValue& value) {
    value.requireObject({"height", "factor"});
    return {.height = value["height"].number(), .factor = value["factor"].number()};
}

void writeStrengthImage(JsonWriter& json, const std::optional<StrengthImage>& strength) {
    if (!strength) return json.null("strengthImage");
    json.openObject("strengthImage");
    json.number("darkest", strength->darkest);
    json.number("brightest", strength->brightest);
    writeGreyImage(json, "image", strength->image.get());
    json.close();
}

StrengthImage readStrengthImage(const JsonValue& value) {
    value.requireObject({"darkest", "brightest", "image"});
    return {.darkest = value["darkest"].number(),
            .brightest = value["brightest"].number(),
            .image = readGreyImage(value["image"])};
}

void writeCluster(JsonWriter& json, const FragmentCluster& cluster) {
    json.openObject();
    json.wholeNumber("level", cluster.level);
    json.openArray("fragments");
    for (const FragmentPath& path : cluster.fragments) json.text({}, path);
    json.close();
    json.close();
}

FragmentCluster readCluster(const JsonValue& value) {
    value.requireObject({"level", "fragments"});
    return {.level = value["level"].index(), .fragments = value["fragments"].list(&JsonValue::text)};
}

void writeMembers(JsonWriter& json, const Bonding& bonding) {
    json.number("impulsePerArea", bonding.impulsePerArea);
    json.number("radius", bonding.radius);
    json.text("falloff", wordOf(kFalloffs, bonding.falloff));
    json.number("damageFrom", bonding.damageFrom);
    json.number("span", bonding.span);
    json.number("collapseDelay", bonding.collapseDelay);
    json.wholeNumber("minimumIsland", bonding.minimumIsland);
    json.list("strokes", bonding.strokes, writeStroke);
    json.list("heightStrengths", bonding.heightStrengths, writeHeightStrength);
    writeStrengthImage(json, bonding.strengthImage);
    json.openArray("neverBreaks");
    for (const FragmentPath& path : bonding.neverBreaks) json.text({}, path);
    json.close();
    if (!bonding.clusters.empty()) json.list("clusters", bonding.clusters, writeCluster);
}

Bonding readMembers(const JsonValue& value) {
    value.requireObject({"impulsePerArea", "radius", "falloff", "damageFrom", "span", "collapseDelay", "minimumIsland",
                         "strokes", "heightStrengths", "strengthImage", "neverBreaks"},
                        {"clusters"});
    const JsonValue clusters = value["clusters"];
    return {.impulsePerArea = value["impulsePerArea"].optionalNumber(),
            .radius = value["radius"].number(),
            .falloff = static_cast<HitFalloff>(value["falloff"].oneOf(kFalloffs)),
            .damageFrom = value["damageFrom"].number(),
            .span = value["span"].number(),
            .collapseDelay = value["collapseDelay"].number(),
            .minimumIsland = value["minimumIsland"].index(),
            .strokes = value["strokes"].list(readStroke),
            .heightStrengths = value["heightStrengths"].list(readHeightStrength),
            .strengthImage = value["strengthImage"].optional(readStrengthImage),
            .neverBreaks = value["neverBreaks"].list(&JsonValue::text),
            .clusters = clusters.isPresent() ? clusters.list(readCluster) : std::vector<FragmentCluster>{}};
}

}  // namespace

void writeBonding(JsonWriter& json, const Asset& asset) {
    if (asset.breakAs != BreakAs::Whole) json.text("breakAs", wordOf(kBreakAs, asset.breakAs));
    if (asset.bonding == Bonding{}) return;
    json.openObject("bonding");
    writeMembers(json, asset.bonding);
    json.close();
}

void readBonding(const JsonValue& value, Asset& asset) {
    if (value["breakAs"].isPresent()) asset.breakAs = static_cast<BreakAs>(value["breakAs"].oneOf(kBreakAs));
    if (value["bonding"].isPresent()) asset.bonding = readMembers(value["bonding"]);
}

void writeMortar(JsonWriter& json, const Mortar& mortar) {
    json.openObject();
    json.wholeNumber("id", mortar.id);
    json.text("name", mortar.name);
    json.wholeNumbers("instances", mortar.instances);
    json.number("tolerance", mortar.tolerance);
    json.number("leastArea", mortar.leastArea);
    json.number("impulsePerArea", mortar.impulsePerArea);
    json.close();
}

Mortar readMortar(const JsonValue& value) {
    value.requireObject({"id", "name", "instances", "tolerance", "leastArea", "impulsePerArea"});
    return {.id = value["id"].index(),
            .name = value["name"].text(),
            .instances = value["instances"].list([](const JsonValue& id) { return Id{id.index()}; }),
            .tolerance = value["tolerance"].number(),
            .leastArea = value["leastArea"].number(),
            .impulsePerArea = value["impulsePerArea"].number()};
}

void writeBondStrength(JsonWriter& json, double strength) {
    if (strength != 1.0) json.number("bondStrength", strength);
}

double readBondStrength(const JsonValue& value) {
    return value["bondStrength"].isPresent() ? value["bondStrength"].number() : 1.0;
}

}  // namespace rubble
