#pragma once

#include "editor/play/PlayEvent.h"

#include <QRectF>

#include <span>

class QPainter;

namespace rubble {

/// The events of one column of pixels of a timeline.
struct TimelineMark {
    int column = 0;                                   // from the left of the track
    std::array<std::uint32_t, kEventKinds> counts{};  // by kind
    bool has(EventKind kind) const { return counts[static_cast<std::size_t>(kind)] > 0; }
    bool operator==(const TimelineMark&) const = default;
};

/// The events of the steps from `first` to `last`.
std::span<const EventRef> eventsBetween(std::span<const EventRef> events, double first, double last);

/// The marks of events, by ascending step, on a track that shows the steps from `first` to `last` in `width` pixels: at
/// most one per pixel, however many events there are. A column is nearest to its events.
std::vector<TimelineMark> timelineMarks(std::span<const EventRef> events, double first, double last, double width);

/// The height of the lane above the track in which events other than breaks are marked, in points.
inline constexpr double kMarkLane = 10.0;

/// Paints marks: breaks as lines across the lane and the track, other kinds with shapes and heights of their own in the
/// lane.
void paintMarks(QPainter& painter, std::span<const TimelineMark> marks, const QRectF& track);

}  // namespace rubble
