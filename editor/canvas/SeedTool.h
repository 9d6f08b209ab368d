#pragma once

#include "editor/canvas/CanvasTool.h"
#include "editor/canvas/PointHandles.h"

#include <QPolygonF>

#include <map>
#include <optional>

namespace rubble {

/// Places, drags, deletes and chooses seeds, and drags the points that layers are about.
class SeedTool : public CanvasTool {
    Q_OBJECT
public:
    explicit SeedTool(CanvasState& state) : CanvasTool(state), m_handles(state) {}

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

    void deleteChosen();
    /// Puts chosen seeds that were moved by hand back to where they were scattered.
    void restoreChosen();
    void chooseAll();
    void chooseNeighbours();
    void invertChoice();

private:
    /// Seeds on their way.
    struct Drag {
        Asset before;
        std::map<SeedId, Vec2> from;  // m
        Vec2 grabbed;                 // where the seed under the hand stood
        Vec2 by{0.0, 0.0};
        quint64 stroke = 0;
    };
    /// A box or a lasso around what is to be chosen.
    struct Catch {
        QPolygonF path;
        bool isLasso = false;
        bool isAdding = false;
    };

    /// What a click did that may turn out to be the first of two.
    struct Placed {
        Asset before;
        Id nextId = 0;
        std::optional<FragmentPath> broken;  // where it was: a fragment that one can go into
        quint64 stroke = 0;
    };

    std::uint32_t seedAt(const CanvasPointer& pointer) const;
    std::map<SeedId, Vec2> chosenPositions() const;
    void beginDrag(std::uint32_t seed);
    void dragBy(Vec2 by);
    void click(const CanvasPointer& pointer);
    /// Whether the pattern has no seeds, and its pieces names all the same.
    bool hasCutsAlone() const;
    Selection::Seeds chosenSeeds() const;
    void place(Vec2 position, quint64 stroke = 0);
    void takeBack(const Placed& placed);
    void nudge(Vec2 by, bool isRepeated);
    void chooseNext(int by);
    Selection::Seeds caught() const;

    PointHandles m_handles;
    std::optional<Drag> m_drag;
    std::optional<Catch> m_catch;
    std::optional<Placed> m_placed;  // by the last click
    QPointF m_pressed;
    bool m_hasMoved = false;
    CanvasPointer m_pointer{};
    std::uint32_t m_hovered = kNone;  // seed
};

}  // namespace rubble
