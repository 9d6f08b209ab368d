#include "core/io/play/ReplayFile.h"

#include "core/io/json/FormatVersion.h"
#include "core/io/json/VectorJson.h"
#include "core/io/play/PlayInputJson.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileErrors.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr FileFormat kReplayFormat{.name = "rubble-replay", .noun = "replay", .version = kReplayVersion};

std::string hexOf(std::uint64_t value) { return ContentHash{0, value}.hex().substr(16); }

/// Reads sixteen hexadecimal digits.
std::uint64_t readHex(const JsonValue& value) {
    const std::optional<ContentHash> hash = parseContentHash(std::string(16, '0') + value.text());
    if (!hash) value.fail("expected sixteen hexadecimal digits");
    return hash.value_or(ContentHash{}).low;
}

void writeCheckVersion1(JsonWriter& json, const BodyCheck& check) {
    json.wholeNumber({}, std::uint64_t{check.body});
    json.wholeNumber({}, std::uint64_t{check.check});
}

void writeCheck(JsonWriter& json, const BodyCheck& check) {
    writeCheckVersion1(json, check);
    json.number({}, check.velocity.x);
    json.number({}, check.velocity.y);
    json.number({}, check.velocity.z);
}

/// Opens a step with what all versions have: its hash and, as a flat array, the bodies that moved.
void openStep(JsonWriter& json, const ReplayStep& step, void (*write)(JsonWriter&, const BodyCheck&)) {
    json.openObject({}, JsonLayout::Inline);
    json.text("hash", hexOf(step.hash));
    json.openArray("moved", JsonLayout::Inline);
    for (const BodyCheck& check : step.moved) write(json, check);
    json.close();
}

void writeStep(JsonWriter& json, const ReplayStep& step) {
    openStep(json, step, writeCheck);
    json.openArray("broke", JsonLayout::Inline);
    for (const ReplayBreak& broken : step.broke) {
        json.wholeNumber({}, std::uint64_t{broken.body});
        json.number({}, broken.impact);
    }
    json.close();
    if (step.events) json.text("events", hexOf(*step.events));
    json.close();
}

void writeStepVersion1(JsonWriter& json, const ReplayStep& step) {
    openStep(json, step, writeCheckVersion1);
    json.close();
}

/// Reads a flat array of records: `read` is given the values of each.
template <class Read>
void readRecords(const JsonValue& value, std::size_t length, const char* expected, Read read) {
    std::vector<JsonValue> record;
    for (const JsonValue element : value.elements()) {
        record.push_back(element);
        if (record.size() < length) continue;
        read(record);
        record.clear();
    }
    if (!record.empty()) value.fail(expected);
}

/// Reads what versions 2 and 3 have.
ReplayStep readDetailedStep(const JsonValue& value) {
    ReplayStep step{.hash = readHex(value["hash"])};
    readRecords(value["moved"], 5, "expected a body, its check and its velocity for each", [&](const auto& record) {
        step.moved.push_back(
            {record[0].index(), record[1].index(), {record[2].number(), record[3].number(), record[4].number()}});
    });
    readRecords(value["broke"], 2, "expected pairs of a body and its impact", [&](const auto& record) {
        step.broke.push_back({record[0].index(), record[1].number()});
    });
    return step;
}

ReplayStep readStep(const JsonValue& value) {
    value.requireObject({"hash", "moved", "broke", "events"});
    ReplayStep step = readDetailedStep(value);
    step.events = readHex(value["events"]);
    return step;
}

ReplayStep readStepVersion2(const JsonValue& value) {
    value.requireObject({"hash", "moved", "broke"});
    return readDetailedStep(value);
}

ReplayStep readStepVersion1(const JsonValue& value) {
    value.requireObject({"hash", "moved"});
    ReplayStep step{.hash = readHex(value["hash"])};
    readRecords(value["moved"], 2, "expected pairs of a body and its check", [&](const auto& record) {
        step.moved.push_back({record[0].index(), record[1].index(), {}});
    });
    return step;
}

void writeReplayBody(JsonWriter& json, const ReplayBody& body) {
    const Quat& orientation = body.pose.orientation;
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("body", std::uint64_t{body.number});
    writeVector(json, "position", body.pose.position);
    json.numbers("orientation", {orientation.w, orientation.x, orientation.y, orientation.z});
    json.close();
}

ReplayBody readReplayBody(const JsonValue& value) {
    value.requireObject({"body", "position", "orientation"});
    const auto [w, x, y, z] = value["orientation"].numbers<4>();
    return {value["body"].index(), {readVector(value["position"]), Quat{w, x, y, z}}};
}

