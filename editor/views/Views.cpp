#include "editor/views/Views.h"

#include "core/asset/project/AssetShape.h"
#include "editor/background/OverlapWatch.h"
#include "editor/canvas/tools/OutlineTool.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/document/EnteredFragment.h"
#include "editor/document/FragmentVisibility.h"
#include "editor/panels/docks/FragmentTable.h"
#include "editor/panels/docks/HistoryPanel.h"
#include "editor/panels/docks/MessagesPanel.h"
#include "editor/panels/docks/PlayPanel.h"
#include "editor/panels/docks/PlayTestPanel.h"
#include "editor/panels/docks/PlayToolsPanel.h"
#include "editor/panels/docks/ProblemPanel.h"
#include "editor/panels/docks/ProjectTree.h"
#include "editor/panels/docks/StrengthPanel.h"
#include "editor/panels/inspector/Inspector.h"
#include "editor/view3d/PlayView.h"
#include "editor/view3d/SceneView.h"
#include "editor/view3d/tools/BondPaintTool.h"
#include "editor/view3d/tools/PlacementTool.h"
#include "editor/view3d/tools/SurfaceMeasureTool.h"
#include "editor/view3d/tools/TransformTool.h"
#include "editor/widgets/numbers/NumberText.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportWidget.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QLocale>
#include <QMainWindow>
#include <QMenu>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QSettings>
#include <QSplitter>
#include <QTextEdit>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <set>

namespace rubble {

namespace {

constexpr const char* kHiddenColumnsKey = "window/hidden-event-columns";
constexpr const char* kCollapsedKey = "window/folded";  // sections of the inspector
constexpr int kPositionDecimals = 3;                    // of metres
constexpr double kBreakMargin = 1.5;                    // m shown around a break in each direction

bool takesText(const QWidget* widget) {
    const auto* box = qobject_cast<const QComboBox*>(widget);
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget) ||
           (box && box->isEditable());
}

}  // namespace

Views::Views(Workspace& workspace, QMainWindow& window)
    : QObject(&window),
      m_workspace(workspace),
      m_window(window),
      m_docks(window),
      m_panes(new QSplitter(&window)),
      m_canvas(
          new PatternCanvas(workspace.document(), workspace.selection(), workspace.bakes(), workspace.bondPainter())),
      m_scene(new SceneView(workspace)),
      m_fragmentMenu(new QMenu(&window)) {
    m_canvas->setSections(workspace.sections());
    m_panes->addWidget(m_canvas);
    m_panes->addWidget(m_scene);
    m_panes->setStretchFactor(0, 1);
    m_panes->setStretchFactor(1, 1);
    m_panes->setChildrenCollapsible(false);
    addDocks();
    connectViews();
    for (QWidget* view : {static_cast<QWidget*>(m_canvas), static_cast<QWidget*>(&m_scene->viewport())}) {
        view->installEventFilter(this);
    }
    new OverlapWatch(workspace.document(), m_messages, this);
    m_docks.reset();
    m_docks.hideAll();
}

bool Views::eventFilter(QObject* watched, QEvent* event) {
    const bool isPlainMove =
        event->type() == QEvent::MouseMove && static_cast<QMouseEvent*>(event)->buttons() == Qt::NoButton;
    if (isPlainMove) focusUnderPointer(*static_cast<QWidget*>(watched));
    return QObject::eventFilter(watched, event);
}

/// Gives the focus to the view in which the pointer moves, so that keys go where the user looks; not while a text is
/// typed elsewhere or instances follow the pointer.
void Views::focusUnderPointer(QWidget& view) const {
    const QWidget* focused = QApplication::focusWidget();
    if (focused == &view || !view.isActiveWindow() || takesText(focused)) return;
    if (!m_scene->transformTool().isDragging()) view.setFocus(Qt::MouseFocusReason);
}

QWidget& Views::panes() { return *m_panes; }

