#include "core/io/play/EventsFile.h"

#include "core/io/json/JsonWriter.h"
#include "core/io/text/LetterCase.h"

#include <algorithm>

namespace rubble {
namespace {

bool hasEnergy(EventKind kind) {
    return kind == EventKind::Impact || kind == EventKind::Bonds || kind == EventKind::Broken;
}

template <class Writer>
void writeVector(Writer& writer, std::string_view key, Vec3 vector) {
    writer.numbers(key, {vector.x, vector.y, vector.z});
}

template <class Writer>
void writeRecord(Writer& writer, const EventRecord& record) {
    writer.openObject();
    writer.wholeNumber("step", record.step);
    writer.text("kind", nameOf(record.kind));
    writer.wholeNumber("body", std::uint64_t{record.body});
    if (record.other != kNone) writer.wholeNumber("other", std::uint64_t{record.other});
    writer.wholeNumber("instance", std::uint64_t{record.instance});
    writer.text("fragment", record.fragment);
    writeVector(writer, "point", record.point);
    if (hasEnergy(record.kind)) {
        writeVector(writer, "normal", record.normal);
        writer.number("impulse", record.impulse);
        writer.number("speed", record.speed);
        writer.number("energy", record.energy);
    }
    if (record.area > 0.0) writer.number("area", record.area);
    if (record.mass > 0.0) writer.number("mass", record.mass);
    if (record.count > 0) writer.wholeNumber("count", std::uint64_t{record.count});
    writer.wholeNumbers("materials", record.materials);
    writer.openArray("box");
    writeVector(writer, {}, record.box.min);
    writeVector(writer, {}, record.box.max);
    writer.close();
    if (record.reason != RemovalReason::None) writer.text("reason", nameOf(record.reason));
    writer.close();
}

template <class Writer>
void writeSums(Writer& writer, std::uint64_t step, const EventReport& report) {
    writer.openObject();
    writer.wholeNumber("step", step);
    writer.text("kind", "sums");
    writer.openObject("omitted");
    for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
        const OmittedEvents& omitted = report.omitted[kind];
        if (omitted.count == 0) continue;
        writer.openObject(nameOf(static_cast<EventKind>(kind)));
        writer.wholeNumber("count", std::uint64_t{omitted.count});
        writer.number("energy", omitted.energy);
        writer.close();
    }
    writer.close();
    writer.number("restEnergy", report.restEnergy);
    writer.close();
}

bool hasSums(const EventReport& report) {
    return report.restEnergy != 0.0 ||
           std::ranges::any_of(report.omitted, [](const OmittedEvents& one) { return one.count > 0; });
}

/// The columns in the order in which the members above are written.
std::vector<std::string> eventColumns() {
    std::vector<std::string> columns{"step",         "kind",         "body",      "other",     "instance",  "fragment",
                                     "point[0]",     "point[1]",     "point[2]",  "normal[0]", "normal[1]", "normal[2]",
                                     "impulse",      "speed",        "energy",    "area",      "mass",      "count",
                                     "materials[0]", "materials[1]", "box[0][0]", "box[0][1]", "box[0][2]", "box[1][0]",
                                     "box[1][1]",    "box[1][2]",    "reason"};
    for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
        const std::string omitted = "omitted." + std::string(nameOf(static_cast<EventKind>(kind)));
        columns.push_back(omitted + ".count");
        columns.push_back(omitted + ".energy");
    }
    columns.push_back("restEnergy");
    return columns;
}

const std::vector<std::string>& sharedColumns() {
    static const std::vector<std::string> kColumns = eventColumns();
    return kColumns;
}

std::variant<std::string, CsvTable> emptyText(EventsFormat format) {
    if (format == EventsFormat::Csv) return CsvTable(sharedColumns());
    return std::string();
}

/// Appends an object that write(writer) writes.
template <class Write>
void append(std::variant<std::string, CsvTable>& text, const Write& write) {
    if (auto* const table = std::get_if<CsvTable>(&text)) return write(*table);
    JsonWriter json(JsonLayout::Compact);
    write(json);
    std::get<std::string>(text) += std::move(json).finished();
}

}  // namespace

EventsFormat eventsFormatOf(const std::filesystem::path& path) {
    return lowerCase(path.extension().string()) == ".csv" ? EventsFormat::Csv : EventsFormat::Stream;
}

EventsText::EventsText(EventsFormat format) : m_text(emptyText(format)) {}

void EventsText::add(std::uint64_t step, const EventReport& report) {
    for (const EventRecord& record : report.records) {
        append(m_text, [&](auto& writer) { writeRecord(writer, record); });
    }
    if (hasSums(report)) append(m_text, [&](auto& writer) { writeSums(writer, step, report); });
}

std::string EventsText::finished() && {
    if (auto* const table = std::get_if<CsvTable>(&m_text)) return std::move(*table).finished();
    return std::get<std::string>(std::move(m_text));
}

}  // namespace rubble
