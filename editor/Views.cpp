#include "editor/Views.h"

#include "editor/Action.h"
#include "editor/InstanceGizmo.h"
#include "editor/InstancePlacing.h"
#include "editor/MainWindow.h"
#include "editor/OverlapWatch.h"
#include "editor/SceneView.h"
#include "editor/ViewMeasure.h"
#include "editor/canvas/OutlineTool.h"
#include "editor/canvas/PatternCanvas.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/document/FragmentHiding.h"
#include "editor/icons/Icon.h"
#include "editor/panels/FragmentTable.h"
#include "editor/panels/HistoryPanel.h"
#include "editor/panels/Inspector.h"
#include "editor/panels/IntentPanel.h"
#include "editor/panels/MessagesPanel.h"
#include "editor/panels/PlayPanel.h"
#include "editor/panels/PlayTestPanel.h"
#include "editor/panels/ProblemPanel.h"
#include "editor/panels/ProjectTree.h"
#include "editor/panels/ToolsPanel.h"
#include "viewport/ViewportWidget.h"

#include <QDockWidget>
#include <QLocale>
#include <QMenu>
#include <QSettings>
#include <QSplitter>

#include <initializer_list>
#include <set>
#include <utility>

namespace rubble {

namespace {

constexpr const char* kStateKey = "window/state";
constexpr const char* kFoldedKey = "window/folded";  // sections of the inspector
constexpr int kTreeWidth = 240;                      // this and the following: pixels, at first
constexpr int kInspectorWidth = 320;
constexpr double kAroundBreak = 1.5;  // m that are shown on each side of a break
constexpr int kTableHeight = 240;
constexpr int kStateVersion = 3;  // of the docks: another set of docks, another version

}  // namespace

Views::Views(MainWindow& window)
    : QObject(&window), m_window(window), m_centre(new QSplitter(&window)), m_pieceMenu(new QMenu(&window)) {
    Workspace& workspace = window.workspace();
    m_canvas = new PatternCanvas(workspace.document(), workspace.selection(), workspace.bakes());
    m_scene = new SceneView(workspace);
    m_centre->addWidget(m_canvas);
    m_centre->addWidget(m_scene);
    m_centre->setStretchFactor(0, 1);
    m_centre->setStretchFactor(1, 1);
    m_centre->setChildrenCollapsible(false);
    makeDocks();
    new OverlapWatch(workspace.document(), m_messages, this);
    connect(m_canvas, &PatternCanvas::said, this, &Views::said);
    connect(m_canvas, &PatternCanvas::hintChanged, this, &Views::hintChanged);
    connect(&m_scene->gizmo(), &InstanceGizmo::hintChanged, this, &Views::hintChanged);
    connect(&m_scene->measure(), &ViewMeasure::hintChanged, this, &Views::hintChanged);
    connect(&m_scene->placing(), &InstancePlacing::said, this, &Views::said);
    connect(&m_scene->placing(), &InstancePlacing::hintChanged, this, &Views::hintChanged);
    connect(m_canvas, &PatternCanvas::pointed, this, [this](double x, double y) {
        const QLocale locale;
        emit placeChanged(tr("%1, %2 m").arg(locale.toString(x, 'f', 3), locale.toString(y, 'f', 3)));
    });
    connect(m_canvas, &PatternCanvas::pointerLeft, this, [this] { emit placeChanged({}); });
    connect(&workspace.bakes(), &Bakes::changed, this, [this](Id asset) {
        const auto baked = m_window.workspace().bakes().find(asset);
        std::vector<Message> messages;
        if (baked && baked->bake) messages = messagesOf(*baked->bake);
        if (baked && baked->fault) {
            messages = {
                {.severity = Severity::Fault, .text = QString::fromStdString(baked->fault->message), .asset = asset}};
        }
        m_messages.setOfBake(asset, std::move(messages));
    });
}

QWidget& Views::centre() { return *m_centre; }

void Views::makeDocks() {
    Workspace& workspace = m_window.workspace();
    m_tree = new ProjectTree(workspace.document(), workspace.selection());
    m_inspector = new Inspector(workspace.document(), workspace.selection());
    m_fragments = new FragmentTable(workspace.document(), workspace.selection(), workspace.bakes());
    auto* messages = new MessagesPanel(m_messages, workspace.document());
    auto* history = new HistoryPanel(workspace.document().undoStack());
    connect(m_tree, &ProjectTree::refused, this, &Views::said);
    connect(m_inspector, &Inspector::refused, this, &Views::said);
    connect(messages, &MessagesPanel::jumpRequested, this, qOverload<const Message&>(&Views::jump));
    addDock("dock-project", tr("Project"), m_tree, Qt::LeftDockWidgetArea);
    addDock("dock-inspector", tr("Inspector"), m_inspector, Qt::RightDockWidgetArea);
    addDock("dock-fragments", tr("Fragments"), m_fragments, Qt::BottomDockWidgetArea);
    addDock("dock-messages", tr("Messages"), messages, Qt::BottomDockWidgetArea);
    addDock("dock-history", tr("History"), history, Qt::LeftDockWidgetArea);
    auto* play = new PlayPanel(workspace.play());
    m_tools = new ToolsPanel(workspace.document(), workspace.play());
    connect(m_tools, &ToolsPanel::refused, this, &Views::said);
    connect(play, &PlayPanel::jumpRequested, this, [this](const Vec3& place) {
        m_scene->viewport().frame({place - Vec3(kAroundBreak), place + Vec3(kAroundBreak)});
        m_scene->viewport().setFocus();
    });
    addDock("dock-play", tr("Play"), play, Qt::BottomDockWidgetArea);
    auto* tests = new PlayTestPanel(workspace.document(), workspace.play(), workspace.playTests());
    connect(tests, &PlayTestPanel::refused, this, &Views::said);
    connect(tests, &PlayTestPanel::showRequested, this, [this] { showScene(true); });
    addDock("dock-tools", tr("Throw"), m_tools, Qt::RightDockWidgetArea);
    auto* intent = new IntentPanel(workspace.document(), workspace.selection(), workspace.bakes(), workspace.trials());
    connect(intent, &IntentPanel::refused, this, &Views::said);
    addDock("dock-tests", tr("Tests"), tests, Qt::BottomDockWidgetArea);
    addDock("dock-intent", tr("Strength"), intent, Qt::RightDockWidgetArea);
    addProblems();
    connect(&workspace.play(), &PlayController::stateChanged, this, &Views::takePlayState);
    arrange();
}

/// Its title tells how many there are, so that they are seen behind another dock.
void Views::addProblems() {
    Workspace& workspace = m_window.workspace();
    m_problems = new ProblemPanel(workspace.document(), workspace.selection(), workspace.problems());
    m_fragments->setProblems(workspace.problems());
    QDockWidget* dock = addDock("dock-problems", tr("Problems"), m_problems, Qt::BottomDockWidgetArea);
    connect(m_problems, &ProblemPanel::countChanged, dock,
            [dock](int count) { dock->setWindowTitle(count == 0 ? tr("Problems") : tr("Problems (%L1)").arg(count)); });
    connect(m_problems, &ProblemPanel::said, this, &Views::said);
    connect(m_problems, &ProblemPanel::jumpRequested, this, qOverload<const Problem&>(&Views::jump));
}

QDockWidget* Views::addDock(const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, &m_window);
    dock->setObjectName(name);
    dock->setWidget(content);
    m_window.addDockWidget(area, dock);
    m_docks.append(dock);
    addDockAction(*dock);
    return dock;
}

