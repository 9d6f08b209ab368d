#pragma once

#include "core/geometry/Vec.h"

#include <QObject>
#include <QPointF>

#include <optional>

namespace rubble {

class MeasureOverlay;
class ViewportWidget;

/// Measures in the 3D view from one point of what is shown to another, by two clicks. Corners draw the pointer to them. What
/// is seen is measured: pieces that are moved apart are as far from each other as they are drawn.
class ViewMeasure : public QObject {
    Q_OBJECT
public:
    explicit ViewMeasure(ViewportWidget& viewport);

    bool isOn() const { return m_isOn; }
    /// Off, it forgets what was measured.
    void setOn(bool isOn);

    /// A point on a surface.
    struct Point {
        Vec3 place{0.0, 0.0, 0.0};  // m
        bool isCorner = false;
    };
    const std::optional<Point>& from() const { return m_from; }
    const std::optional<Point>& to() const { return m_to; }
    /// What lies under the pointer.
    const std::optional<Point>& pointed() const { return m_pointed; }
    /// m; none where there are not two points.
    std::optional<double> distance() const;

signals:
    void changed();
    void onChanged(bool isOn);
    void hintChanged(const QString& hint);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::optional<Point> pointAt(QPointF pixel) const;
    void point(QPointF pixel);
    void take();
    void cancel();
    void tellHint();

    ViewportWidget& m_viewport;
    MeasureOverlay* m_overlay;
    bool m_isOn = false;
    std::optional<Point> m_from;
    std::optional<Point> m_to;
    std::optional<Point> m_pointed;
    QPointF m_pointer;
};

}  // namespace rubble
