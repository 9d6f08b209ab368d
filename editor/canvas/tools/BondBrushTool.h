#pragma once

#include "editor/canvas/tools/BrushSize.h"
#include "editor/canvas/tools/CanvasTool.h"

#include <optional>
#include <vector>

namespace rubble {

/// Paints strokes over the fragments of an asset that breaks as bonded: anchors, the strength of bonds, or what never
/// breaks. A stroke is one edit, made when the button is released; until then it is CanvasState::stroke.
class BondBrushTool : public CanvasTool {
    Q_OBJECT
public:
    using CanvasTool::CanvasTool;

    void press(const CanvasPointer& pointer) override;
    void move(const CanvasPointer& pointer) override;
    void release(const CanvasPointer& pointer) override;
    bool key(const QKeyEvent& event) override;
    bool controlWheel(double notches) override;
    bool overridesShortcut(int key) const override;
    bool cancel() override;
    void endDrag() override;
    void leave() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override;
    QString hint() const override;
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    BondBrush brush() const { return m_brush; }
    void setBrush(BondBrush brush);
    double radiusPixels() const { return m_size.radiusPixels(); }
    void setRadiusPixels(double radius);
    /// The factor of the strength brush, 0 to 10.
    double strength() const { return m_strength; }
    void setStrength(double strength);

private:
    bool canPaint() const;
    bool erases(Qt::KeyboardModifiers modifiers) const;
    double radius() const;
    QColor colour(const CanvasColours& colours) const;
    QString actionHint() const;
    void stepSize(double steps);
    void stepStrength(int direction);
    void extend(Vec2 point);
    void addStrengths(QMenu& menu);

    BrushSize m_size;
    BondBrush m_brush = BondBrush::Anchor;
    double m_strength = 2.0;
    bool m_isErasing = false;
    std::vector<Vec2> m_path;  // of the stroke before it is simplified, m, in the asset's plane
    std::optional<CanvasPointer> m_pointer;
};

}  // namespace rubble