void Views::connectViews() {
    connect(m_canvas, &PatternCanvas::statusMessage, this, &Views::statusMessage);
    connect(m_canvas, &PatternCanvas::hintChanged, this, &Views::hintChanged);
    connect(&m_scene->transformTool(), &TransformTool::hintChanged, this, &Views::hintChanged);
    connect(&m_scene->measureTool(), &SurfaceMeasureTool::hintChanged, this, &Views::hintChanged);
    connect(&m_scene->placementTool(), &PlacementTool::statusMessage, this, &Views::statusMessage);
    connect(&m_scene->bondPaintTool(), &BondPaintTool::statusMessage, this, &Views::statusMessage);
    connect(&m_scene->playView().tool(), &PlayTool::statusMessage, this, &Views::statusMessage);
    connect(&m_scene->placementTool(), &PlacementTool::hintChanged, this, &Views::hintChanged);
    connect(m_canvas, &PatternCanvas::pointerMoved, this, [this](double x, double y) {
        const NumberFormat format = m_units.lengths();
        const auto text = [&](double metres) { return fixedText(metres, kPositionDecimals, format); };
        emit positionChanged(withUnit(tr("%1, %2").arg(text(x), text(y)), format));
    });
    connect(m_canvas, &PatternCanvas::pointerLeft, this, [this] { emit positionChanged({}); });
    connect(&m_workspace.bakes(), &Bakes::changed, this, &Views::updateBakeMessages);
    connect(&m_workspace.play(), &PlayController::stateChanged, this, &Views::updatePlayState);
    connect(&m_workspace.file(), &DocumentFile::noted, this, &Views::addNotes);
    connect(m_scene, &SceneView::failed, this, &Views::showRefusal);
    connect(&m_scene->viewport(), &ViewportWidget::presentingChanged, this, &Views::present);
}

void Views::addDocks() {
    Document& document = m_workspace.document();
    Selection& selection = m_workspace.selection();
    m_tree = new ProjectTree(document, selection);
    m_inspector = new Inspector(document, selection, m_workspace.bakes(), m_workspace.mortars());
    m_fragments = new FragmentTable(document, selection, m_workspace.bakes());
    auto* messages = new MessagesPanel(m_messages, document);
    auto* play = m_play = new PlayPanel(document, m_workspace.play());
    m_playTools = new PlayToolsPanel(document, m_workspace.play());
    auto* tests = m_tests =
        new PlayTestPanel(document, m_workspace.file(), m_workspace.play(), m_workspace.playTests());
    m_strength = new StrengthPanel(document, selection, m_workspace.bakes(), m_workspace.swapAudits());
    connect(&document, &Document::refused, this, &Views::showRefusal);
    connect(m_tree, &ProjectTree::refused, this, &Views::showRefusal);
    connect(m_inspector, &Inspector::refused, this, &Views::showRefusal);
    connect(m_playTools, &PlayToolsPanel::refused, this, &Views::showRefusal);
    connect(tests, &PlayTestPanel::refused, this, &Views::showRefusal);
    connect(tests, &PlayTestPanel::statusMessage, this, &Views::statusMessage);
    connect(m_strength, &StrengthPanel::refused, this, &Views::showRefusal);
    connect(m_strength, &StrengthPanel::trialRequested, this, [this](const Shot& shot, Id tried) {
        setSceneVisible(true);
        frameTrial(shot, tried);
        m_workspace.play().playShot(shot);
        m_scene->viewport().setFocus();
    });
    connect(tests, &PlayTestPanel::showRequested, this, [this] { setSceneVisible(true); });
    connect(messages, &MessagesPanel::jumpRequested, this, qOverload<const Message&>(&Views::reveal));
    connect(play, &PlayPanel::statusMessage, this, &Views::statusMessage);
    connect(play, &PlayPanel::refused, this, &Views::showRefusal);
    connect(play, &PlayPanel::jumpRequested, this, [this](const Vec3& place) {
        m_scene->viewport().frame({place - Vec3(kBreakMargin), place + Vec3(kBreakMargin)});
        m_scene->viewport().setFocus();
    });
    connect(m_fragments, &FragmentTable::frameRequested, this, [this] {
        m_canvas->frameSelected();
        m_scene->frameFragments();
    });
    m_docks.add(DockId::Project, tr("Project"), m_tree);
    m_docks.add(DockId::Inspector, tr("Inspector"), m_inspector);
    m_docks.add(DockId::Fragments, tr("Fragments"), m_fragments);
    m_docks.add(DockId::Messages, tr("Messages"), messages);
    m_docks.add(DockId::History, tr("History"), new HistoryPanel(document.undoStack()));
    m_docks.add(DockId::Play, tr("Play"), play);
    m_docks.add(DockId::PlayTools, tr("Play Tools"), m_playTools);
    m_docks.add(DockId::Tests, tr("Tests"), tests);
    m_docks.add(DockId::Strength, tr("Strength"), m_strength);
    addProblemDock();
}

