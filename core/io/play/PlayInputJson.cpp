#include "core/io/play/PlayInputJson.h"

#include "core/io/json/VectorJson.h"
#include "core/io/project/AssetJson.h"
#include "core/io/project/ShotJson.h"

#include <array>

namespace rubble {
namespace {

// In the order of the alternatives of PlayInput.
constexpr std::array<std::string_view, 10> kInputs{"shot",        "threshold", "material", "break", "gravity",
                                                   "destruction", "grab",      "drag",     "letGo", "remove"};
static_assert(kInputs.size() == std::variant_size_v<PlayInput>);

void writeInput(JsonWriter& json, const ShotInput& input) { writeShotAction(json, input.name, input.action); }

void writeInput(JsonWriter& json, const ThresholdInput& input) {
    json.wholeNumber("asset", std::uint64_t{input.asset});
    json.wholeNumber("instance", std::uint64_t{input.instance});
    json.number("threshold", input.threshold);
}

void writeInput(JsonWriter& json, const MaterialInput& input) {
    json.openArray("materials");
    writeMaterialBeforeVersion5(json, input.material);  // without strength: its thresholds are inputs of their own
    json.close();
}

void writeInput(JsonWriter& json, const BreakInput& input) { json.wholeNumber("body", std::uint64_t{input.body}); }

void writeInput(JsonWriter& json, const GravityInput& input) { writeVector(json, "gravity", input.gravity); }

void writeInput(JsonWriter& json, const DestructionInput& input) { json.boolean("on", input.isOn); }

void writeInput(JsonWriter& json, const GrabInput& input) {
    json.wholeNumber("body", std::uint64_t{input.body});
    writeVector(json, "point", input.point);
    json.number("force", input.force);
}

void writeInput(JsonWriter& json, const DragInput& input) { writeVector(json, "to", input.to); }

void writeInput(JsonWriter&, const ReleaseInput&) {}

void writeInput(JsonWriter& json, const RemoveInput& input) {
    json.wholeNumber("instance", std::uint64_t{input.part.instance});
    writeFragmentPaths(json, input.part.fragments);
}

PlayInput readInput(std::size_t kind, const JsonValue& value) {
    switch (kind) {
        case 0: {
            value.requireObject({"step", "input", "name", "kind", "action"});
            auto [name, action] = readShotAction(value);
            return ShotInput{std::move(name), action};
        }
        case 1:
            value.requireObject({"step", "input", "asset", "instance", "threshold"});
            return ThresholdInput{value["asset"].index(), value["instance"].index(), value["threshold"].number()};
        case 2: {
            value.requireObject({"step", "input", "materials"});
            const std::vector<Material> materials = value["materials"].list(readMaterialBeforeVersion5);
            if (materials.size() != 1) value["materials"].fail("expected one material");
            return MaterialInput{materials.empty() ? Material{} : materials[0]};
        }
        case 3: value.requireObject({"step", "input", "body"}); return BreakInput{value["body"].index()};
        case 4: value.requireObject({"step", "input", "gravity"}); return GravityInput{readVector(value["gravity"])};
        case 5: value.requireObject({"step", "input", "on"}); return DestructionInput{value["on"].boolean()};
        case 6:
            value.requireObject({"step", "input", "body", "point", "force"});
            return GrabInput{value["body"].index(), readVector(value["point"]), value["force"].number()};
        case 7: value.requireObject({"step", "input", "to"}); return DragInput{readVector(value["to"])};
        case 8: value.requireObject({"step", "input"}); return ReleaseInput{};
        default:
            value.requireObject({"step", "input", "instance", "fragments"});
            return RemoveInput{{value["instance"].index(), readFragmentPaths(value)}};
    }
}

}  // namespace

void writeTimedInput(JsonWriter& json, const TimedInput& timed) {
    json.openObject();
    json.wholeNumber("step", timed.step);
    json.text("input", kInputs[timed.input.index()]);
    std::visit([&](const auto& input) { writeInput(json, input); }, timed.input);
    json.close();
}

TimedInput readTimedInput(const JsonValue& value) {
    // Which other keys an input has depends on its kind.
    value.requireObject({"step", "input"}, {"name", "kind", "action", "asset", "instance", "threshold", "materials",
                                            "body", "gravity", "on", "point", "force", "to", "fragments"});
    return {value["step"].wholeNumber(), readInput(value["input"].oneOf(kInputs), value)};
}

}  // namespace rubble
