#pragma once

#include "core/io/text/CsvTable.h"
#include "core/play/state/EventRecord.h"

#include <filesystem>
#include <variant>

namespace rubble {

enum class EventsFormat {
    Stream,     // JSON lines of version 2: EventStreamText
    JsonLines,  // of version 1
    Csv,        // of version 1
};

/// The format of a file of events by its name: Csv if it ends in ".csv", in upper or lower case; else Stream.
EventsFormat eventsFormatOf(const std::filesystem::path& path);

/// The text of a file of events of version 1, which docs/formats/events.md describes: an object or a row for each
/// record, and one of the kind "sums" for each step in which anything is only counted or summed.
class EventsText {
public:
    /// `format`: JsonLines or Csv.
    explicit EventsText(EventsFormat format);

    /// Adds what a step reports; steps ascend.
    void add(std::uint64_t step, const EventReport& report);
    std::string finished() &&;

private:
    std::variant<std::string, CsvTable> m_text;  // JSON lines or CSV
};

}  // namespace rubble
