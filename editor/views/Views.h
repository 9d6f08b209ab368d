#pragma once

#include "core/asset/checks/Problems.h"
#include "editor/canvas/tools/ShapeDrawing.h"
#include "editor/document/Messages.h"
#include "editor/views/DockLayout.h"
#include "editor/workspace/Preferences.h"

class QMenu;
class QSplitter;

namespace rubble {

class FragmentTable;
class Inspector;
class PatternCanvas;
class ProblemPanel;
class ProjectTree;
class SceneView;
class PlayPanel;
class PlayTestPanel;
class PlayToolsPanel;
class StrengthPanel;
class Workspace;

/// The actions on selected fragments, grouped as in context menus.
struct FragmentActionGroups {
    QList<QAction*> navigation;  // enter and exit
    QList<QAction*> editing;     // fracture, merge, split, …
    QList<QAction*> selection;   // of neighbours, siblings, …
    QList<QAction*> visibility;  // hide, isolate, show
};

/// The views of a workspace in its window: canvas and 3D view side by side in the middle, docks around them. Each view
/// knows the workspace and none of the others; this class connects them. The window shows its start page until
/// showProject().
class Views : public QObject {
    Q_OBJECT
public:
    Views(Workspace& workspace, QMainWindow& window);

    Workspace& workspace() { return m_workspace; }
    QMainWindow& window() { return m_window; }
    /// The widget with the canvas and the 3D view.
    QWidget& panes();
    PatternCanvas& canvas() { return *m_canvas; }
    SceneView& scene() { return *m_scene; }
    Messages& messages() { return m_messages; }
    DockLayout& docks() { return m_docks; }
    /// The preferred units.
    const Units& units() const { return m_units; }

    /// Replaces the start page by the views, if that has not happened yet.
    void showProject();
    bool isProjectShown() const { return m_isProjectShown; }
    /// Shows a sentence in the status bar for some seconds.
    void showStatus(const QString& sentence) { emit statusMessage(sentence); }
    /// Shows in the status bar and in Messages, where it stays, why something was not done.
    void showRefusal(const QString& sentence);
    /// Adds messages about what was left out of the project when it was read, and shows the first in the status bar.
    void addNotes(const std::vector<Diagnostic>& notes);

    void setCanvasVisible(bool isVisible);
    void setSceneVisible(bool isVisible);
    /// Restores the default layout of docks, inspector sections, columns of events and panes.
    void resetLayout();
    void saveLayout() const;

    /// Frames the active asset in the canvas, and all that is shown in the 3D view.
    void frameAsset();
    /// Frames the active asset in the canvas, and the instances of assets in the 3D view, such as new ones.
    void frameInstancesOf(std::span<const Id> assets);
    /// Starts drawing a shape in the canvas; see ShapeDrawing::begin().
    void drawShape(ShapeDrawing::Purpose purpose, DraftShape shape);
    void applyPreferences(const Preferences& preferences);

    /// Adds actions on the selected instances to the project tree's context menu.
    void setInstanceActions(const QList<QAction*>& actions);
    /// Adds actions on the selected fragments to the context menus of the canvas, the 3D view and the fragment table.
    void setFragmentActions(const FragmentActionGroups& groups);
    /// Adds actions to the Add menu of the project tree.
    void setAddActions(const QList<QAction*>& actions);
    /// Adds the actions on materials to the project tree and the inspector: opening the library and saving a preset.
    void setMaterialActions(QAction* library, QAction* save);
    /// Adds the actions that export all events of play, and those shown, to the Play dock.
    void setEventActions(QAction* all, QAction* shown);
    /// The context menu of selected fragments in the 3D view.
    QMenu& fragmentMenu() { return *m_fragmentMenu; }
    /// Limits an action's shortcut to the canvas and the 3D view.
    void limitShortcutToViews(QAction& action);

signals:
    /// The start page gave way to the views.
    void projectShown();
    /// The scene is shown alone, or no longer.
    void presentingChanged(bool isOn);
    /// The docks are as they were when the program ended last, or in the default layout.
    void layoutRestored();
    /// What the active tool can do, for the status bar.
    void hintChanged(const QString& hint);
    /// The pointer's position on the canvas, as text; empty: it is elsewhere.
    void positionChanged(const QString& position);
    void statusMessage(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// What is shown of the window.
    struct Arrangement {
        bool hasCanvas = true;
        bool hasScene = true;
        QList<QDockWidget*> docks;
        QList<QDockWidget*> inFront;  // of those with tabs
    };
    Arrangement arrangement() const;
    void arrange(const Arrangement& wanted);
    void present(bool isOn);
    void addDocks();
    void addProblemDock();
    void connectViews();
    void updateBakeMessages(Id asset);
    void showOutlineTool();
    void focusUnderPointer(QWidget& view) const;
    void updatePlayState();
    void frameTrial(const Shot& shot, Id tried);
    void reveal(const Message& message);
    void reveal(const Diagnostic& problem);
    void reveal(const std::vector<Id>& instances);

    Workspace& m_workspace;
    QMainWindow& m_window;
    DockLayout m_docks;
    Messages m_messages;
    QSplitter* m_panes;
    PatternCanvas* m_canvas;
    SceneView* m_scene;
    ProjectTree* m_tree = nullptr;
    Inspector* m_inspector = nullptr;
    FragmentTable* m_fragments = nullptr;
    PlayPanel* m_play = nullptr;
    PlayToolsPanel* m_playTools = nullptr;
    PlayTestPanel* m_tests = nullptr;
    StrengthPanel* m_strength = nullptr;
    ProblemPanel* m_problems = nullptr;
    QMenu* m_fragmentMenu;
    Units m_units;
    bool m_isProjectShown = false;
    bool m_isPlaying = false;
    bool m_isPresenting = false;
    Arrangement m_beforePlay;
    Arrangement m_beforePresenting;  // what is shown when presenting ends
};

}  // namespace rubble
