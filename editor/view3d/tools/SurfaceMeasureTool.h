#pragma once

#include "core/geometry/predicates/Vec.h"
#include "editor/widgets/numbers/Units.h"
#include "viewport/widget/ViewportTool.h"

#include <optional>

namespace rubble {

class ViewportWidget;

/// Measures the distance between two points of surfaces in the 3D view, set by two clicks. Points snap to corners. In
/// the exploded view it measures the exploded positions.
class SurfaceMeasureTool : public ViewportTool {
    Q_OBJECT
public:
    explicit SurfaceMeasureTool(ViewportWidget& viewport);

    /// The units of distances.
    void setUnits(const Units& units) { m_units = units; }
    bool isOn() const { return m_isOn; }
    /// Switching it off clears the measurement.
    void setOn(bool isOn);

    /// A point on a surface.
    struct Point {
        Vec3 position{0.0, 0.0, 0.0};  // m
        bool isCorner = false;
    };
    const std::optional<Point>& from() const { return m_from; }
    const std::optional<Point>& to() const { return m_to; }
    /// The point under the pointer.
    const std::optional<Point>& pointed() const { return m_pointed; }
    /// The distance, m; nothing unless both points are set.
    std::optional<double> distance() const;

    bool press(const QMouseEvent& event) override;
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    bool keyPress(const QKeyEvent& event) override;
    bool overridesShortcut(const QKeyEvent& event) const override;
    /// Clears the measurement; without one, switches the tool off.
    bool cancel() override;
    void paint(QPainter& painter, QSize size) const override;
    QString accessibleText() const override;

signals:
    void onChanged(bool isOn);

private:
    std::optional<Point> pointAt(QPointF pixel) const;
    void updatePointed(QPointF pixel);
    void setPoint();
    void emitHint();
    QString lengthText(double metres) const;

    ViewportWidget& m_viewport;
    bool m_isOn = false;
    std::optional<Point> m_from;
    std::optional<Point> m_to;
    std::optional<Point> m_pointed;
    QPointF m_pointer;
    Units m_units;
};

}  // namespace rubble
