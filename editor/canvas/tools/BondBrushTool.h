#pragma once

#include "editor/canvas/tools/CanvasTool.h"

#include <optional>

namespace rubble {

/// Paints with the BondPainter over the fragments of an asset that breaks as bonded: anchors, the strength of bonds, or
/// what never breaks. A stroke is finished when the button is released.
class BondBrushTool : public CanvasTool {
    Q_OBJECT
public:
    explicit BondBrushTool(const CanvasState& state);

    void press(const CanvasPointer& pointer) override;
    void move(const CanvasPointer& pointer) override;
    void release(const CanvasPointer& pointer) override;
    bool key(const QKeyEvent& event) override;
    bool controlWheel(double notches) override;
    bool overridesShortcut(int key) const override;
    bool cancel() override;
    void endDrag() override { m_painter.cancel(); }
    void leave() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override;
    QString hint() const override;
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

private:
    bool canPaint() const;
    QColor colour(const CanvasColours& colours) const;
    QString actionHint() const;
    Vec2 pointInAsset(const CanvasPointer& pointer) const;
    void addStrengths(QMenu& menu);

    BondPainter& m_painter;
    bool m_isPainting = false;  // the stroke of m_painter
    std::optional<CanvasPointer> m_pointer;
};

}  // namespace rubble
