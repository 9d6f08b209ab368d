#pragma once

#include "core/geometry/polygon/PolygonFaults.h"
#include "editor/canvas/tools/CanvasTool.h"
#include "editor/canvas/tools/OutlineDraft.h"
#include "editor/canvas/tools/Snapping.h"

#include <optional>

namespace rubble {

/// Moves, adds and deletes points of the active asset's outline and holes, and draws new outlines and holes.
///
/// The document only contains valid outlines. An invalid one is shown with its faults while it is dragged or drawn; on
/// release, the last valid one is restored.
class OutlineTool : public CanvasTool {
    Q_OBJECT
public:
    /// What is being drawn.
    enum class Drawing {
        Outline,  // replaces the asset's outline and removes its holes
        Hole,
        NewAsset,
    };

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
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    /// Starts drawing: each click adds a point; Enter, a double click or a click on the first point closes the ring,
    /// Esc cancels. Outlines and holes need an active asset.
    void beginDrawing(Drawing drawing);
    bool isDrawing() const { return m_draft.has_value(); }
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
    void closeDraft();
    bool draftKey(int key);
    void insertPoint(RingPoint edge, Vec2 position);
    void nudge(Vec2 by, bool isRepeated);
    void selectNext(int by);
    void paintHandles(QPainter& painter, const CanvasColours& colours) const;

    std::optional<Drag> m_drag;
    std::optional<OutlineDraft> m_draft;
    Drawing m_drawing = Drawing::Outline;
    std::optional<Faulty> m_faulty;  // while dragging
    std::optional<Handle> m_hovered;
    std::optional<RingPoint> m_selected;
};

}  // namespace rubble