/// A dock behind another one comes to the front; only one that is seen is hidden.
void Views::addDockAction(QDockWidget& dock) {
    auto* action = new QAction(iconNamed(dock.objectName()), dock.windowTitle(), this);
    action->setStatusTip(tr("Show or hide this dock: %1").arg(dock.windowTitle()));
    action->setCheckable(true);
    connect(&dock, &QDockWidget::visibilityChanged, action, [action, &dock] { action->setChecked(!dock.isHidden()); });
    connect(action, &QAction::triggered, this, [action, &dock] {
        const bool isSeen = dock.isVisible() && !dock.visibleRegion().isEmpty();
        dock.setVisible(!isSeen);
        if (!isSeen) dock.raise();
        action->setChecked(!isSeen);
    });
    m_dockActions.append(action);
}

/// The layout that everybody begins with.
void Views::arrange() {
    QDockWidget *tree = m_docks[0], *inspector = m_docks[1], *fragments = m_docks[2], *messages = m_docks[3],
                *history = m_docks[4], *play = m_docks[5], *tools = m_docks[6], *tests = m_docks[7],
                *intent = m_docks[8], *problems = m_docks[9];
    const std::pair<QDockWidget*, Qt::DockWidgetArea> places[] = {
        {tree, Qt::LeftDockWidgetArea},       {history, Qt::LeftDockWidgetArea},
        {inspector, Qt::RightDockWidgetArea}, {fragments, Qt::BottomDockWidgetArea},
        {messages, Qt::BottomDockWidgetArea}, {play, Qt::BottomDockWidgetArea},
        {tools, Qt::RightDockWidgetArea},     {tests, Qt::BottomDockWidgetArea},
        {intent, Qt::RightDockWidgetArea},    {problems, Qt::BottomDockWidgetArea}};
    for (const auto& [dock, area] : places) {
        dock->setFloating(false);
        m_window.addDockWidget(area, dock);
        dock->show();
    }
    m_window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_window.tabifyDockWidget(fragments, problems);
    m_window.tabifyDockWidget(problems, messages);
    m_window.tabifyDockWidget(messages, play);
    m_window.tabifyDockWidget(play, tests);
    m_window.tabifyDockWidget(inspector, intent);
    m_window.tabifyDockWidget(intent, tools);
    fragments->raise();
    inspector->raise();
    m_window.resizeDocks({tree, inspector}, {kTreeWidth, kInspectorWidth}, Qt::Horizontal);
    m_window.resizeDocks({tree, history}, {3, 1}, Qt::Vertical);
    m_window.resizeDocks({fragments}, {kTableHeight}, Qt::Vertical);
}

