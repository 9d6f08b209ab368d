#include "core/io/PlayInputJson.h"

#include "core/io/AssetJson.h"
#include "core/io/SceneJson.h"
#include "core/io/ShotJson.h"

#include <array>

namespace rubble {
namespace {

// In the order of the alternatives of PlayInput.
constexpr std::array<std::string_view, 9> kInputs{"shot",        "threshold", "material", "break", "gravity",
                                                  "destruction", "grab",      "drag",     "letGo"};
static_assert(kInputs.size() == std::variant_size_v<PlayInput>);

void writeInput(JsonLayout& json, const ShotInput& input) { writeShotAction(json, input.name, input.action); }

void writeInput(JsonLayout& json, const ThresholdInput& input) {
    json.wholeNumber("asset", std::uint64_t{input.asset});
    json.wholeNumber("instance", std::uint64_t{input.instance});
    json.number("threshold", input.threshold);
}

void writeInput(JsonLayout& json, const MaterialInput& input) {
    json.openArray("materials");
    writeMaterialVersion1(json, input.material);  // strength comes as thresholds
    json.close();
}

void writeInput(JsonLayout& json, const BreakInput& input) { json.wholeNumber("body", std::uint64_t{input.body}); }

void writeInput(JsonLayout& json, const GravityInput& input) { writeVector(json, "gravity", input.gravity); }

void writeInput(JsonLayout& json, const DestructionInput& input) { json.boolean("on", input.isOn); }

void writeInput(JsonLayout& json, const GrabInput& input) {
    json.wholeNumber("body", std::uint64_t{input.body});
    writeVector(json, "point", input.point);
    json.number("force", input.force);
}

void writeInput(JsonLayout& json, const DragInput& input) { writeVector(json, "to", input.to); }

void writeInput(JsonLayout&, const LetGoInput&) {}

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
            const std::vector<Material> materials = value["materials"].listOf(readMaterialVersion1);
            if (materials.size() != 1) value["materials"].refuse("must hold one material");
            return MaterialInput{materials.empty() ? Material{} : materials[0]};
        }
        case 3: value.requireObject({"step", "input", "body"}); return BreakInput{value["body"].index()};
        case 4: value.requireObject({"step", "input", "gravity"}); return GravityInput{readVector(value["gravity"])};
        case 5: value.requireObject({"step", "input", "on"}); return DestructionInput{value["on"].boolean()};
        case 6:
            value.requireObject({"step", "input", "body", "point", "force"});
            return GrabInput{value["body"].index(), readVector(value["point"]), value["force"].number()};
        case 7: value.requireObject({"step", "input", "to"}); return DragInput{readVector(value["to"])};
        default: value.requireObject({"step", "input"}); return LetGoInput{};
    }
}

}  // namespace

void writeTimedInput(JsonLayout& json, const TimedInput& timed) {
    json.openObject();
    json.wholeNumber("step", timed.step);
    json.text("input", kInputs[timed.input.index()]);
    std::visit([&](const auto& input) { writeInput(json, input); }, timed.input);
    json.close();
}

TimedInput readTimedInput(const JsonValue& value) {
    return {value["step"].wholeNumber(), readInput(value["input"].oneOf(kInputs), value)};
}

}  // namespace rubble
