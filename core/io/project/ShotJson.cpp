#include "core/io/project/ShotJson.h"

#include "core/asset/checks/PlayFaults.h"
#include "core/io/json/VectorJson.h"

#include <array>

namespace rubble {
namespace {

// In the order of their enumerators and of the alternatives of ShotAction.
constexpr std::array<std::string_view, 4> kProjectiles{"box", "ball", "plank", "asset"};
constexpr std::array<std::string_view, 3> kActions{"throw", "hammer", "explosion"};
constexpr std::array<std::string_view, kExpectationKinds> kExpectations{
    "standsUntouched", "breaks",        "doesNotBreak", "breaksIntoAtLeast",
    "nothingAbove",    "nothingFaster", "staysUp",      "holeAtMost"};
static_assert(kActions.size() == std::variant_size_v<ShotAction>);

template <class Enumeration>
std::size_t indexOf(Enumeration enumerator) {
    return static_cast<std::size_t>(enumerator);
}

void writeAction(JsonWriter& json, const Throw& thrown) {
    json.text("projectile", kProjectiles[indexOf(thrown.kind)]);
    json.wholeNumber("asset", thrown.asset);
    writeVector(json, "size", thrown.size);
    json.number("mass", thrown.mass);
    writeVector(json, "from", thrown.from);
    writeVector(json, "to", thrown.to);
    json.number("speed", thrown.speed);
}

Throw readThrow(const JsonValue& value) {
    value.requireObject({"projectile", "asset", "size", "mass", "from", "to", "speed"});
    return {.kind = static_cast<ProjectileKind>(value["projectile"].oneOf(kProjectiles)),
            .asset = value["asset"].index(),
            .size = readVector(value["size"]),
            .mass = value["mass"].number(),
            .from = readVector(value["from"]),
            .to = readVector(value["to"]),
            .speed = value["speed"].number()};
}

void writeAction(JsonWriter& json, const Hammer& hammer) {
    writeVector(json, "at", hammer.at);
    writeVector(json, "impulse", hammer.impulse);
    if (hammer.radius) json.number("radius", *hammer.radius);
}

Hammer readHammer(const JsonValue& value) {
    value.requireObject({"at", "impulse"}, {"radius"});
    Hammer hammer{.at = readVector(value["at"]), .impulse = readVector(value["impulse"])};
    if (value["radius"].isPresent()) hammer.radius = value["radius"].number();
    return hammer;
}

void writeAction(JsonWriter& json, const Blast& blast) {
    writeVector(json, "at", blast.at);
    json.number("impulse", blast.impulse);
    json.number("radius", blast.radius);
}

Blast readBlast(const JsonValue& value) {
    value.requireObject({"at", "impulse", "radius"});
    return {.at = readVector(value["at"]), .impulse = value["impulse"].number(), .radius = value["radius"].number()};
}

ShotAction readAction(std::size_t kind, const JsonValue& value) {
    switch (kind) {
        case 0: return readThrow(value);
        case 1: return readHammer(value);
        default: return readBlast(value);
    }
}

void writeKindAndAction(JsonWriter& json, const ShotAction& action) {
    json.text("kind", kActions[action.index()]);
    json.openObject("action");
    std::visit([&](const auto& alternative) { writeAction(json, alternative); }, action);
    json.close();
}

void writeExpectation(JsonWriter& json, const Expectation& expectation) {
    json.openObject({}, JsonLayout::Inline);
    json.text("kind", kExpectations[indexOf(expectation.kind)]);
    json.wholeNumber("instance", expectation.instance);
    json.number("value", expectation.value);
    json.close();
}

Expectation readExpectation(const JsonValue& value) {
    value.requireObject({"kind", "instance", "value"});
    return {.kind = static_cast<ExpectationKind>(value["kind"].oneOf(kExpectations)),
            .instance = value["instance"].index(),
            .value = value["value"].number()};
}

void writeInstancePart(JsonWriter& json, const InstancePart& part) {
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("instance", part.instance);
    if (!part.fragments.empty()) writeFragmentPaths(json, part.fragments);
    json.close();
}

InstancePart readInstancePart(const JsonValue& value) {
    value.requireObject({"instance"}, {"fragments"});
    return {value["instance"].index(), readFragmentPaths(value)};
}

}  // namespace

void writeFragmentPaths(JsonWriter& json, const std::vector<FragmentPath>& paths) {
    json.openArray("fragments", JsonLayout::Inline);
    for (const FragmentPath& path : paths) json.text({}, path);
    json.close();
}

std::vector<FragmentPath> readFragmentPaths(const JsonValue& value) {
    if (!value["fragments"].isPresent()) return {};
    return value["fragments"].list([](const JsonValue& path) { return path.text(); });
}

void writeShotAction(JsonWriter& json, const std::string& name, const ShotAction& action) {
    json.text("name", name);
    writeKindAndAction(json, action);
}

std::pair<std::string, ShotAction> readShotAction(const JsonValue& value) {
    return {value["name"].text(), readAction(value["kind"].oneOf(kActions), value["action"])};
}

std::string_view nameOf(ProjectileKind kind) { return kProjectiles[indexOf(kind)]; }

void writeShot(JsonWriter& json, const Shot& shot) {
    json.openObject();
    json.wholeNumber("id", shot.id);
    json.text("name", shot.name);
    json.number("time", shot.time);
    writeKindAndAction(json, shot.action);
    json.close();
}

Shot readShot(const JsonValue& value) {
    value.requireObject({"id", "name", "time", "kind", "action"});
    return {.id = value["id"].index(),
            .name = value["name"].text(),
            .time = value["time"].number(),
            .action = readAction(value["kind"].oneOf(kActions), value["action"])};
}

void writePlayTest(JsonWriter& json, const PlayTest& test) {
    json.openObject();
    json.wholeNumber("id", test.id);
    json.text("name", test.name);
    if (!test.state.empty()) json.text("state", test.state);
    if (!test.removed.empty()) json.list("removed", test.removed, writeInstancePart);
    json.openArray("shots", JsonLayout::Inline);
    for (const Id shot : test.shots) json.wholeNumber({}, shot);
    json.close();
    json.number("duration", test.duration);
    json.list("expectations", test.expectations, writeExpectation);
    json.close();
}

PlayTest readPlayTest(const JsonValue& value) {
    value.requireObject({"id", "name", "shots", "duration", "expectations"}, {"state", "removed"});
    return {
        .id = value["id"].index(),
        .name = value["name"].text(),
        .state = value["state"].isPresent() ? value["state"].text() : std::string(),
        .removed = value["removed"].isPresent() ? value["removed"].list(readInstancePart) : std::vector<InstancePart>(),
        .shots = value["shots"].list([](const JsonValue& shot) { return shot.index(); }),
        .duration = value["duration"].number(),
        .expectations = value["expectations"].list(readExpectation)};
}

Result<std::vector<Shot>> readShotList(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    std::vector<Shot> shots = document->root().list(readShot);
    if (document->firstError()) return *document->firstError();
    for (const Shot& shot : shots) {
        if (const std::optional<std::string> fault = faultOf(shot)) return Error{ErrorCode::BadInput, *fault};
    }
    return shots;
}

}  // namespace rubble
