#pragma once

#include "core/asset/Problems.h"
#include "editor/Preferences.h"
#include "editor/document/Messages.h"

#include <QObject>

#include <optional>

class QAction;
class QDockWidget;
class QMenu;
class QSplitter;

namespace rubble {

class FragmentTable;
class Inspector;
class MainWindow;
class PatternCanvas;
class ProblemPanel;
class ProjectTree;
class SceneView;
class ToolsPanel;

/// What can be done to chosen fragments.
struct PieceActions {
    QList<QAction*> places;    // into one, and out of it
    QList<QAction*> breaking;  // it anew, merging, splitting
    QList<QAction*> kin;       // choosing its neighbours, what it is a piece of, ...
    QList<QAction*> hiding;
};

/// What a window shows of its project: the pattern canvas beside the 3D view in the middle, and the docks around. Each of
/// them knows the workspace and none of the others; here they are put together.
class Views : public QObject {
    Q_OBJECT
public:
    explicit Views(MainWindow& window);

    QWidget& centre();
    PatternCanvas& canvas() { return *m_canvas; }
    SceneView& scene() { return *m_scene; }
    Messages& messages() { return m_messages; }
    const QList<QAction*>& dockActions() const { return m_dockActions; }

    void showDocks(bool areShown);
    /// Hides all docks, or brings back those that were hidden so.
    void toggleDocks();
    void keepLayout() const;
    void resetLayout();
    /// Which of canvas and 3D view are shown.
    void showCanvas(bool isShown);
    void showScene(bool isShown);

    /// Shows all of the asset at hand in canvas and 3D view.
    void fit();
    /// Lets the canvas take the corners of a new prism.
    void drawNewOutline();
    void takePreferences(const Preferences& preferences);
    /// What the tree offers for chosen instances.
    void setInstanceActions(const QList<QAction*>& actions);
    /// What canvas, 3D view and list offer for chosen fragments.
    void setPieceActions(const PieceActions& actions);
    /// The 3D view's menu of chosen fragments.
    QMenu& pieceMenu() { return *m_pieceMenu; }
    /// Lets the key of an action count where canvas or 3D view have the focus, and nowhere else.
    void keyInViews(QAction& action);
    /// What tree and inspector offer for materials: the library first.
    void setMaterialActions(const QList<QAction*>& actions);

signals:
    /// What the tool at hand does.
    void hintChanged(const QString& hint);
    /// Where the pointer is.
    void placeChanged(const QString& place);
    void said(const QString& sentence);

private:
    QDockWidget* addDock(const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
    void addDockAction(QDockWidget& dock);
    void makeDocks();
    void arrange();
    void takePlayState();
    void addProblems();
    void jump(const Message& message);
    void jump(const Problem& problem);
    void jumpTo(const std::vector<Id>& instances);

    MainWindow& m_window;
    Messages m_messages;
    QSplitter* m_centre;
    PatternCanvas* m_canvas;
    SceneView* m_scene;
    ProjectTree* m_tree = nullptr;
    Inspector* m_inspector = nullptr;
    FragmentTable* m_fragments = nullptr;
    ToolsPanel* m_tools = nullptr;
    ProblemPanel* m_problems = nullptr;
    QMenu* m_pieceMenu;
    bool m_isPlaying = false;
    bool m_hadCanvas = true;  // before it was played
    QList<QDockWidget*> m_docks;
    QList<QAction*> m_dockActions;
    QList<QDockWidget*> m_hidden;
};

}  // namespace rubble
