#pragma once

#include "editor/canvas/tools/CanvasTool.h"

#include <optional>

namespace rubble {

/// Measures the distance, its x and y components, and the angle between two points.
class MeasureTool : public CanvasTool {
    Q_OBJECT
public:
    using CanvasTool::CanvasTool;

    void press(const CanvasPointer& pointer) override;
    void move(const CanvasPointer& pointer) override;
    void release(const CanvasPointer& pointer) override;
    bool cancel() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    QString hint() const override;
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    /// The measured line, m.
    struct Line {
        Vec2 from{0.0, 0.0};
        Vec2 to{0.0, 0.0};
    };
    const std::optional<Line>& line() const { return m_line; }

private:
    Vec2 pointOf(const CanvasPointer& pointer) const;

    std::optional<Line> m_line;
    bool m_isHeld = false;
};

}  // namespace rubble
