#pragma once

#include "editor/canvas/tools/BoxLassoSelection.h"
#include "editor/canvas/tools/CanvasTool.h"
#include "editor/canvas/tools/ParameterHandles.h"

#include <map>
#include <optional>

namespace rubble {

/// Selects fragments, drags, deletes and places seeds, and drags the handles of layer parameters.
///
/// While it places seeds, and with Alt, a click or a box selects seeds, each with all fragments that come from it;
/// otherwise it selects fragments, of which a cell can have several.
class SeedTool : public CanvasTool {
    Q_OBJECT
public:
    explicit SeedTool(const CanvasState& state) : CanvasTool(state), m_handles(state) {}

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

    /// Whether a click places a seed; otherwise it selects the fragment under the pointer.
    void setPlacing(bool isPlacing) { m_isPlacing = isPlacing; }
    void deleteSelected();
    /// Returns the selected seeds that were moved by hand to where they were scattered.
    void restoreSelected();
    void selectAll();
    void selectNeighbours();
    void invertSelection();

private:
    /// A drag of the selected seeds.
    struct Drag {
        Asset before;
        std::map<SeedId, Vec2> from;  // m
        Vec2 grabbed;                 // position of the seed under the pointer, m
        Vec2 by{0.0, 0.0};
        quint64 mergeKey = 0;
    };
    /// A box or lasso selection; with `isAdding` it extends the selection.
    struct AreaDrag {
        BoxLassoSelection area;
        bool isAdding = false;
    };

    std::uint32_t seedAt(const CanvasPointer& pointer) const;
    std::uint32_t pieceAt(const CanvasPointer& pointer) const;
    bool isDragOfSeed() const { return m_drag || m_pressedSeed; }
    std::map<SeedId, Vec2> selectedPositions() const;
    void beginDrag(std::uint32_t seed);
    void dragBy(Vec2 by);
    void click(const CanvasPointer& pointer);
    void selectAt(const CanvasPointer& pointer);
    void selectSeedAt(const CanvasPointer& pointer);
    void selectArea();
    QString selectionHint() const;
    Selection::Seeds selectedSeeds() const;
    void place(Vec2 position);
    void nudge(Vec2 by, bool isRepeated);
    void selectNext(int by);
    Selection::Seeds seedsInArea() const;
    std::vector<std::uint32_t> piecesInArea() const;

    ParameterHandles m_handles;
    std::optional<Drag> m_drag;
    std::optional<AreaDrag> m_area;
    QPointF m_pressed;
    std::optional<SeedId> m_pressedSeed;  // that a drag will move
    bool m_hasMoved = false;
    bool m_isPlacing = false;
    CanvasPointer m_pointer{};
    std::uint32_t m_hovered = kNone;  // seed
};

}  // namespace rubble
