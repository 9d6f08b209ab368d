#pragma once

#include "core/geometry/PolygonFaults.h"
#include "editor/canvas/CanvasTool.h"
#include "editor/canvas/OutlineDraft.h"
#include "editor/canvas/Snapping.h"

#include <optional>

namespace rubble {

/// Moves, adds and deletes points of the outline at hand and of its holes, and draws new ones point by point.
///
/// The document only ever holds outlines that can be cut. One that cannot is shown while it is dragged or drawn, with its
/// faults where they are; let go, the last good one is there again.
class OutlineTool : public CanvasTool {
    Q_OBJECT
public:
    /// What is drawn point by point.
    enum class Drawing {
        Outline,  // in place of the one at hand, which loses its holes
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
    void letGo() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override;
    QString hint() const override;
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    /// The next clicks draw; Enter, a double click or a click on the first point closes, Esc gives up. Outlines and holes
    /// need an asset at hand.
    void beginDrawing(Drawing drawing);
    bool isDrawing() const { return m_draft.has_value(); }
    /// A hole of which less than three points would be left goes as a whole.
    void deleteChosenPoint();
    void deleteHole(int ring);

private:
    /// A point, or an edge by its first point.
    struct Place {
        RingPoint at;
        bool isEdge = false;
        bool operator==(const Place&) const = default;
    };
    struct Drag {
        Asset before;
        Place place;
        CanvasPointer from;
        quint64 stroke = 0;
    };
    struct Faulty {
        Polygon outline;
        std::vector<PolygonFault> faults;
    };

    /// Whose outline can be changed; null where there is none.
    const Asset* drawn() const;
    std::optional<Place> placeAt(const CanvasPointer& pointer) const;
    Polygon dragged(const CanvasPointer& pointer) const;
    /// Pushes an outline that can be cut; says why where it cannot.
    bool offer(const QString& text, Polygon outline, quint64 stroke = 0);
    void closeDraft();
    bool draftKey(int key);
    void insertPoint(RingPoint edge, Vec2 position);
    void nudge(Vec2 by, bool isRepeated);
    void chooseNext(int by);
    void paintPlaces(QPainter& painter, const CanvasColours& colours) const;

    std::optional<Drag> m_drag;
    std::optional<OutlineDraft> m_draft;
    Drawing m_drawing = Drawing::Outline;
    std::optional<Faulty> m_faulty;  // while it is dragged
    std::optional<Place> m_hovered;
    std::optional<RingPoint> m_chosen;
};

}  // namespace rubble
