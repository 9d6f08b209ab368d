#pragma once

#include "editor/canvas/tools/CanvasTool.h"
#include "editor/commands/BondStrokes.h"
#include "editor/widgets/input/BrushSize.h"

#include <optional>

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

    const BondBrushSettings& settings() const { return m_settings; }
    void setSettings(const BondBrushSettings& settings);
    void setBrush(BondBrush brush);
    double radiusPixels() const { return m_size.radiusPixels(); }
    void setRadiusPixels(double radius);
    /// The factor of the strength brush, 0 to 10.
    double strength() const { return m_settings.strength; }
    void setStrength(double strength);

signals:
    void settingsChanged();

private:
    bool canPaint() const;
    bool erases(Qt::KeyboardModifiers modifiers) const;
    QColor colour(const CanvasColours& colours) const;
    QString actionHint() const;
    void stepSize(double steps);
    void setErasing(bool isErasing);
    void extend(const CanvasPointer& pointer);
    void addStrengths(QMenu& menu);

    BrushSize m_size;
    BondBrushSettings m_settings;
    std::optional<BondStrokePath> m_path;  // of the stroke that is being painted
    std::optional<CanvasPointer> m_pointer;
};

}  // namespace rubble
