#include "core/io/project/SceneJson.h"

#include "core/io/json/VectorJson.h"
#include "core/io/project/BondingJson.h"

#include <array>

namespace rubble {
namespace {

// In the order of their enumerators.
constexpr std::array<std::string_view, 2> kDamageRules{"impact", "momentum"};

/// Reads the members of an instance that all versions have.
Instance readInstanceMembers1(const JsonValue& value) {
    const auto [w, x, y, z] = value["orientation"].numbers<4>();
    return {.id = value["id"].index(),
            .name = value["name"].text(),
            .asset = value["asset"].index(),
            .pose = {readVector(value["position"]), Quat{w, x, y, z}},
            .threshold = value["threshold"].optionalNumber(),
            .isFixed = value["fixed"].boolean()};
}

}  // namespace

void writeInstance(JsonWriter& json, const Instance& instance) {
    const Quat& orientation = instance.pose.orientation;
    json.openObject();
    json.wholeNumber("id", instance.id);
    json.text("name", instance.name);
    json.wholeNumber("asset", instance.asset);
    writeVector(json, "position", instance.pose.position);
    json.numbers("orientation", {orientation.w, orientation.x, orientation.y, orientation.z});
    json.number("threshold", instance.threshold);
    json.boolean("fixed", instance.isFixed);
    json.wholeNumber("variant", instance.variant);
    json.boolean("hidden", instance.isHidden);
    json.boolean("locked", instance.isLocked);
    if (instance.isUnbreakable) json.boolean("unbreakable", true);
    if (instance.isAnchored) json.boolean("anchored", true);
    writeBondStrength(json, instance.bondStrength);
    json.close();
}

Instance readInstanceBeforeVersion3(const JsonValue& value) {
    value.requireObject({"id", "name", "asset", "position", "orientation", "threshold", "fixed"});
    return readInstanceMembers1(value);
}

Instance readInstance(const JsonValue& value) {
    value.requireObject(
        {"id", "name", "asset", "position", "orientation", "threshold", "fixed", "variant", "hidden", "locked"},
        {"unbreakable", "anchored", "bondStrength"});
    Instance instance = readInstanceMembers1(value);
    instance.variant = value["variant"].index();
    instance.isHidden = value["hidden"].boolean();
    instance.isLocked = value["locked"].boolean();
    if (value["unbreakable"].isPresent()) instance.isUnbreakable = value["unbreakable"].boolean();
    if (value["anchored"].isPresent()) instance.isAnchored = value["anchored"].boolean();
    instance.bondStrength = readBondStrength(value);
    return instance;
}

void writeGround(JsonWriter& json, const Ground& ground) {
    json.openObject("ground");
    json.boolean("on", ground.isOn);
    writeGroundPlane(json, ground);
    json.close();
}

void writeGroundPlane(JsonWriter& json, const Ground& ground) {
    json.number("height", ground.height);
    json.number("friction", ground.friction);
    json.number("restitution", ground.restitution);
}

Ground readGround(const JsonValue& value) {
    value.requireObject({"on", "height", "friction", "restitution"});
    return {.isOn = value["on"].boolean(),
            .height = value["height"].number(),
            .friction = value["friction"].number(),
            .restitution = value["restitution"].number()};
}

void writeDamage(JsonWriter& json, const Damage& damage) {
    json.openObject("damage");
    json.text("rule", kDamageRules[static_cast<std::size_t>(damage.rule)]);
    json.boolean("thesis", damage.isThesis);
    json.number("thesisThreshold", damage.thesisThreshold);
    json.close();
}

Damage readDamage(const JsonValue& value) {
    value.requireObject({"rule", "thesis", "thesisThreshold"});
    return {.rule = static_cast<DamageRule>(value["rule"].oneOf(kDamageRules)),
            .isThesis = value["thesis"].boolean(),
            .thesisThreshold = value["thesisThreshold"].number()};
}

void writeDebris(JsonWriter& json, const Debris& debris) {
    json.openObject("debris");
    json.number("lifetime", debris.lifetime);
    json.number("fade", debris.fade);
    json.wholeNumber("mostPieces", debris.maxFragments);
    json.close();
}

Debris readDebris(const JsonValue& value) {
    value.requireObject({"lifetime", "fade", "mostPieces"});
    return {.lifetime = value["lifetime"].optionalNumber(),
            .fade = value["fade"].number(),
            .maxFragments = value["mostPieces"].optional([](const JsonValue& most) { return most.index(); })};
}

void writeEventSettings(JsonWriter& json, const EventSettings& events) {
    json.openObject("events");
    json.number("leastEnergy", events.leastEnergy);
    json.wholeNumber("maxRecords", events.maxRecords);
    json.close();
}

EventSettings readEventSettings(const JsonValue& value) {
    value.requireObject({"leastEnergy", "maxRecords"});
    return {.leastEnergy = value["leastEnergy"].number(), .maxRecords = value["maxRecords"].index()};
}

}  // namespace rubble
