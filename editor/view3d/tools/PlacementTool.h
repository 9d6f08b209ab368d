#pragma once

#include "core/asset/placement/InstancePlacement.h"
#include "editor/widgets/numbers/Units.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportTool.h"

#include <array>
#include <optional>
#include <vector>

namespace rubble {

class ViewportWidget;

/// Places assets in the 3D view: dragged from the project tree, or by clicks after begin(). An instance lands upright
/// on the face under the pointer or on the ground, with Ctrl on a grid of 0.1 m. Its outline is previewed meanwhile.
class PlacementTool : public ViewportTool {
    Q_OBJECT
public:
    PlacementTool(Workspace& workspace, ViewportWidget& viewport);

    void setOn(bool isOn);
    void setUnits(const Units& units) { m_units = units; }
    /// Starts placing an asset: an instance follows the pointer, each click places one, R rotates it by 15° about the
    /// vertical, with Shift the other way. Esc and the right button end it.
    void begin(Id asset);
    void end();
    bool isPlacing() const { return m_isPlacing; }
    /// The edges of the previewed instance; empty if there is none.
    const std::vector<std::array<Vec3, 2>>& preview() const { return m_preview; }

    bool press(const QMouseEvent& event) override;
    bool doubleClick(const QMouseEvent& event) override { return release(event); }
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    bool keyPress(const QKeyEvent& event) override;
    bool keyRelease(const QKeyEvent& event) override;
    bool overridesShortcut(const QKeyEvent& event) const override;
    bool suppressesContextMenu() override;
    bool drag(QDropEvent& event) override;
    void dragLeave() override { showPreview(std::nullopt); }
    void leave() override;
    bool cancel() override;
    void paint(QPainter& painter, QSize size) const override;

private:
    std::optional<Pose> poseAt(QPointF point, Qt::KeyboardModifiers modifiers) const;
    void showPreview(const std::optional<Pose>& pose);
    void place(const std::optional<Pose>& pose);
    bool isNavigating(const QMouseEvent& event) const;
    void emitHint();
    void followPointer(Qt::KeyboardModifiers modifiers);

    Workspace& m_workspace;
    ViewportWidget& m_viewport;
    bool m_isOn = true;
    bool m_isPlacing = false;
    bool m_isMenuDue = false;  // of the right click that ended it
    Id m_asset = 0;            // being dragged or placed
    int m_rotationSteps = 0;   // of TransformTool::kStepDegrees
    QPointF m_pointer;
    AssetHulls m_hulls;
    std::vector<std::array<Vec3, 2>> m_preview;
    Units m_units;
};

}  // namespace rubble
