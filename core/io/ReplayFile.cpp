#include "core/io/ReplayFile.h"

#include "core/io/AtomicFile.h"
#include "core/io/FormatVersion.h"
#include "core/io/PlayInputJson.h"
#include "core/io/ProjectFile.h"
#include "core/io/SceneJson.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr FileFormat kFormat{.name = "rubble-replay", .noun = "replay", .version = kReplayVersion};

std::string hexOf(std::uint64_t value) { return ContentHash{0, value}.hex().substr(16); }

/// Sixteen hexadecimal digits.
std::uint64_t readHex(const JsonValue& value) {
    const std::optional<ContentHash> hash = contentHashOf(std::string(16, '0') + value.text());
    if (!hash) value.refuse("expected sixteen hexadecimal digits");
    return hash.value_or(ContentHash{}).low;
}

void writeStep(JsonLayout& json, const ReplayStep& step) {
    json.openObject({}, JsonLines::One);
    json.text("hash", hexOf(step.hash));
    json.openArray("moved", JsonLines::One);
    for (const BodyCheck& one : step.moved) {
        json.wholeNumber({}, std::uint64_t{one.body});
        json.wholeNumber({}, std::uint64_t{one.check});
    }
    json.close();
    json.close();
}

ReplayStep readStep(const JsonValue& value) {
    value.requireObject({"hash", "moved"});
    ReplayStep step{.hash = readHex(value["hash"])};
    const std::vector<std::uint32_t> numbers = value["moved"].listOf([](const JsonValue& one) { return one.index(); });
    if (numbers.size() % 2 != 0) value["moved"].refuse("expected pairs of a body and its check");
    for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) step.moved.push_back({numbers[k], numbers[k + 1]});
    return step;
}

void writeBody(JsonLayout& json, const ReplayBody& body) {
    const Quat& turn = body.pose.orientation;
    json.openObject({}, JsonLines::One);
    json.wholeNumber("body", std::uint64_t{body.number});
    writeVector(json, "position", body.pose.position);
    json.numbers("orientation", {turn.w, turn.x, turn.y, turn.z});
    json.close();
}

ReplayBody readBody(const JsonValue& value) {
    value.requireObject({"body", "position", "orientation"});
    const auto [w, x, y, z] = value["orientation"].numbers<4>();
    return {value["body"].index(), {readVector(value["position"]), Quat{w, x, y, z}}};
}

void writeKeyframe(JsonLayout& json, const ReplayKeyframe& frame) {
    json.openObject();
    json.wholeNumber("step", frame.step);
    json.list("bodies", frame.bodies, writeBody);
    json.close();
}

ReplayKeyframe readKeyframe(const JsonValue& value) {
    value.requireObject({"step", "bodies"});
    return {value["step"].wholeNumber(), value["bodies"].listOf(readBody)};
}

/// A hash of a part as it is written.
template <class Element>
std::string sealOf(const std::vector<Element>& elements, void (*write)(JsonLayout&, const Element&)) {
    JsonLayout json;
    json.openObject();
    json.list("sealed", elements, write);
    json.close();
    return contentHash(std::move(json).finished()).hex();
}

template <class Element>
void writeSealed(JsonLayout& json, const std::string& name, const std::vector<Element>& elements,
                 void (*write)(JsonLayout&, const Element&)) {
    json.list(name, elements, write);
    json.text(name + "Seal", sealOf(elements, write));
}

template <class Element>
std::vector<Element> readSealed(const JsonValue& root, const std::string& name, Element (*read)(const JsonValue&),
                                void (*write)(JsonLayout&, const Element&)) {
    std::vector<Element> elements = root[name].listOf(read);
    const JsonValue seal = root[name + "Seal"];
    if (seal.text() != sealOf(elements, write)) seal.refuse("the " + name + " were altered after they were recorded");
    return elements;
}

Replay readReplay(const JsonValue& root) {
    root.requireObject({"format", "version", "program", "project", "dt", "sleeping", "destruction", "inputs",
                        "inputsSeal", "steps", "stepsSeal", "keyframes", "keyframesSeal"});
    const std::string project = root["project"].text();
    Replay replay{.program = root["program"].text(),
                  .dt = root["dt"].number(above(0.0)),
                  .sleeping = root["sleeping"].boolean(),
                  .hasDestruction = root["destruction"].boolean(),
                  .inputs = readSealed(root, "inputs", readTimedInput, writeTimedInput),
                  .steps = readSealed(root, "steps", readStep, writeStep),
                  .keyframes = readSealed(root, "keyframes", readKeyframe, writeKeyframe)};
    if (!std::ranges::is_sorted(replay.inputs, {}, &TimedInput::step))
        root["inputs"].refuse("expected ascending steps");
    const std::optional<ContentHash> hash = contentHashOf(project);
    if (!hash) root["project"].refuse("expected thirty-two hexadecimal digits");
    replay.project = hash.value_or(ContentHash{});
    return replay;
}

Error about(const char* what, const std::filesystem::path& path, const Error& error) {
    return {error.code, std::string(what) + " \"" + path.string() + "\": " + error.message};
}

}  // namespace

ContentHash projectHash(const Project& project) { return contentHash(projectText(project)); }

std::string replayText(const Replay& replay) {
    JsonLayout json;
    json.openObject();
    json.text("format", kFormat.name);
    json.wholeNumber("version", std::uint64_t{kReplayVersion});
    json.text("program", replay.program);
    json.text("project", replay.project.hex());
    json.number("dt", replay.dt);
    json.boolean("sleeping", replay.sleeping);
    json.boolean("destruction", replay.hasDestruction);
    writeSealed(json, "inputs", replay.inputs, writeTimedInput);
    writeSealed(json, "steps", replay.steps, writeStep);
    writeSealed(json, "keyframes", replay.keyframes, writeKeyframe);
    json.close();
    return std::move(json).finished();
}

Result<Replay> readReplayText(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    const Result<std::uint32_t> version = versionOf(*document, kFormat);
    if (!version) return version.error();
    Replay replay = readReplay(document->root());
    if (document->fault()) return *document->fault();
    return replay;
}

Result<Replay> loadReplay(const std::filesystem::path& path) {
    const Result<std::string> text = readFile(path);
    if (!text) return text.error();
    Result<Replay> replay = readReplayText(*text);
    if (!replay) return about("Cannot read", path, replay.error());
    return replay;
}

Status saveReplay(const std::filesystem::path& path, const Replay& replay) {
    return writeFileAtomically(path, replayText(replay));
}

}  // namespace rubble