void Views::showDocks(bool areShown) {
    if (!areShown) {
        for (QDockWidget* dock : m_docks) dock->hide();
        return;
    }
    m_inspector->setFolded(QSettings().value(kFoldedKey).toStringList());
    const QByteArray kept = QSettings().value(kStateKey).toByteArray();
    if (!m_window.restoreState(kept, kStateVersion)) resetLayout();
}

void Views::toggleDocks() {
    QList<QDockWidget*> visible;
    for (QDockWidget* dock : m_docks) {
        if (!dock->isHidden()) visible.append(dock);
    }
    for (QDockWidget* dock : visible.isEmpty() ? m_hidden : visible) dock->setHidden(!visible.isEmpty());
    m_hidden = visible;
}

void Views::keepLayout() const {
    QSettings settings;
    settings.setValue(kStateKey, m_window.saveState(kStateVersion));
    settings.setValue(kFoldedKey, m_inspector->folded());
}

void Views::resetLayout() {
    arrange();
    m_inspector->setFolded({});
    showCanvas(true);
    showScene(true);
    m_centre->setSizes({1, 1});
}

/// While something is played the 3D view has the middle to itself, and what is told of it is in front.
void Views::takePlayState() {
    const bool isOn = m_window.workspace().play().isOn();
    if (isOn == m_isPlaying) return;
    m_isPlaying = isOn;
    QDockWidget *fragments = m_docks[2], *play = m_docks[5];
    if (isOn) {
        m_hadCanvas = !m_canvas->isHidden();
        m_canvas->hide();
        if (!play->isHidden()) play->raise();
        emit hintChanged({});  // the 3D view tells the keys itself
    } else {
        m_canvas->setHidden(!m_hadCanvas);
        emit hintChanged(m_canvas->hint());
        if (!fragments->isHidden()) fragments->raise();
    }
}

void Views::showCanvas(bool isShown) { m_canvas->setVisible(isShown); }

void Views::showScene(bool isShown) { m_scene->setVisible(isShown); }

void Views::fit() {
    m_canvas->fit();
    m_scene->frameAll();
}