/// The dock's title includes the count, so that problems are noticed while another dock is in front.
void Views::addProblemDock() {
    m_problems = new ProblemPanel(m_workspace.document(), m_workspace.selection(), m_workspace.problems());
    m_fragments->setProblems(m_workspace.problems());
    QDockWidget* dock = &m_docks.add(DockId::Problems, tr("Problems"), m_problems);
    connect(m_problems, &ProblemPanel::countChanged, dock,
            [dock](int count) { dock->setWindowTitle(count == 0 ? tr("Problems") : tr("Problems (%L1)").arg(count)); });
    connect(m_problems, &ProblemPanel::statusMessage, this, &Views::statusMessage);
    connect(m_problems, &ProblemPanel::jumpRequested, this, qOverload<const Diagnostic&>(&Views::reveal));
}

void Views::showRefusal(const QString& sentence) {
    const bool isRepeated = !m_messages.list().empty() && m_messages.list().back().text == sentence;
    if (!isRepeated) m_messages.add({.severity = Severity::Warning, .text = sentence});
    emit statusMessage(sentence);
}

void Views::updateBakeMessages(Id asset) {
    const auto baked = m_workspace.bakes().find(asset);
    std::vector<Message> messages;
    if (baked && baked->bake) messages = messagesOf(*baked->bake);
    if (baked && baked->fault) {
        const QString text = QString::fromStdString(baked->fault->message);
        messages = {{.severity = Severity::Error, .text = text, .asset = asset}};
    }
    m_messages.setOfBake(asset, std::move(messages));
}

void Views::addNotes(const std::vector<Diagnostic>& notes) {
    for (const Diagnostic& note : notes) {
        m_messages.add(
            {.severity = note.severity, .text = QString::fromStdString(note.message), .asset = note.place.asset});
    }
    if (!notes.empty()) showStatus(noteText(notes.front(), m_workspace.project()));
}

void Views::showProject() {
    if (m_isProjectShown) return;
    m_isProjectShown = true;
    m_inspector->setCollapsedSections(QSettings().value(kCollapsedKey).toStringList());
    m_play->events().setHiddenColumns(
        QSettings().value(kHiddenColumnsKey, EventTable::hiddenByDefault()).toStringList());
    emit projectShown();
    if (!m_docks.restore()) resetLayout();
    emit layoutRestored();
    frameAsset();
}

void Views::saveLayout() const {
    m_docks.save();
    QSettings().setValue(kCollapsedKey, m_inspector->collapsedSections());
    QSettings().setValue(kHiddenColumnsKey, m_play->events().hiddenColumns());
}

void Views::resetLayout() {
    m_docks.reset();
    m_inspector->setCollapsedSections({});
    m_play->events().setHiddenColumns(EventTable::hiddenByDefault());
    setCanvasVisible(true);
    setSceneVisible(true);
    m_panes->setSizes({1, 1});
}

