#include "editor/view3d/TimelineMarks.h"

#include "editor/widgets/appearance/EventAppearance.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kBelow = 3.0;  // points that breaks reach below the track

/// The shape of a kind's mark around x. Kinds have heights of their own, so that marks of one step are all visible.
void paintMark(QPainter& painter, EventKind kind, double x, const QRectF& track) {
    const double top = track.top() - kMarkLane;
    switch (kind) {
        case EventKind::Broken: return painter.drawRect(QRectF(x - 1.0, top, 2.0, track.bottom() + kBelow - top));
        case EventKind::Bonds: return painter.drawRect(QRectF(x - 1.0, track.top(), 2.0, track.height()));
        case EventKind::Detached:
            return painter.drawPolygon(QPolygonF(
                {QPointF(x - 3.0, track.bottom()), QPointF(x + 3.0, track.bottom()), QPointF(x, track.top())}));
        case EventKind::Removed:
            return painter.drawPolygon(QPolygonF(
                {QPointF(x, top), QPointF(x + 2.0, top + 2.0), QPointF(x, top + 4.0), QPointF(x - 2.0, top + 2.0)}));
        case EventKind::Impact: return painter.drawRect(QRectF(x - 0.75, top + 4.0, 1.5, 3.5));
        case EventKind::Settled: return painter.drawRect(QRectF(x - 2.0, top + 8.0, 4.0, 1.5));
    }
}

}  // namespace

std::span<const EventRef> eventsBetween(std::span<const EventRef> events, double first, double last) {
    return {std::ranges::lower_bound(events, first, {}, stepOfEvent),
            std::ranges::upper_bound(events, last, {}, stepOfEvent)};
}

std::vector<TimelineMark> timelineMarks(std::span<const EventRef> events, double first, double last, double width) {
    std::vector<TimelineMark> marks;
    const double scale = width / std::max(1.0, last - first);
    for (const EventRef& event : eventsBetween(events, first, last)) {
        const int column = static_cast<int>(std::lround(scale * (static_cast<double>(event->record.step) - first)));
        if (marks.empty() || marks.back().column != column) marks.push_back({.column = column});
        ++marks.back().counts[static_cast<std::size_t>(event->record.kind)];
    }
    return marks;
}

void paintMarks(QPainter& painter, std::span<const TimelineMark> marks, const QRectF& track) {
    painter.setPen(Qt::NoPen);
    for (const EventKind kind : {EventKind::Settled, EventKind::Removed, EventKind::Impact, EventKind::Detached,
                                 EventKind::Bonds, EventKind::Broken}) {
        painter.setBrush(colourOf(kind));
        for (const TimelineMark& mark : marks) {
            if (mark.has(kind)) paintMark(painter, kind, track.left() + mark.column, track);
        }
    }
}

}  // namespace rubble