void Views::drawNewOutline() {
    m_canvas->show();
    m_canvas->setFocus();
    m_canvas->setTool(CanvasToolKind::Outline);
    m_canvas->outlineTool().beginDrawing(OutlineTool::Drawing::NewAsset);
}

void Views::takePreferences(const Preferences& preferences) {
    const Units units{preferences.unit};
    m_tree->setUnits(units);
    m_inspector->setUnits(units);
    m_fragments->setUnits(units);
    m_problems->setUnits(units);
    m_tools->setUnits(units);
}

void Views::setInstanceActions(const QList<QAction*>& actions) { m_tree->setInstanceActions(actions); }

/// The canvas goes to places by what lies under the pointer and chooses by its tool, and the list hides and shows rows.
void Views::setPieceActions(const PieceActions& actions) {
    const auto addGroups = [](QMenu& menu, std::initializer_list<QList<QAction*>> groups) {
        for (const QList<QAction*>& group : groups) {
            menu.addSeparator();
            menu.addActions(group);
        }
    };
    auto* kin = new QMenu(tr("Sele&ct"), m_pieceMenu);
    kin->addActions(actions.kin);
    m_pieceMenu->setToolTipsVisible(true);
    addGroups(*m_pieceMenu, {actions.places, actions.breaking, {kin->menuAction()}, actions.hiding});
    auto* separator = new QAction(this);
    separator->setSeparator(true);
    m_canvas->setPieceActions(actions.breaking + QList{separator} + actions.hiding);
    m_fragments->setPieceActions(actions.places + actions.breaking + QList{kin->menuAction()});
}

void Views::keyInViews(QAction& action) {
    action.setShortcutContext(Qt::WidgetShortcut);
    m_canvas->addAction(&action);
    m_scene->viewport().addAction(&action);
}

void Views::setMaterialActions(const QList<QAction*>& actions) {
    m_tree->setMaterialActions(actions);
    m_inspector->setMaterialActions(actions);
}

/// Brings what a message is about into view.
void Views::jump(const Message& message) {
    if (!message.instances.empty()) return jumpTo(message.instances);
    if (!findAsset(m_window.workspace().project(), message.asset)) return;
    m_window.workspace().selection().setAsset(message.asset);
    m_window.workspace().selection().setInside({});
    m_window.workspace().selection().setSeeds(message.seed ? Selection::Seeds{*message.seed} : Selection::Seeds{});
    m_canvas->fit();
    m_canvas->setFocus();
}

/// Chooses what a problem is about, shows it where it is hidden, and brings it close in canvas and 3D view. The list keeps the
/// keys, so that one can go through it.
void Views::jump(const Problem& problem) {
    Workspace& workspace = m_window.workspace();
    if (!findAsset(workspace.project(), problem.asset)) return;
    Selection& selection = workspace.selection();
    selection.setAsset(problem.asset);
    if (problem.kind == ProblemKind::UnknownStrength) {  // it is told in the material's page
        return selection.setMaterial(findAsset(workspace.project(), problem.asset)->material);
    }
    selection.setInside({});
    const std::shared_ptr<const Bake> bake = workspace.problems().bakeOf(problem.asset);
    if (bake && problem.fragment < bake->fragmentCount()) {
        FragmentSet one(bake->fragmentCount(), false);
        one[problem.fragment] = true;
        selection.setChoice(choiceOf(one, *bake));
        showChosen(selection, *bake);
    } else {
        selection.setSeeds(problem.seed ? Selection::Seeds{*problem.seed} : Selection::Seeds{});
    }
    m_canvas->frameChosen(problem.where);
    m_scene->frameFragments();
}

void Views::jumpTo(const std::vector<Id>& instances) {
    Workspace& workspace = m_window.workspace();
    std::set<Id> there;
    for (const Id id : instances) {
        if (findInstance(workspace.project(), id) != nullptr) there.insert(id);
    }
    workspace.selection().setSeeds({});
    workspace.selection().setInstances(workspace.project(), std::move(there));
    m_scene->show();
    m_scene->frameChosen();
    m_scene->setFocus();
}

}  // namespace rubble
