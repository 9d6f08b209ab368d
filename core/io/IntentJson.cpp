#include "core/io/IntentJson.h"

#include <array>

namespace rubble {
namespace {

using IntentEvent = decltype(Intent::event);

// In the order of their enumerators and of the alternatives of IntentEvent.
constexpr std::array<std::string_view, 2> kOutcomes{"survives", "breaks"};
constexpr std::array<std::string_view, 2> kEvents{"drop", "hit"};
static_assert(kEvents.size() == std::variant_size_v<IntentEvent>);

void writeEvent(JsonLayout& json, const DropIntent& drop) { json.number("height", drop.height); }

DropIntent readDrop(const JsonValue& intent) {
    intent.requireObject({"outcome", "kind", "height"});
    return {.height = intent["height"].number()};
}

void writeEvent(JsonLayout& json, const HitIntent& hit) {
    json.number("mass", hit.mass);
    json.number("speed", hit.speed);
}

HitIntent readHit(const JsonValue& intent) {
    intent.requireObject({"outcome", "kind", "mass", "speed"});
    return {.mass = intent["mass"].number(), .speed = intent["speed"].number()};
}

IntentEvent readEvent(std::size_t kind, const JsonValue& intent) {
    if (kind == 0) return readDrop(intent);
    return readHit(intent);
}

}  // namespace

void writeCutAtImpact(JsonLayout& json, const std::optional<CutAtImpact>& cut) {
    if (!cut) return json.null("cutAtImpact");
    json.openObject("cutAtImpact", JsonLines::One);
    json.wholeNumber("pieces", cut->pieces);
    json.number("reach", cut->reach);
    json.close();
}

CutAtImpact readCutAtImpact(const JsonValue& value) {
    value.requireObject({"pieces", "reach"});
    return {.pieces = value["pieces"].index(), .reach = value["reach"].number()};
}

void writeIntentMembers(JsonLayout& json, const Intent& intent) {
    json.text("outcome", kOutcomes[static_cast<std::size_t>(intent.outcome)]);
    json.text("kind", kEvents[intent.event.index()]);
    std::visit([&](const auto& event) { writeEvent(json, event); }, intent.event);
}

void writeIntent(JsonLayout& json, const Intent& intent) {
    json.openObject({}, JsonLines::One);
    writeIntentMembers(json, intent);
    json.close();
}

Intent readIntent(const JsonValue& value) {
    value.requireObject({"outcome", "kind"}, {"height", "mass", "speed"});
    return {.outcome = static_cast<IntentOutcome>(value["outcome"].oneOf(kOutcomes)),
            .event = readEvent(value["kind"].oneOf(kEvents), value)};
}

}  // namespace rubble
