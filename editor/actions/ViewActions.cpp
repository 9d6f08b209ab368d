#include "editor/actions/ViewActions.h"

#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportWidget.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>

#include <utility>

namespace rubble {

ViewActions::ViewActions(Views& views)
    : QObject(&views.window()), m_views(views), m_menu(new QMenu(tr("&View"), &views.window())) {
    QAction* frame =
        makeAction(this, {"canvas-fit", tr("&Frame Asset"), tr("Frame the active asset in the canvas and the 3D view"),
                          QKeySequence("Ctrl+/")});
    connect(frame, &QAction::triggered, &views, &Views::frameAsset);
    m_menu->addAction(frame);
    addTools();
    addCanvas();
    for (const QAction* action : m_bondActions) m_bondTips.append(action->toolTip());
    connect(&views.workspace().selection(), &Selection::assetChanged, this, &ViewActions::updateBondActions);
    connect(&views.workspace().document(), &Document::changed, this, &ViewActions::updateBondActions);
    updateBondActions();
    m_menu->addMenu(tr("&3D View"))->addActions(views.scene().actions());
    m_menu->addSeparator();
    addPanes();
    m_menu->addSeparator();
    addLayout();
    m_canvasActions.append(frame);
    for (QAction* action : m_menu->actions()) action->setEnabled(views.isProjectShown());
    connect(&views, &Views::projectShown, this, [this] {
        for (QAction* action : m_menu->actions()) action->setEnabled(true);
    });
}

void ViewActions::addTools() {
    QMenu* menu = m_menu->addMenu(tr("&Tools"));
    auto* group = new QActionGroup(this);
    const std::pair<CanvasToolKind, ActionDefinition> tools[] = {
        {CanvasToolKind::Seeds,
         {"tool-select", tr("&Select"), tr("Select fragments; move and delete seeds"), QKeySequence("Alt+Q")}},
        {CanvasToolKind::PlaceSeeds,
         {"tool-seed", tr("&Place Seeds"), tr("Place a seed at each click"), QKeySequence("Alt+N")}},
        {CanvasToolKind::Outline,
         {"tool-outline", tr("&Outline"), tr("Add, move and delete points of the outline"), QKeySequence("Alt+W")}},
        {CanvasToolKind::CrackLines,
         {"tool-crack-lines", tr("&Crack Lines"), tr("Draw crack lines and edit their points"), QKeySequence("Alt+D")}},
        {CanvasToolKind::Brush, {"tool-brush", tr("&Brush"), tr("Paint the density of seeds"), QKeySequence("Alt+B")}},
        {CanvasToolKind::Measure,
         {"tool-measure", tr("&Measure"), tr("Measure distances and angles"), QKeySequence("Alt+R")}}};
    for (const auto& [kind, definition] : tools) m_toolActions.append(addTool(*group, kind, definition));
    addBondBrushes(*group);
    menu->addActions(m_toolActions);
    menu->addSeparator();
    menu->addActions(m_bondActions);
    menu->setToolTipsVisible(true);  // they say why something is disabled
}

QAction* ViewActions::addTool(QActionGroup& group, CanvasToolKind kind, const ActionDefinition& definition) {
    PatternCanvas& canvas = m_views.canvas();
    QAction* action = makeAction(this, definition);
    action->setCheckable(true);
    action->setChecked(canvas.toolKind() == kind);
    group.addAction(action);
    connect(action, &QAction::triggered, &canvas, [&canvas, kind] {
        canvas.setTool(kind);
        canvas.setFocus();
    });
    connect(&canvas, &PatternCanvas::toolKindChanged, action,
            [action, kind](CanvasToolKind active) { action->setChecked(active == kind); });
    return action;
}

void ViewActions::addBondBrushes(QActionGroup& group) {
    const std::pair<CanvasToolKind, ActionDefinition> brushes[] = {
        {CanvasToolKind::AnchorBrush,
         {"tool-anchor", tr("&Anchor Brush"), tr("Paint fragments that stay in place, whatever hits them"),
          QKeySequence("Alt+Shift+A")}},
        {CanvasToolKind::StrengthBrush,
         {"tool-strength", tr("S&trength Brush"), tr("Paint where bonds are stronger or weaker"),
          QKeySequence("Alt+Shift+S")}},
        {CanvasToolKind::NeverBreaksBrush,
         {"tool-never-breaks", tr("Ne&ver Breaks Brush"), tr("Paint fragments that never break"),
          QKeySequence("Alt+Shift+N")}}};
    for (const auto& [kind, definition] : brushes) m_bondActions.append(addTool(group, kind, definition));
}

/// Actions on bonds are off where there are none, with a tooltip that says why; their tools end.
void ViewActions::updateBondActions() {
    Workspace& workspace = m_views.workspace();
    const Asset* asset = findAsset(workspace.project(), workspace.selection().asset());
    const bool isBonded = asset && asset->breakAs == BreakAs::Bonded;
    const QString reason = asset ? tr("This asset breaks whole. Set \"Break as\" to Bonded in the inspector.")
                                 : tr("Select an asset that breaks as bonded.");
    for (qsizetype k = 0; k < m_bondActions.size(); ++k) {
        QAction* action = m_bondActions[k];
        action->setToolTip(isBonded ? m_bondTips[k] : m_bondTips[k] + '\n' + reason);
        if (action->isEnabled() != isBonded) action->setEnabled(isBonded);
        const bool isTool = action->actionGroup() != nullptr;
        if (!isBonded && isTool && action->isChecked()) m_views.canvas().setTool(CanvasToolKind::Seeds);
    }
}

void ViewActions::addCanvas() {
    PatternCanvas& canvas = m_views.canvas();
    QMenu* menu = m_menu->addMenu(tr("&Canvas"));
    addOverlays();
    menu->addActions(m_canvasActions);
    m_canvasActions.removeLast();  // deeper levels: the tool bar shows what is switched often
    m_canvasActions.removeOne(m_bondActions.last());
    addColourings(*menu);
    QAction* snap = makeAction(this, {"canvas-snap", tr("S&nap"), tr("Snap to grid and outline; hold Shift to suspend"),
                                      QKeySequence("Alt+S")});
    snap->setCheckable(true);
    snap->setChecked(canvas.isSnapping());
    connect(snap, &QAction::toggled, &canvas, &PatternCanvas::setSnapping);
    menu->addAction(snap);
    m_canvasActions.append(snap);
}

void ViewActions::addOverlays() {
    addOverlay({"canvas-cells", tr("&Cells"), tr("Show the cells"), QKeySequence("Alt+1")}, &CanvasOverlays::hasCells);
    addOverlay({"canvas-seeds", tr("&Seeds"), tr("Show the seeds"), QKeySequence("Alt+2")}, &CanvasOverlays::hasSeeds);
    addOverlay({"canvas-delaunay", tr("Delaunay &Triangles"),
                tr("Show the Delaunay triangulation and the circumcircle under the pointer"), QKeySequence("Alt+3")},
               &CanvasOverlays::hasTriangles);
    addOverlay({"canvas-voronoi", tr("&Unclipped Voronoi"), tr("Show the Voronoi diagram beyond the outline"),
                QKeySequence("Alt+4")},
               &CanvasOverlays::hasWholeVoronoi);
    addOverlay({"canvas-grid", tr("&Grid"), tr("Show the grid"), QKeySequence("Alt+5")}, &CanvasOverlays::hasGrid);
    addOverlay({"canvas-legend", tr("&Legend"), tr("Show the legend"), QKeySequence("Alt+6")},
               &CanvasOverlays::hasLegend);
    addOverlay({"canvas-bonds", tr("&Bonds"), tr("Show the bonds between cells, wider for longer shared edges"),
                QKeySequence("Alt+9")},
               &CanvasOverlays::hasBonds);
    m_bondActions.append(addOverlay({"canvas-bond-strengths", tr("Bonds by St&rength"),
                                     tr("Show the bonds between fragments, coloured by the factor of their strength")},
                                    &CanvasOverlays::hasBondStrengths));
    addOverlay({"canvas-levels", tr("&Deeper Levels"), tr("Show the fragments of the fragments")},
               &CanvasOverlays::hasDeeperLevels);
}

QAction* ViewActions::addOverlay(const ActionDefinition& definition, bool CanvasOverlays::*overlay) {
    PatternCanvas& canvas = m_views.canvas();
    QAction* action = makeAction(this, definition);
    action->setCheckable(true);
    action->setChecked(canvas.overlays().*overlay);
    connect(action, &QAction::toggled, &canvas, [&canvas, overlay](bool isOn) {
        CanvasOverlays overlays = canvas.overlays();
        overlays.*overlay = isOn;
        canvas.setOverlays(overlays);
    });
    connect(&canvas, &PatternCanvas::overlaysChanged, action,
            [&canvas, action, overlay] { action->setChecked(canvas.overlays().*overlay); });
    m_canvasActions.append(action);
    return action;
}

void ViewActions::addColourings(QMenu& menu) {
    PatternCanvas& canvas = m_views.canvas();
    QMenu* colourings = menu.addMenu(tr("C&olour Cells By"));
    auto* group = new QActionGroup(this);
    const std::pair<CellColouring, QString> entries[] = {
        {CellColouring::None, tr("&None")},           {CellColouring::Fragment, tr("&Fragment")},
        {CellColouring::Area, tr("&Area")},           {CellColouring::Neighbours, tr("N&eighbours")},
        {CellColouring::Aspect, tr("A&spect Ratio")}, {CellColouring::Level, tr("&Level")},
        {CellColouring::Volume, tr("&Volume")},       {CellColouring::Mass, tr("&Mass")},
        {CellColouring::Threshold, tr("&Threshold")}, {CellColouring::Cluster, tr("&Cluster")}};
    for (const auto& [colouring, text] : entries) {
        QAction* action = colourings->addAction(text);
        action->setCheckable(true);
        action->setChecked(canvas.overlays().colouring == colouring);
        action->setStatusTip(tr("Colour the cells by this property"));
        group->addAction(action);
        connect(action, &QAction::triggered, &canvas, [&canvas, value = colouring] {
            CanvasOverlays overlays = canvas.overlays();
            overlays.colouring = value;
            canvas.setOverlays(overlays);
        });
    }
}

void ViewActions::addPanes() {
    const auto add = [this](const ActionDefinition& definition, void (Views::*setVisible)(bool)) {
        QAction* action = makeAction(this, definition);
        action->setCheckable(true);
        action->setChecked(true);
        connect(action, &QAction::toggled, &m_views, setVisible);
        m_menu->addAction(action);
    };
    add({"view-2d", tr("Show C&anvas"), tr("Show or hide the canvas"), QKeySequence("Alt+7")},
        &Views::setCanvasVisible);
    add({"view-3d", tr("Show 3&D View"), tr("Show or hide the 3D view"), QKeySequence("Alt+8")},
        &Views::setSceneVisible);
}

void ViewActions::addLayout() {
    m_menu->addMenu(tr("D&ocks"))->addActions(m_views.docks().actions());
    const auto add = [this](const ActionDefinition& definition) {
        QAction* action = makeAction(this, definition);
        m_menu->addAction(action);
        return action;
    };
    QAction* toggle =
        add({"view-docks", tr("To&ggle Docks"), tr("Hide all docks, or show them again"), QKeySequence("Alt+0")});
    connect(toggle, &QAction::triggered, &m_views.docks(), &DockLayout::toggle);
    QAction* reset = add({"view-reset-layout", tr("&Reset Layout"), tr("Restore the default layout")});
    connect(reset, &QAction::triggered, &m_views, &Views::resetLayout);
    addPresent();
    QAction* full = add({"view-full-screen", tr("F&ull Screen"), tr("Toggle full screen"), QKeySequence("F11")});
    connect(full, &QAction::triggered, this, &ViewActions::toggleFullScreen);
}

/// Escape ends it, too, wherever the focus is.
void ViewActions::addPresent() {
    ViewportWidget& viewport = m_views.scene().viewport();
    const QList<QKeySequence> keys{QKeySequence("F5")}, whileOn{keys.front(), QKeySequence("Esc")};
    QAction* action = makeAction(this, {"view-present", tr("&Present"), tr("Show the scene alone, without overlays")});
    action->setCheckable(true);
    action->setShortcuts(keys);
    m_menu->addAction(action);
    connect(action, &QAction::toggled, &viewport, &ViewportWidget::setPresenting);
    connect(&viewport, &ViewportWidget::presentingChanged, action, [action, keys, whileOn](bool isOn) {
        action->setChecked(isOn);
        action->setShortcuts(isOn ? whileOn : keys);
    });
}

void ViewActions::toggleFullScreen() {
    m_views.window().setWindowState(m_views.window().windowState() ^ Qt::WindowFullScreen);
}

}  // namespace rubble

#include "moc_ViewActions.cpp"
