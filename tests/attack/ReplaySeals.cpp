#include "tests/attack/ReplaySeals.h"

#include "core/io/json/JsonDocument.h"
#include "core/io/play/PlayInputJson.h"
#include "core/io/play/ReplayFile.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

namespace rubble::attack {
namespace {

using Json = nlohmann::ordered_json;

/// A number that is no index.
struct NoIndex : std::runtime_error {
    NoIndex() : std::runtime_error("no index") {}
};

std::uint64_t wholeOf(const Json& value, double most) {
    const double number = value.get<double>();
    if (!(number >= 0.0 && number <= most && number == std::floor(number))) throw NoIndex();
    return static_cast<std::uint64_t>(number);
}

std::uint32_t indexOf(const Json& value) {
    return static_cast<std::uint32_t>(wholeOf(value, std::numeric_limits<std::uint32_t>::max()));
}

ReplayStep stepOf(const Json& value, bool isDetailed) {
    const auto hexOf = [&](const char* key) {
        return std::strtoull(value.at(key).get<std::string>().c_str(), nullptr, 16);
    };
    ReplayStep step{.hash = hexOf("hash")};
    if (value.contains("events")) step.events = hexOf("events");
    const Json& moved = value.at("moved");
    const std::size_t length = isDetailed ? 5 : 2;
    for (std::size_t k = 0; k + length <= moved.size(); k += length) {
        BodyCheck check{indexOf(moved[k]), indexOf(moved[k + 1]), {}};
        for (int axis = 0; isDetailed && axis < 3; ++axis)
            check.velocity[axis] = moved[k + 2 + static_cast<std::size_t>(axis)].get<double>();
        step.moved.push_back(check);
    }
    if (!isDetailed) return step;
    const Json& broke = value.at("broke");
    for (std::size_t k = 0; k + 2 <= broke.size(); k += 2)
        step.broke.push_back({indexOf(broke[k]), broke[k + 1].get<double>()});
    return step;
}

ReplayKeyframe keyframeOf(const Json& value) {
    constexpr double kMaxExact = 9007199254740992.0;
    ReplayKeyframe frame{.step = wholeOf(value.at("step"), kMaxExact)};
    for (const Json& body : value.at("bodies")) {
        const auto p = body.at("position").get<std::array<double, 3>>();
        const auto q = body.at("orientation").get<std::array<double, 4>>();
        frame.bodies.push_back({indexOf(body.at("body")), {{p[0], p[1], p[2]}, Quat{q[0], q[1], q[2], q[3]}}});
    }
    return frame;
}

std::vector<TimedInput> inputsOf(const Json& value) {
    const std::string text = value.dump();
    Result<JsonDocument> document = JsonDocument::parse(text);
    if (!document) throw NoIndex();
    std::vector<TimedInput> inputs = document->root().list(readTimedInput);
    if (document->firstError()) throw NoIndex();
    return inputs;
}

/// A replay with the lists of a document.
Replay replayOf(const Json& root) {
    Replay replay{.isDetailed = root.at("version").get<double>() != 1.0};
    replay.inputs = inputsOf(root.at("inputs"));
    for (const Json& step : root.at("steps")) replay.steps.push_back(stepOf(step, replay.isDetailed));
    for (const Json& frame : root.at("keyframes")) replay.keyframes.push_back(keyframeOf(frame));
    return replay;
}

}  // namespace

std::string withReplaySeals(std::string_view replay) {
    try {
        Json root = Json::parse(replay);
        const Json sealed = Json::parse(replayText(replayOf(root)));
        for (const auto& item : sealed.items()) {
            if (item.key().ends_with("Seals") || item.key().ends_with("Seal")) root[item.key()] = item.value();
        }
        return root.dump();
    } catch (const Json::exception&) {
        return std::string(replay);
    } catch (const NoIndex&) {
        return std::string(replay);
    }
}

}  // namespace rubble::attack
