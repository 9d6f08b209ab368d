#pragma once

#include <QWidget>

namespace rubble {

class ViewMeasure;
class ViewportWidget;

/// What is drawn over the 3D view while something is measured: both points, the line and how long it is. It lets all events
/// through.
class MeasureOverlay : public QWidget {
    Q_OBJECT
public:
    MeasureOverlay(const ViewMeasure& measure, ViewportWidget& viewport);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void paintLine(class QPainter& painter, QPointF from, QPointF to) const;
    void paintPoint(QPainter& painter, QPointF at, bool isCorner) const;
    void paintLabel(QPainter& painter, QPointF beside, const QStringList& lines) const;

    const ViewMeasure& m_measure;
    ViewportWidget& m_viewport;
};

}  // namespace rubble
