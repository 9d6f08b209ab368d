#pragma once

#include "editor/commands/BondPainter.h"
#include "viewport/widget/ViewportTool.h"

#include <memory>
#include <optional>
#include <vector>

namespace rubble {

class ViewportWidget;
class Workspace;
struct Bake;
struct SurfaceHit;

/// Paints with the BondPainter on the surfaces of the active asset's instances in the 3D view, if the asset breaks as
/// bonded. A stroke is in the prism's plane, wherever on the solid it is painted; it is finished when the button is
/// released.
class BondPaintTool : public ViewportTool {
    Q_OBJECT
public:
    BondPaintTool(Workspace& workspace, ViewportWidget& viewport);

    bool press(const QMouseEvent& event) override;
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    bool wheel(const QWheelEvent& event) override;
    bool keyPress(const QKeyEvent& event) override;
    bool overridesShortcut(const QKeyEvent& event) const override;
    bool cancel() override;
    void leave() override;
    void paint(QPainter& painter, QSize size) const override;

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
    bool isPainting() const { return !m_drawn.empty(); }
    void refresh();
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
    BondPainter& m_painter;            // lengths on screen in points
    std::optional<QPointF> m_pointer;  // over the active asset
    std::vector<QPointF> m_drawn;      // the stroke on screen, if it is painted here
    mutable Marks m_marks;             // a cache
};

}  // namespace rubble
