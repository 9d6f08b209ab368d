#pragma once

#include <QWidget>

namespace rubble {

class PlayController;

/// The way that a play went so far: drag along it to go back and forth, breaks marked. Arrow keys go a step, with Shift a
/// second; Home and End to the ends.
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
    double placeOf(std::uint64_t step) const;
    std::uint64_t stepAt(double place) const;
    void seekTo(double place);

    PlayController& m_controller;
};

}  // namespace rubble
