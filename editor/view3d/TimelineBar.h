#pragma once

#include "editor/play/PlayEvent.h"
#include "editor/view3d/TimelineSpan.h"

#include <QWidget>

#include <cstdint>
#include <optional>
#include <span>

namespace rubble {

class PlayController;

/// The timeline of a session: dragging seeks, the wheel zooms, events, the loop and forks of branches are marked. Arrow
/// keys move by a step, with Shift by a second; Page Up and Page Down to the previous and next event; Home and End go
/// to the ends.
class TimelineBar : public QWidget {
    Q_OBJECT
public:
    explicit TimelineBar(PlayController& controller, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

    const TimelineSpan& span() const { return m_span; }
    /// Zooms about the displayed time, or the middle if that is not visible.
    void zoomIn();
    void zoomOut();
    /// Shows the whole timeline.
    void fit();
    /// Where a step is, in pixels from the left.
    double positionOf(double step) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

private:
    void refreshFrame();
    void zoom(double step, double factor);
    int labelWidth() const;
    bool hasLengthLabel() const;
    QRectF track() const;
    double stepAt(double x) const;
    std::span<const EventRef> eventsAt(double x) const;
    std::optional<std::uint64_t> breakAt(double x) const;
    QStringList eventLines(double x) const;
    void seekTo(double x);
    void paintTrack(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintTicks(QPainter& painter) const;

    PlayController& m_controller;
    TimelineSpan m_span;
    std::uint64_t m_step = 0;   // that is displayed
    double m_pannedFrom = 0.0;  // pixels, while the middle button is held
};

}  // namespace rubble
