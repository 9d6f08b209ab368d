#pragma once

#include "editor/document/FragmentSelection.h"
#include "editor/workspace/Workspace.h"
#include "viewport/scene/RenderScene.h"

#include <QPoint>

#include <memory>
#include <optional>
#include <vector>

namespace rubble {

class ViewportWidget;

/// Turns picks in the 3D view into selections of instances and fragments, and selections into marks of the scene.
///
/// The body under a pixel is found by ViewportWidget::pickAt(); points on surfaces by
/// SurfacePicking.h.
class ScenePicker : public QObject {
    Q_OBJECT
public:
    ScenePicker(Workspace& workspace, ViewportWidget& viewport);

    /// Whether the active asset is shown by itself; otherwise all instances are.
    void setAssetOnly(bool isAssetOnly) { m_isAssetOnly = isAssetOnly; }

    /// The selected and hidden bodies.
    SceneMarks marks() const;

    /// Selects the instance at a point, unless it is selected already.
    void selectInstanceAt(QPoint point);
    /// Selects the fragment at a point, unless it is selected already. Only while fragments are edited: in the active
    /// asset by itself, or in the instance whose fragments are selected. False elsewhere.
    bool selectFragmentAt(QPoint point);

private:
    void pick(const std::optional<PickId>& id, Qt::KeyboardModifiers modifiers);
    void pickRectangle(const std::vector<PickId>& ids, Qt::KeyboardModifiers modifiers);
    void selectInstance(Id instance, bool isExtending);
    void selectFragments(const std::vector<PickId>& ids, bool isExtending);
    void deselectAll();
    bool isInSelectedFragments(const std::optional<PickId>& id) const;
    void addIds(const FragmentSelection& selection, std::vector<PickId>& picks) const;
    std::shared_ptr<const Bake> activeBake() const;

    Workspace& m_workspace;
    ViewportWidget& m_viewport;
    bool m_isAssetOnly = false;
};

}  // namespace rubble
