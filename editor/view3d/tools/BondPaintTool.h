#pragma once

#include "editor/commands/BondStrokes.h"
#include "editor/widgets/input/BrushSize.h"
#include "viewport/widget/ViewportTool.h"

#include <memory>
#include <optional>
#include <vector>

namespace rubble {

class ViewportWidget;
class Workspace;
struct Bake;
struct SurfaceHit;

/// Paints the bonds of the active asset on the surfaces of its instances in the 3D view, if it breaks as bonded. A
/// stroke is in the prism's plane, wherever on the solid it is painted; it is one edit, made when the button is
/// released.
class BondPaintTool : public ViewportTool {
    Q_OBJECT
public:
    BondPaintTool(Workspace& workspace, ViewportWidget& viewport);

    bool isOn() const { return m_isOn; }
    void setOn(bool isOn);
    const BondBrushSettings& settings() const { return m_settings; }
    void setSettings(const BondBrushSettings& settings);
    double radiusPixels() const { return m_size.radiusPixels(); }

    bool press(const QMouseEvent& event) override;
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    bool wheel(const QWheelEvent& event) override;
    bool keyPress(const QKeyEvent& event) override;
    bool overridesShortcut(const QKeyEvent& event) const override;
    bool cancel() override;
    void leave() override;
    void paint(QPainter& painter, QSize size) const override;

signals:
    void settingsChanged();
    /// The stroke that is being painted; null: none.
    void strokeChanged(const rubble::BondStroke* stroke);

private:
    /// A point of the active asset under the pointer.
    struct Place {
        Vec2 point;             // m, in the prism's plane
        double metresPerPixel;  // there
    };
    /// The active asset while it can be painted; else null.
    const Asset* asset() const;
    std::optional<SurfaceHit> hitAt(QPointF pixel) const;
    std::optional<Place> placeAt(QPointF pixel) const;
    bool erases(Qt::KeyboardModifiers modifiers) const;
    void paintTo(QPointF pixel);
    void end();
    void stepSize(double steps);
    const std::vector<bool>& markedFragments(const std::shared_ptr<const Bake>& bake) const;
    void paintMarks(QPainter& painter) const;

    struct Marks {
        std::shared_ptr<const Bake> bake;
        BondBrush brush = BondBrush::Anchor;
        Bonding bonding;
        std::vector<bool> isMarked;  // of each fragment of the bake
    };

    Workspace& m_workspace;
    ViewportWidget& m_viewport;
    bool m_isOn = false;
    BondBrushSettings m_settings;
    BrushSize m_size;                  // lengths on screen in points
    std::optional<QPointF> m_pointer;  // over the active asset
    bool m_isPressed = false;
    bool m_isErasing = false;              // the stroke that is being painted
    std::optional<BondStrokePath> m_path;  // of it, from the first point of the asset on
    std::vector<QPointF> m_drawn;          // the same on screen
    mutable Marks m_marks;                 // a cache
};

}  // namespace rubble