void writeKeyframe(JsonWriter& json, const ReplayKeyframe& frame) {
    json.openObject();
    json.wholeNumber("step", frame.step);
    json.list("bodies", frame.bodies, writeReplayBody);
    json.close();
}

ReplayKeyframe readKeyframe(const JsonValue& value) {
    value.requireObject({"step", "bodies"});
    return {value["step"].wholeNumber(), value["bodies"].list(readReplayBody)};
}

template <class Element>
using WriteElement = void (*)(JsonWriter&, const Element&);
template <class Element>
using ReadElement = Element (*)(const JsonValue&);

/// The text of one element as it is sealed.
template <class Element>
std::string textOf(const Element& element, WriteElement<Element> write) {
    JsonWriter json;
    json.openArray();
    write(json, element);
    json.close();
    return std::move(json).contents();
}

/// The seals of the elements of a list: a hash of each as it is written and of the seal before it, so that the first
/// seal that does not match is that of the first element that was changed, added or removed.
template <class Element>
std::vector<std::uint64_t> sealsOf(const std::vector<Element>& elements, WriteElement<Element> write) {
    std::vector<std::uint64_t> seals;
    seals.reserve(elements.size());
    std::uint64_t last = 0;
    for (const Element& element : elements) {
        last = contentHash(hexOf(last) + textOf(element, write)).low;
        seals.push_back(last);
    }
    return seals;
}

template <class Element>
void writeSealed(JsonWriter& json, const std::string& name, const std::vector<Element>& elements,
                 WriteElement<Element> write) {
    json.list(name, elements, write);
    json.openArray(name + "Seals", JsonLayout::Inline);
    for (const std::uint64_t seal : sealsOf(elements, write)) json.text({}, hexOf(seal));
    json.close();
}

template <class Element>
std::vector<Element> readSealed(const JsonValue& root, const std::string& name, ReadElement<Element> read,
                                WriteElement<Element> write) {
    std::vector<Element> elements = root[name].list(read);
    const std::vector<std::uint64_t> recorded = root[name + "Seals"].list(readHex);
    if (elements.size() == recorded.size() && sealsOf(elements, write) == recorded) return elements;
    const std::vector<std::uint64_t> seals = sealsOf(elements, write);
    const auto different = static_cast<std::size_t>(std::ranges::mismatch(seals, recorded).in1 - seals.begin());
    std::size_t number = 0;
    for (const JsonValue element : root[name].elements()) {
        if (number++ == different) element.fail("changed after the recording, or what was here was removed");
    }
    root[name].fail("elements were removed from the end after the recording");
    return elements;
}

/// A hash of a whole list as version 1 holds it.
template <class Element>
std::string checksumOf(const std::vector<Element>& elements, WriteElement<Element> write) {
    JsonWriter json;
    json.openObject();
    json.list("sealed", elements, write);
    json.close();
    return contentHash(std::move(json).finished()).hex();
}

template <class Element>
void writeWithChecksum(JsonWriter& json, const std::string& name, const std::vector<Element>& elements,
                       WriteElement<Element> write) {
    json.list(name, elements, write);
    json.text(name + "Seal", checksumOf(elements, write));
}

template <class Element>
std::vector<Element> readWithChecksum(const JsonValue& root, const std::string& name, ReadElement<Element> read,
                                      WriteElement<Element> write) {
    std::vector<Element> elements = root[name].list(read);
    const JsonValue checksum = root[name + "Seal"];
    if (checksum.text() != checksumOf(elements, write))
        checksum.fail("the " + name + " were changed after the recording");
    return elements;
}

void readLists(const JsonValue& root, std::uint32_t version, Replay& replay) {
    replay.inputs = readSealed(root, "inputs", readTimedInput, writeTimedInput);
    replay.steps = readSealed(root, "steps", version > 2 ? readStep : readStepVersion2, writeStep);
    replay.keyframes = readSealed(root, "keyframes", readKeyframe, writeKeyframe);
}

void readListsVersion1(const JsonValue& root, Replay& replay) {
    replay.inputs = readWithChecksum(root, "inputs", readTimedInput, writeTimedInput);
    replay.steps = readWithChecksum(root, "steps", readStepVersion1, writeStepVersion1);
    replay.keyframes = readWithChecksum(root, "keyframes", readKeyframe, writeKeyframe);
}

