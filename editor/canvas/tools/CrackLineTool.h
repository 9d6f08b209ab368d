#pragma once

#include "core/fracture/kinds/CrackLines.h"
#include "editor/canvas/tools/CanvasTool.h"

#include <optional>

namespace rubble {

/// Draws crack lines, freehand while the button is held or from click to click, and moves and deletes their points.
///
/// A crack line is added to the last enabled layer of crack lines, or to a new one, as one undo step when it is
/// finished.
class CrackLineTool : public CanvasTool {
    Q_OBJECT
public:
    using CanvasTool::CanvasTool;

    void press(const CanvasPointer& pointer) override;
    void move(const CanvasPointer& pointer) override;
    void release(const CanvasPointer& pointer) override;
    void doubleClick(const CanvasPointer& pointer) override;
    bool key(const QKeyEvent& event) override;
    bool cancel() override;
    void endDrag() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override;
    QString hint() const override;
    bool isPrompting() const override { return !m_draft.empty(); }
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    bool isDrawing() const { return !m_draft.empty() || !m_path.empty(); }
    /// Deletes the crack line as a whole if fewer than two points would be left.
    void deleteSelectedPoint();
    void deleteSelectedLine();

private:
    /// A point of a crack line.
    struct LinePoint {
        Id layer = 0;
        std::uint32_t line = 0;  // its index
        std::size_t point = 0;
        bool operator==(const LinePoint&) const = default;
    };
    struct Drag {
        Asset before;
        LinePoint point;
        quint64 mergeKey = 0;
    };

    std::optional<LinePoint> pointAt(const CanvasPointer& pointer) const;
    Vec2 snappedPoint(const CanvasPointer& pointer) const;
    void addToDraft(Vec2 point);
    void endDraft();
    void endPath();
    void add(std::vector<Vec2> points);
    void dragTo(Vec2 position);

    std::vector<Vec2> m_draft;  // clicked points
    std::vector<Vec2> m_path;   // freehand points
    std::optional<Drag> m_drag;
    std::optional<LinePoint> m_hovered;
    std::optional<LinePoint> m_selected;
    QPointF m_pressed;
    bool m_hasMoved = false;
    Vec2 m_pointer{0.0, 0.0};
};

}  // namespace rubble
