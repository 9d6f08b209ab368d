#pragma once

#include "core/fracture/Strokes.h"
#include "editor/canvas/CanvasTool.h"

#include <optional>

namespace rubble {

/// Draws cracks: freely while the button is held, or from click to click. Moves and deletes their points.
///
/// They go into the asset's last layer of strokes that is on, or a new one. What is drawn comes into the document at its end, as one
/// step.
class StrokeTool : public CanvasTool {
    Q_OBJECT
public:
    using CanvasTool::CanvasTool;

    void press(const CanvasPointer& pointer) override;
    void move(const CanvasPointer& pointer) override;
    void release(const CanvasPointer& pointer) override;
    void doubleClick(const CanvasPointer& pointer) override;
    bool key(const QKeyEvent& event) override;
    bool cancel() override;
    void letGo() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override;
    QString hint() const override;
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    bool isDrawing() const { return !m_draft.empty() || !m_path.empty(); }
    /// A stroke of which less than two points would be left goes as a whole.
    void deleteChosenPoint();
    void deleteChosenStroke();

private:
    /// A point of a stroke.
    struct Place {
        Id layer = 0;
        std::uint32_t stroke = 0;  // its index
        std::size_t point = 0;
        bool operator==(const Place&) const = default;
    };
    struct Drag {
        Asset before;
        Place place;
        quint64 stroke = 0;
    };

    std::optional<Place> placeAt(const CanvasPointer& pointer) const;
    Vec2 snappedPoint(const CanvasPointer& pointer) const;
    void addToDraft(Vec2 point);
    void endDraft();
    void endPath();
    void add(std::vector<Vec2> points);
    void dragTo(Vec2 position);

    std::vector<Vec2> m_draft;  // clicked so far
    std::vector<Vec2> m_path;   // drawn freely so far
    std::optional<Drag> m_drag;
    std::optional<Place> m_hovered;
    std::optional<Place> m_chosen;
    QPointF m_pressed;
    bool m_hasMoved = false;
    Vec2 m_pointer{0.0, 0.0};
};

}  // namespace rubble