Replay readReplay(const JsonValue& root, std::uint32_t version) {
    const bool isDetailed = version > 1;
    const char* const inputsSeal = isDetailed ? "inputsSeals" : "inputsSeal";
    const char* const stepsSeal = isDetailed ? "stepsSeals" : "stepsSeal";
    const char* const keyframesSeal = isDetailed ? "keyframesSeals" : "keyframesSeal";
    root.requireObject({"format", "version", "program", "project", "dt", "sleeping", "destruction", "inputs",
                        inputsSeal, "steps", stepsSeal, "keyframes", keyframesSeal});
    Replay replay{.program = root["program"].text(),
                  .dt = root["dt"].number(above(0.0)),
                  .sleeping = root["sleeping"].boolean(),
                  .hasDestruction = root["destruction"].boolean(),
                  .isDetailed = isDetailed};
    const std::string project = root["project"].text();
    const std::optional<ContentHash> hash = parseContentHash(project);
    if (!hash) root["project"].fail("expected thirty-two hexadecimal digits");
    replay.project = hash.value_or(ContentHash{});
    isDetailed ? readLists(root, version, replay) : readListsVersion1(root, replay);
    if (!std::ranges::is_sorted(replay.inputs, {}, &TimedInput::step)) root["inputs"].fail("expected ascending steps");
    return replay;
}

std::uint32_t versionOf(const Replay& replay) {
    if (!replay.isDetailed) return 1;
    const auto hasEvents = [](const ReplayStep& step) { return step.events.has_value(); };
    return std::ranges::all_of(replay.steps, hasEvents) ? kReplayVersion : 2;
}

}  // namespace

ContentHash projectHash(const Project& project) { return contentHash(projectText(project)); }

ContentHash sceneHash(Project project) {
    project.nextId = 0;
    project.shots.clear();
    project.playTests.clear();
    project.events = {};
    for (Asset& asset : project.assets) asset.requirements.clear();
    return projectHash(project);
}

std::string replayText(const Replay& replay) {
    JsonWriter json;
    json.openObject();
    json.text("format", kReplayFormat.name);
    json.wholeNumber("version", std::uint64_t{versionOf(replay)});
    json.text("program", replay.program);
    json.text("project", replay.project.hex());
    json.number("dt", replay.dt);
    json.boolean("sleeping", replay.sleeping);
    json.boolean("destruction", replay.hasDestruction);
    if (replay.isDetailed) {
        writeSealed(json, "inputs", replay.inputs, writeTimedInput);
        writeSealed(json, "steps", replay.steps, writeStep);
        writeSealed(json, "keyframes", replay.keyframes, writeKeyframe);
    } else {
        writeWithChecksum(json, "inputs", replay.inputs, writeTimedInput);
        writeWithChecksum(json, "steps", replay.steps, writeStepVersion1);
        writeWithChecksum(json, "keyframes", replay.keyframes, writeKeyframe);
    }
    json.close();
    return std::move(json).finished();
}

Result<Replay> readReplayText(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    const Result<std::uint32_t> version = versionOf(*document, kReplayFormat);
    if (!version) return version.error();
    Replay replay = readReplay(document->root(), *version);
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

Status saveReplay(const std::filesystem::path& path, const Replay& replay, std::size_t maxSize) {
    const std::string text = replayText(replay);
    if (text.size() > maxSize) {
        return withPath("Cannot write", path,
                        {ErrorCode::Limit, "The replay takes " + std::to_string(text.size()) + " bytes, but at most " +
                                               std::to_string(maxSize) + " are read back; record fewer steps."});
    }
    return writeFileAtomically(path, text);
}

Status ReplaySize::add(const Replay& replay) {
    constexpr std::size_t kBesideElement = 64;  // its seal, and white space at its place in the file
    for (; m_inputs < replay.inputs.size(); ++m_inputs)
        m_bytes += 2 * textOf(replay.inputs[m_inputs], writeTimedInput).size() + kBesideElement;  // nested deeper
    m_bytes += textOf(replay.steps.back(), writeStep).size() + kBesideElement;
    for (; m_keyframes < replay.keyframes.size(); ++m_keyframes) {
        const ReplayKeyframe& frame = replay.keyframes[m_keyframes];
        m_bytes += textOf(frame, writeKeyframe).size() + 4 * frame.bodies.size() + kBesideElement;
    }
    if (m_bytes <= m_maxSize) return success();
    return Error{ErrorCode::Limit, "The recording of " + std::to_string(replay.steps.size()) +
                                       " steps is larger than " + std::to_string(m_maxSize) +
                                       " bytes, which is all that is read back; record at most " +
                                       std::to_string(replay.steps.size() - 1) + " steps."};
}

}  // namespace rubble
