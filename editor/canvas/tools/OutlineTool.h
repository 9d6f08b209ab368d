#pragma once

#include "core/geometry/polygon/PolygonFaults.h"
#include "editor/canvas/tools/CanvasTool.h"
#include "editor/canvas/tools/ShapeDrawing.h"
#include "editor/canvas/tools/Snapping.h"

#include <optional>

namespace rubble {

/// Moves, adds and deletes points of the active asset's outline and holes, and draws shapes: new outlines, and those
/// that are added to the outline or cut from it.
///
/// The document only contains valid outlines. An invalid one is shown with its faults while it is dragged or drawn; on
/// release, the last valid one is restored.
class OutlineTool : public CanvasTool {
    Q_OBJECT
public:
    explicit OutlineTool(const CanvasState& state);

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
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    /// See ShapeDrawing::begin().
    void beginDrawing(ShapeDrawing::Purpose purpose, DraftShape shape = DraftShape::Polygon);
    bool isDrawing() const { return m_drawing.isActive(); }
    bool isPrompting() const override { return m_drawing.isPrompting(); }
    /// Deletes a hole as a whole if fewer than three points would be left.
    void deleteSelectedPoint();
    void deleteHole(int ring);

private:
    /// A point, or an edge by its first point.
    struct Handle {
        RingPoint at;
        bool isEdge = false;
        bool operator==(const Handle&) const = default;
    };
    struct Drag {
        Asset before;
        Handle handle;
        CanvasPointer from;
        quint64 mergeKey = 0;
    };
    struct Faulty {
        Polygon outline;
        std::vector<PolygonFault> faults;
    };

    /// The asset whose outline can be edited; null if there is none.
    const Asset* editableAsset() const;
    std::optional<Handle> handleAt(const CanvasPointer& pointer) const;
    Polygon dragged(const CanvasPointer& pointer) const;
    /// Pushes the outline if it is valid; otherwise emits the reason and returns false.
    bool pushOutline(const QString& text, Polygon outline, quint64 mergeKey = 0);
    void insertPoint(RingPoint edge, Vec2 position);
    void nudge(Vec2 by, bool isRepeated);
    void selectNext(int by);
    void addDrawings(QMenu& menu, ShapeDrawing::Purpose purpose);
    void paintHandles(QPainter& painter, const CanvasColours& colours) const;

    std::optional<Drag> m_drag;
    ShapeDrawing m_drawing;
    std::optional<Faulty> m_faulty;  // while dragging
    std::optional<Handle> m_hovered;
    std::optional<RingPoint> m_selected;
};

}  // namespace rubble
