#include "core/io/play/EventsJson.h"

#include "core/io/json/JsonWriter.h"
#include "core/io/json/VectorJson.h"

namespace rubble {
namespace {

bool hasEnergy(EventKind kind) { return kind != EventKind::Settled && kind != EventKind::Removed; }

std::string recordLine(const EventRecord& record) {
    JsonWriter json(JsonLayout::Compact);
    json.openObject();
    json.wholeNumber("step", record.step);
    json.text("kind", nameOf(record.kind));
    json.wholeNumber("body", std::uint64_t{record.body});
    if (record.other != kNone) json.wholeNumber("other", std::uint64_t{record.other});
    json.wholeNumber("instance", std::uint64_t{record.instance});
    json.text("fragment", record.fragment);
    writeVector(json, "point", record.point);
    if (hasEnergy(record.kind)) {
        writeVector(json, "normal", record.normal);
        json.number("impulse", record.impulse);
        json.number("speed", record.speed);
        json.number("energy", record.energy);
    }
    if (record.area > 0.0) json.number("area", record.area);
    if (record.mass > 0.0) json.number("mass", record.mass);
    if (record.count > 0) json.wholeNumber("count", std::uint64_t{record.count});
    json.wholeNumbers("materials", record.materials);
    json.openArray("box");
    writeVector(json, {}, record.box.min);
    writeVector(json, {}, record.box.max);
    json.close();
    if (record.reason != RemovalReason::None) json.text("reason", nameOf(record.reason));
    json.close();
    return std::move(json).finished();
}

std::string sumsLine(std::uint64_t step, const EventReport& report) {
    JsonWriter json(JsonLayout::Compact);
    json.openObject();
    json.wholeNumber("step", step);
    json.text("kind", "sums");
    json.openObject("omitted");
    for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
        const OmittedEvents& omitted = report.omitted[kind];
        if (omitted.count == 0) continue;
        json.openObject(nameOf(static_cast<EventKind>(kind)));
        json.wholeNumber("count", std::uint64_t{omitted.count});
        json.number("energy", omitted.energy);
        json.close();
    }
    json.close();
    json.number("restEnergy", report.restEnergy);
    json.close();
    return std::move(json).finished();
}

}  // namespace

std::string eventLines(std::uint64_t step, const EventReport& report) {
    std::string lines;
    for (const EventRecord& record : report.records) lines += recordLine(record);
    const bool hasOmitted = std::ranges::any_of(report.omitted, [](const OmittedEvents& one) { return one.count > 0; });
    if (hasOmitted || report.restEnergy != 0.0) lines += sumsLine(step, report);
    return lines;
}

}  // namespace rubble