/// While the simulation runs, the 3D view has the middle for itself and the Play dock is in front. Then canvas and
/// docks are shown as before.
void Views::updatePlayState() {
    const bool isPlaying = m_workspace.play().isInPlay();
    if (isPlaying == m_isPlaying) return;
    m_isPlaying = isPlaying;
    Arrangement shown = arrangement();
    if (isPlaying) {
        m_beforePlay = shown;
        shown.hasCanvas = false;
        shown.inFront.append(&m_docks.dock(DockId::Play));
    } else {
        shown.hasCanvas = m_beforePlay.hasCanvas;
        shown.inFront = m_beforePlay.inFront;
    }
    arrange(shown);
    emit hintChanged(isPlaying ? QString() : m_canvas->hint());  // in play, the 3D view shows the keys itself
}

/// What is shown; while presenting, what will be shown after it.
Views::Arrangement Views::arrangement() const {
    if (m_isPresenting) return m_beforePresenting;
    return {!m_canvas->isHidden(), !m_scene->isHidden(), m_docks.shown(), m_docks.inFront()};
}

void Views::arrange(const Arrangement& wanted) {
    if (m_isPresenting) {
        m_beforePresenting = wanted;
        return;
    }
    m_canvas->setVisible(wanted.hasCanvas);
    m_scene->setVisible(wanted.hasScene);
    for (QDockWidget* dock : wanted.docks) dock->show();
    DockLayout::raise(wanted.inFront);
}

/// Shows the scene without canvas and docks, or all that was shown before.
void Views::present(bool isOn) {
    if (isOn) {
        m_beforePresenting = arrangement();
        m_isPresenting = true;
        for (QDockWidget* dock : m_beforePresenting.docks) dock->hide();
        m_scene->show();
        m_scene->viewport().setFocus();
        m_canvas->hide();
    } else {
        m_isPresenting = false;
        arrange(m_beforePresenting);
    }
    emit presentingChanged(isOn);
}

void Views::setCanvasVisible(bool isVisible) { m_canvas->setVisible(isVisible); }

/// Frames what an event of a strength requirement acts on: an instance, or the way of the body that it drops.
void Views::frameTrial(const Shot& shot, Id tried) {
    const std::array instances{tried};
    if (tried != 0) return m_scene->frameInstances(instances);
    const auto* thrown = std::get_if<Throw>(&shot.action);
    const Asset* asset = thrown != nullptr ? findAsset(m_workspace.project(), thrown->asset) : nullptr;
    if (asset == nullptr) return;
    const Vec3 around(0.5 * glm::length(sizeOf(*asset)));
    Box3 way{thrown->from - around, thrown->from + around};
    way.min.y = std::min(way.min.y, m_workspace.project().ground.height);
    m_scene->viewport().frame(way);
}

void Views::setSceneVisible(bool isVisible) { m_scene->setVisible(isVisible); }

void Views::frameAsset() {
    m_canvas->fit();
    m_scene->frameAll();
}

void Views::frameInstancesOf(std::span<const Id> assets) {
    m_canvas->fit();
    std::vector<Id> instances;
    for (const Instance& instance : m_workspace.project().instances) {
        if (std::ranges::find(assets, instance.asset) != assets.end()) instances.push_back(instance.id);
    }
    m_scene->frameInstances(instances);
}

void Views::drawShape(ShapeDrawing::Purpose purpose, DraftShape shape) {
    exitToFragment(m_workspace.selection(), {});
    showOutlineTool();
    m_canvas->outlineTool().beginDrawing(purpose, shape);
}

void Views::showOutlineTool() {
    m_canvas->show();
    m_canvas->setFocus();
    m_canvas->setTool(CanvasToolKind::Outline);
}

void Views::applyPreferences(const Preferences& preferences) {
    const Units units = m_units = {preferences.unit};
    m_canvas->setUnits(units);
    m_tree->setUnits(units);
    m_inspector->setUnits(units);
    m_fragments->setUnits(units);
    m_problems->setUnits(units);
    m_playTools->setUnits(units);
    m_strength->setUnits(units);
    m_tests->setUnits(units);
    m_scene->applyPreferences(preferences);
}

void Views::setInstanceActions(const QList<QAction*>& actions) { m_tree->setInstanceActions(actions); }

