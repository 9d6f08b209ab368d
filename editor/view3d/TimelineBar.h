#pragma once

#include <QWidget>

namespace rubble {

class PlayController;

/// The timeline of a session: dragging seeks, breaks are marked. Arrow keys move by a step, with Shift by a second;
/// Home and End go to the ends.
class TimelineBar : public QWidget {
    Q_OBJECT
public:
    explicit TimelineBar(PlayController& controller, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF track() const;
    double positionOf(std::uint64_t step) const;
    std::uint64_t stepAt(double x) const;
    void seekTo(double x);

    PlayController& m_controller;
};

}  // namespace rubble
