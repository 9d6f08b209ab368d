#include "core/io/project/StrengthRequirementJson.h"

#include <array>

namespace rubble {
namespace {

using RequirementEvent = decltype(StrengthRequirement::event);

// In the order of their enumerators and of the alternatives of RequirementEvent.
constexpr std::array<std::string_view, 3> kOutcomes{"survives", "breaks", "holeAtMost"};
constexpr std::array<std::string_view, 3> kEvents{"drop", "hit", "impulse"};
static_assert(kEvents.size() == std::variant_size_v<RequirementEvent>);

void writeEvent(JsonWriter& json, const DropRequirement& drop) { json.number("height", drop.height); }

DropRequirement readDrop(const JsonValue& requirement) {
    requirement.requireObject({"outcome", "kind", "height"}, {"hole"});
    return {.height = requirement["height"].number()};
}

void writeEvent(JsonWriter& json, const HitRequirement& hit) {
    json.number("mass", hit.mass);
    json.number("speed", hit.speed);
}

HitRequirement readHit(const JsonValue& requirement) {
    requirement.requireObject({"outcome", "kind", "mass", "speed"}, {"hole"});
    return {.mass = requirement["mass"].number(), .speed = requirement["speed"].number()};
}

void writeEvent(JsonWriter& json, const ImpulseRequirement& impact) { json.number("impulse", impact.impulse); }

ImpulseRequirement readImpulse(const JsonValue& requirement) {
    requirement.requireObject({"outcome", "kind", "impulse"}, {"hole"});
    return {.impulse = requirement["impulse"].number()};
}

RequirementEvent readEvent(std::size_t kind, const JsonValue& requirement) {
    if (kind == 0) return readDrop(requirement);
    if (kind == 1) return readHit(requirement);
    return readImpulse(requirement);
}

}  // namespace

void writeCutAtImpact(JsonWriter& json, const std::optional<CutAtImpact>& cut) {
    if (!cut) return json.null("cutAtImpact");
    json.openObject("cutAtImpact", JsonLayout::Inline);
    json.wholeNumber("pieces", cut->fragments);
    json.number("reach", cut->falloffRadius);
    json.close();
}

CutAtImpact readCutAtImpact(const JsonValue& value) {
    value.requireObject({"pieces", "reach"});
    return {.fragments = value["pieces"].index(), .falloffRadius = value["reach"].number()};
}

void writeRequirementMembers(JsonWriter& json, const StrengthRequirement& requirement) {
    json.text("outcome", kOutcomes[static_cast<std::size_t>(requirement.outcome)]);
    if (requirement.outcome == RequirementOutcome::HoleAtMost) json.number("hole", requirement.hole);
    json.text("kind", kEvents[requirement.event.index()]);
    std::visit([&](const auto& event) { writeEvent(json, event); }, requirement.event);
}

void writeRequirement(JsonWriter& json, const StrengthRequirement& requirement) {
    json.openObject({}, JsonLayout::Inline);
    writeRequirementMembers(json, requirement);
    json.close();
}

StrengthRequirement readRequirement(const JsonValue& value) {
    value.requireObject({"outcome", "kind"}, {"hole", "height", "mass", "speed", "impulse"});
    StrengthRequirement read{.outcome = static_cast<RequirementOutcome>(value["outcome"].oneOf(kOutcomes)),
                             .event = readEvent(value["kind"].oneOf(kEvents), value)};
    const JsonValue hole = value["hole"];
    if (read.outcome == RequirementOutcome::HoleAtMost) {
        value.requireKeys({"hole"});
        if (hole.isPresent()) read.hole = hole.number();
    } else if (hole.isPresent()) {
        hole.fail("belongs to the outcome \"holeAtMost\" only");
    }
    return read;
}

}  // namespace rubble
