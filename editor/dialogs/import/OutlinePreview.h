#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <QWidget>

namespace rubble {

/// A preview of an outline with points, scaled to fit.
class OutlinePreview : public QWidget {
    Q_OBJECT
public:
    explicit OutlinePreview(QWidget* parent = nullptr);
    void setOutline(const Polygon& outline, std::vector<Vec2> points = {});
    QSize sizeHint() const override { return {220, 220}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Polygon m_outline;
    std::vector<Vec2> m_points;
};

}  // namespace rubble
