#include "core/io/play/ReplayFile.h"

#include "core/io/json/FormatVersion.h"
#include "core/io/play/PlayInputJson.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/SceneJson.h"
#include "core/io/system/AtomicFile.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr FileFormat kFormat{.name = "rubble-replay", .noun = "replay", .version = kReplayVersion};

std::string hexOf(std::uint64_t value) { return ContentHash{0, value}.hex().substr(16); }

/// Reads sixteen hexadecimal digits.
std::uint64_t readHex(const JsonValue& value) {
    const std::optional<ContentHash> hash = parseContentHash(std::string(16, '0') + value.text());
    if (!hash) value.fail("expected sixteen hexadecimal digits");
    return hash.value_or(ContentHash{}).low;
}

void writeStep(JsonWriter& json, const ReplayStep& step) {
    json.openObject({}, JsonLayout::Inline);
    json.text("hash", hexOf(step.hash));
    json.openArray("moved", JsonLayout::Inline);
    for (const BodyCheck& check : step.moved) {
        json.wholeNumber({}, std::uint64_t{check.body});
        json.wholeNumber({}, std::uint64_t{check.check});
    }
    json.close();
    json.close();
}

ReplayStep readStep(const JsonValue& value) {
    value.requireObject({"hash", "moved"});
    ReplayStep step{.hash = readHex(value["hash"])};
    const std::vector<std::uint32_t> numbers =
        value["moved"].list([](const JsonValue& number) { return number.index(); });
    if (numbers.size() % 2 != 0) value["moved"].fail("expected pairs of a body and its check");
    for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) step.moved.push_back({numbers[k], numbers[k + 1]});
    return step;
}

void writeBody(JsonWriter& json, const ReplayBody& body) {
    const Quat& orientation = body.pose.orientation;
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("body", std::uint64_t{body.number});
    writeVector(json, "position", body.pose.position);
    json.numbers("orientation", {orientation.w, orientation.x, orientation.y, orientation.z});
    json.close();
}

ReplayBody readBody(const JsonValue& value) {
    value.requireObject({"body", "position", "orientation"});
    const auto [w, x, y, z] = value["orientation"].numbers<4>();
    return {value["body"].index(), {readVector(value["position"]), Quat{w, x, y, z}}};
}

void writeKeyframe(JsonWriter& json, const ReplayKeyframe& frame) {
    json.openObject();
    json.wholeNumber("step", frame.step);
    json.list("bodies", frame.bodies, writeBody);
    json.close();
}

ReplayKeyframe readKeyframe(const JsonValue& value) {
    value.requireObject({"step", "bodies"});
    return {value["step"].wholeNumber(), value["bodies"].list(readBody)};
}

/// A hash of a part as it is written.
template <class Element>
std::string checksumOf(const std::vector<Element>& elements, void (*write)(JsonWriter&, const Element&)) {
    JsonWriter json;
    json.openObject();
    json.list("sealed", elements, write);
    json.close();
    return contentHash(std::move(json).finished()).hex();
}

template <class Element>
void writeWithChecksum(JsonWriter& json, const std::string& name, const std::vector<Element>& elements,
                       void (*write)(JsonWriter&, const Element&)) {
    json.list(name, elements, write);
    json.text(name + "Seal", checksumOf(elements, write));
}

template <class Element>
std::vector<Element> readWithChecksum(const JsonValue& root, const std::string& name, Element (*read)(const JsonValue&),
                                      void (*write)(JsonWriter&, const Element&)) {
    std::vector<Element> elements = root[name].list(read);
    const JsonValue checksum = root[name + "Seal"];
    if (checksum.text() != checksumOf(elements, write))
        checksum.fail("the " + name + " were changed after the recording");
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
                  .inputs = readWithChecksum(root, "inputs", readTimedInput, writeTimedInput),
                  .steps = readWithChecksum(root, "steps", readStep, writeStep),
                  .keyframes = readWithChecksum(root, "keyframes", readKeyframe, writeKeyframe)};
    if (!std::ranges::is_sorted(replay.inputs, {}, &TimedInput::step)) root["inputs"].fail("expected ascending steps");
    const std::optional<ContentHash> hash = parseContentHash(project);
    if (!hash) root["project"].fail("expected thirty-two hexadecimal digits");
    replay.project = hash.value_or(ContentHash{});
    return replay;
}

Error withPath(const char* what, const std::filesystem::path& path, const Error& error) {
    return {error.code, std::string(what) + " \"" + path.string() + "\": " + error.message};
}

}  // namespace

ContentHash projectHash(const Project& project) { return contentHash(projectText(project)); }

std::string replayText(const Replay& replay) {
    JsonWriter json;
    json.openObject();
    json.text("format", kFormat.name);
    json.wholeNumber("version", std::uint64_t{kReplayVersion});
    json.text("program", replay.program);
    json.text("project", replay.project.hex());
    json.number("dt", replay.dt);
    json.boolean("sleeping", replay.sleeping);
    json.boolean("destruction", replay.hasDestruction);
    writeWithChecksum(json, "inputs", replay.inputs, writeTimedInput);
    writeWithChecksum(json, "steps", replay.steps, writeStep);
    writeWithChecksum(json, "keyframes", replay.keyframes, writeKeyframe);
    json.close();
    return std::move(json).finished();
}

Result<Replay> readReplayText(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    const Result<std::uint32_t> version = versionOf(*document, kFormat);
    if (!version) return version.error();
    Replay replay = readReplay(document->root());
    if (document->firstError()) return *document->firstError();
    return replay;
}

Result<Replay> loadReplay(const std::filesystem::path& path) {
    const Result<std::string> text = readFile(path);
    if (!text) return text.error();
    Result<Replay> replay = readReplayText(*text);
    if (!replay) return withPath("Cannot read", path, replay.error());
    return replay;
}

Status saveReplay(const std::filesystem::path& path, const Replay& replay) {
    return writeFileAtomically(path, replayText(replay));
}

}  // namespace rubble
