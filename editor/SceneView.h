#pragma once

#include "editor/Preferences.h"
#include "editor/Workspace.h"
#include "viewport/scene/SceneBuilder.h"

#include <QTimer>
#include <QWidget>

#include <functional>

class QComboBox;
class QSlider;

namespace rubble {

class InstanceGizmo;
class InstancePlacing;
class PlayView;
class SceneLegend;
class ViewMeasure;
class ViewportWidget;

/// The 3D view of a workspace with its bar: makes scenes of what was baked, marks what is chosen and hidden, and turns
/// clicks into choices.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(Workspace& workspace, QWidget* parent = nullptr);

    ViewportWidget& viewport() { return *m_viewport; }
    InstanceGizmo& gizmo() { return *m_gizmo; }
    InstancePlacing& placing() { return *m_placing; }
    ViewMeasure& measure() { return *m_measure; }
    void frameAll();
    void showWholeScene();
    /// Brings the chosen instances close, as they are now.
    void frameChosen();
    /// Brings the chosen fragments close, where they are shown.
    void frameFragments();
    /// Whether instances may be moved and placed: they may where the whole scene is shown.
    void setEditable(bool isEditable);
    bool isEditable() const { return m_isEditable && !m_isAssetOnly; }
    /// Chooses the instance at a point, unless it is chosen.
    void chooseAt(QPoint point);
    /// Chooses the fragment at a point, unless it is chosen, where one works on pieces: in the asset by itself, or in the instance
    /// of which pieces are chosen. False elsewhere.
    bool choosePieceAt(QPoint point);
    void takePreferences(const Preferences& preferences);
    /// What is played is shown by it.
    PlayView& playView() { return *m_playView; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void addViews();
    void addToggle(const struct ActionLook& look, bool isOn, const std::function<void(bool)>& take);
    void addToggles();
    void addMeasure();
    void addSeparator();
    QWidget* makeBar();
    QWidget* makeViewMenu();
    QWidget* makeExploded();
    /// Has the scene made anew before the next picture; what did not change costs nothing.
    void invalidate() { m_timer.start(); }
    void update();
    SceneMarks marks() const;
    void addMarks(const FragmentChoice& choice, std::vector<PickId>& picks) const;
    /// The last bake of the asset at hand; null where there is none.
    std::shared_ptr<const Bake> bakeAtHand() const;
    void pickAll(const std::vector<PickId>& ids, Qt::KeyboardModifiers modifiers);
    void pickFragments(const std::vector<PickId>& ids, bool isMore);
    void chooseNothing();
    void takePlayState();
    void chooseInstance(Id instance, bool isMore);
    void updateEditing();
    bool isOfChosenPieces(const std::optional<PickId>& id) const;
    void pick(const std::optional<PickId>& id, Qt::KeyboardModifiers modifiers);

    Workspace& m_workspace;
    ViewportWidget* m_viewport;
    InstanceGizmo* m_gizmo;
    InstancePlacing* m_placing;
    bool m_isEditable = true;
    SceneBuilder m_builder;
    SceneOptions m_options;
    QComboBox* m_scope = nullptr;
    bool m_isAssetOnly = false;
    QTimer m_timer;
    SceneLegend* m_legend;
    PlayView* m_playView;
    ViewMeasure* m_measure;
    QAction* m_measuring = nullptr;
    QWidget* m_timeline;
    QList<QWidget*> m_notInPlay;  // controls of the bar that say nothing while it is played
};

}  // namespace rubble