/// The canvas enters fragments under the pointer and selects by its tool.
void Views::setFragmentActions(const FragmentActionGroups& groups) {
    const auto addGroups = [](QMenu& menu, std::initializer_list<QList<QAction*>> actions) {
        for (const QList<QAction*>& group : actions) {
            menu.addSeparator();
            menu.addActions(group);
        }
    };
    auto* selectMenu = new QMenu(tr("Se&lect"), m_fragmentMenu);
    selectMenu->addActions(groups.selection);
    m_fragmentMenu->setToolTipsVisible(true);
    addGroups(*m_fragmentMenu, {groups.navigation, groups.editing, {selectMenu->menuAction()}, groups.visibility});
    auto* separator = new QAction(this);
    separator->setSeparator(true);
    m_canvas->setFragmentActions(groups.editing + QList{separator} + groups.visibility);
    m_fragments->setFragmentActions(groups.visibility,
                                    groups.navigation + groups.editing + QList{selectMenu->menuAction()});
}

void Views::limitShortcutToViews(QAction& action) {
    action.setShortcutContext(Qt::WidgetShortcut);
    m_canvas->addAction(&action);
    m_scene->viewport().addAction(&action);
}

void Views::setAddActions(const QList<QAction*>& actions) { m_tree->setAddActions(actions); }

void Views::setMaterialActions(QAction* library, QAction* save) {
    m_tree->setMaterialActions({library, save});
    m_inspector->setMaterialActions(library, save);
}

void Views::setEventActions(QAction* all, QAction* shown) { m_play->setExportActions(all, shown); }

/// Selects and frames what a message is about.
void Views::reveal(const Message& message) {
    if (!message.instances.empty()) return reveal(message.instances);
    if (!findAsset(m_workspace.project(), message.asset)) return;
    Selection& selection = m_workspace.selection();
    selection.setAsset(message.asset);
    selection.setEnteredFragment({});
    selection.setSeeds(message.seed ? Selection::Seeds{*message.seed} : Selection::Seeds{});
    m_canvas->fit();
    m_canvas->setFocus();
}

/// Selects what a problem is about, shows it if hidden, and frames it in canvas and 3D view. The focus stays in the
/// list, so that the user can step through it.
void Views::reveal(const Diagnostic& problem) {
    const Asset* asset = findAsset(m_workspace.project(), problem.place.asset);
    if (!asset) return;
    Selection& selection = m_workspace.selection();
    selection.setAsset(problem.place.asset);
    if (problem.code == DiagnosticCode::UnknownStrength) return selection.setMaterial(asset->material);
    selection.setEnteredFragment({});
    const std::shared_ptr<const Bake> bake = m_workspace.problems().bakeOf(problem.place.asset);
    if (bake && problem.place.fragment < bake->fragmentCount()) {
        FragmentSet affected(bake->fragmentCount(), false);
        affected[problem.place.fragment] = true;
        for (const std::uint32_t fragment : problem.place.fragments) {
            if (fragment < affected.size()) affected[fragment] = true;
        }
        selection.setFragments(selectionOf(affected, *bake));
        showSelected(selection, *bake);
    } else {
        const std::optional<SeedId> seed = seedOf(problem.place);
        selection.setSeeds(seed ? Selection::Seeds{*seed} : Selection::Seeds{});
    }
    const std::optional<DiagnosticPlace::Point>& point = problem.place.point;
    m_canvas->frameSelected(point ? std::optional(Vec2{point->x, point->y}) : std::nullopt);
    m_scene->frameFragments();
}

void Views::reveal(const std::vector<Id>& instances) {
    std::set<Id> existing;
    for (const Id id : instances) {
        if (findInstance(m_workspace.project(), id) != nullptr) existing.insert(id);
    }
    m_workspace.selection().setSeeds({});
    m_workspace.selection().setInstances(m_workspace.project(), std::move(existing));
    m_scene->show();
    m_scene->frameSelected();
    m_scene->setFocus();
}

}  // namespace rubble

#include "moc_Views.cpp"
