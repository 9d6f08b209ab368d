#include "core/io/play/SimulationJson.h"

#include "core/io/json/JsonWriter.h"
#include "core/io/json/VectorJson.h"

namespace rubble {
namespace {

void writeBody(JsonWriter& json, const SimulatedBody& body) {
    const Quat& orientation = body.pose.orientation;
    json.openObject({}, JsonLayout::Inline);
    json.text("name", body.name);
    writeVector(json, "position", body.pose.position);
    json.numbers("orientation", {orientation.w, orientation.x, orientation.y, orientation.z});
    json.boolean("asleep", body.isAsleep);
    json.close();
}

void writeBreak(JsonWriter& json, const SimulatedBreak& broken) {
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("step", broken.step);
    json.text("body", broken.body);
    json.number("impact", broken.impact);
    json.number("threshold", broken.threshold);
    writeVector(json, "point", broken.point);
    json.wholeNumber("fragments", broken.fragments);
    if (broken.swapMilliseconds) json.number("swapMilliseconds", *broken.swapMilliseconds);
    json.close();
}

void writeSplit(JsonWriter& json, const SimulatedSplit& split) {
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("step", split.step);
    json.text("body", split.body);
    json.number("impulse", split.impulse);
    writeVector(json, "point", split.point);
    json.wholeNumber("bonds", std::uint64_t{split.bonds});
    json.number("area", split.area);
    json.wholeNumber("freed", std::uint64_t{split.freed});
    json.close();
}

void writeCounts(JsonWriter& json, const SimulatedCounts& counts) {
    json.openObject("counts", JsonLayout::Inline);
    json.number("bodies", counts.bodies);
    json.number("pairs", counts.pairs);
    json.number("contactPoints", counts.contactPoints);
    json.close();
}

void writeTimes(JsonWriter& json, const StepMilliseconds& times) {
    json.openObject("stepMilliseconds", JsonLayout::Inline);
    json.number("median", times.median);
    json.number("p99", times.p99);
    json.number("max", times.max);
    json.close();
}

}  // namespace

std::string simulationJson(const SimulationOutcome& outcome) {
    JsonWriter json;
    json.openObject();
    json.wholeNumber("steps", outcome.steps);
    json.list("bodies", outcome.bodies, writeBody);
    writeCounts(json, outcome.counts);
    json.wholeNumber("swaps", outcome.breaks.size());
    json.list("breaks", outcome.breaks, writeBreak);
    json.list("splits", outcome.splits, writeSplit);
    json.number("largestPenetration", outcome.largestPenetration);
    json.text("hash", outcome.hash.hex());
    if (outcome.stepMilliseconds) writeTimes(json, *outcome.stepMilliseconds);
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
