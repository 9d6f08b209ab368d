#pragma once

#include "editor/workspace/Preferences.h"
#include "editor/workspace/Workspace.h"
#include "viewport/scene/SceneBuilder.h"

#include <QTimer>
#include <QWidget>

#include <functional>

class QComboBox;

namespace rubble {

class ActionKeys;
class BondPaintTool;
class LightMenu;
class TransformTool;
class PlacementTool;
class PlayView;
class SceneLegend;
class ScenePicker;
class SkyFile;
class SurfaceMeasureTool;
class TimelinePanel;
class ViewportWidget;

/// The 3D view of a workspace with its toolbar, tools, overlay and timeline: shows the scene of the current bakes, or
/// the session in play.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(Workspace& workspace, QWidget* parent = nullptr);

    ViewportWidget& viewport() { return *m_viewport; }
    TransformTool& transformTool() { return *m_transformTool; }
    PlacementTool& placementTool() { return *m_placementTool; }
    BondPaintTool& bondPaintTool() { return *m_bondPaintTool; }
    SurfaceMeasureTool& measureTool() { return *m_measureTool; }
    ScenePicker& picker() { return *m_picker; }
    void frameAll();
    void showWholeScene();
    /// Frames the selected instances, in the whole scene.
    void frameSelected();
    /// Frames instances with some margin.
    void frameInstances(std::span<const Id> instances);
    /// Frames the selected fragments with some margin.
    void frameFragments();
    /// Whether instances can be transformed and placed; only while the whole scene is shown.
    void setEditable(bool isEditable);
    bool isEditable() const { return m_isEditable && !m_isAssetOnly; }
    void applyPreferences(const Preferences& preferences);
    /// Actions whose shortcuts precede those of the window while the 3D view has the focus and no tool takes the key.
    void setPrecedingActions(const QList<QAction*>& actions);
    /// Shows the session while in play.
    PlayView& playView() { return *m_playView; }
    /// Visible while in play.
    TimelinePanel& timeline() { return *m_timeline; }

signals:
    /// The user selected a sky or an exposure.
    void lightSelected(SkyPreset sky, const QString& file, double exposure);
    /// The user wants to select the file of a sky.
    void skyFileRequested();
    /// The scene cannot be shown; the sentence says why.
    void failed(const QString& sentence);

private:
    void addViews();
    void addToggle(const struct ActionDefinition& definition, bool isOn, const std::function<void(bool)>& apply);
    void addToggles();
    void addMeasure();
    void addSeparator();
    QWidget* makeBar();
    QWidget* makeViewMenu();
    /// Schedules an update of the scene; unchanged geometry is reused.
    void invalidate() { m_timer.start(); }
    std::span<const MortarJoint> shownJoints() const;
    void refreshScene();
    void updatePlayState();
    void updateSky();
    void updateTimeline();
    void updateEditing();

    Workspace& m_workspace;
    ViewportWidget* m_viewport;
    TransformTool* m_transformTool;
    PlacementTool* m_placementTool;
    bool m_isEditable = true;
    SceneBuilder m_builder;
    SceneOptions m_options;
    QComboBox* m_scope = nullptr;
    bool m_isAssetOnly = false;
    QTimer m_timer;
    SceneLegend* m_legend;
    PlayView* m_playView;
    SurfaceMeasureTool* m_measureTool;
    BondPaintTool* m_bondPaintTool;
    LightMenu* m_lightMenu;
    SkyFile* m_skyFile;
    QAction* m_measureAction = nullptr;
    ActionKeys* m_precedingKeys;
    ScenePicker* m_picker;
    TimelinePanel* m_timeline;
    QList<QWidget*> m_editControls;  // controls of the toolbar that are disabled in play
};

}  // namespace rubble
