#include "editor/ViewActions.h"

#include "editor/Action.h"
#include "editor/MainWindow.h"
#include "editor/SceneView.h"
#include "editor/Views.h"
#include "editor/canvas/PatternCanvas.h"
#include "viewport/ViewportWidget.h"

#include <QActionGroup>
#include <QMenu>

#include <utility>

namespace rubble {

ViewActions::ViewActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("&View"), &window)) {
    QAction* fit =
        makeAction(this, {"canvas-fit", tr("&Fit"), tr("Show all of the asset at hand"), QKeySequence("Ctrl+/")});
    connect(fit, &QAction::triggered, &window.views(), &Views::fit);
    m_menu->addAction(fit);
    addTools();
    addCanvasLayers();
    addScene();
    m_menu->addSeparator();
    addPanes();
    m_canvasActions.append(fit);
    setWorking(false);
}

void ViewActions::setWorking(bool isWorking) {
    for (QAction* action : m_menu->actions()) action->setEnabled(isWorking);
}

void ViewActions::addLayer(const ActionLook& look, bool CanvasLayers::*layer) {
    PatternCanvas& canvas = m_window.views().canvas();
    QAction* action = makeAction(this, look);
    action->setCheckable(true);
    action->setChecked(canvas.layers().*layer);
    connect(action, &QAction::toggled, &canvas, [&canvas, layer](bool isOn) {
        CanvasLayers layers = canvas.layers();
        layers.*layer = isOn;
        canvas.setLayers(layers);
    });
    connect(&canvas, &PatternCanvas::layersChanged, action,
            [&canvas, action, layer] { action->setChecked(canvas.layers().*layer); });
    m_canvasActions.append(action);
}

void ViewActions::addTools() {
    PatternCanvas& canvas = m_window.views().canvas();
    QMenu* menu = m_menu->addMenu(tr("&Tool"));
    auto* group = new QActionGroup(this);
    const std::pair<CanvasToolKind, ActionLook> tools[] = {
        {CanvasToolKind::Seeds,
         {"tool-seed", tr("&Seeds"), tr("Place, choose, drag and delete seeds"), QKeySequence("Alt+Q")}},
        {CanvasToolKind::Outline,
         {"tool-outline", tr("&Outline"), tr("Drag, add and delete points of the outline"), QKeySequence("Alt+W")}},
        {CanvasToolKind::Strokes,
         {"tool-stroke", tr("S&trokes"), tr("Draw cracks by hand, drag and delete their points"),
          QKeySequence("Alt+D")}},
        {CanvasToolKind::Brush,
         {"tool-brush", tr("&Brush"), tr("Paint where pieces are small"), QKeySequence("Alt+B")}},
        {CanvasToolKind::Measure,
         {"tool-measure", tr("&Measure"), tr("Measure distances and angles"), QKeySequence("Alt+R")}}};
    for (const auto& [kind, look] : tools) {
        QAction* action = makeAction(this, look);
        action->setCheckable(true);
        action->setChecked(canvas.toolKind() == kind);
        group->addAction(action);
        connect(action, &QAction::triggered, &canvas, [&canvas, tool = kind] {
            canvas.setTool(tool);
            canvas.setFocus();
        });
        connect(&canvas, &PatternCanvas::toolKindChanged, action,
                [action, tool = kind](CanvasToolKind now) { action->setChecked(now == tool); });
        m_toolActions.append(action);
    }
    menu->addActions(m_toolActions);
}

void ViewActions::addCanvasLayers() {
    QMenu* menu = m_menu->addMenu(tr("&Canvas"));
    addLayer(
        {"canvas-cells", tr("&Cells"), tr("Show the cells that the seeds make in the outline"), QKeySequence("Alt+1")},
        &CanvasLayers::hasCells);
    addLayer({"canvas-seeds", tr("&Seeds"), tr("Show the seeds"), QKeySequence("Alt+2")}, &CanvasLayers::hasSeeds);
    addLayer({"canvas-delaunay", tr("Delaunay &Triangles"),
              tr("Show the Delaunay triangulation, and the circle around the triangle under the pointer"),
              QKeySequence("Alt+3")},
             &CanvasLayers::hasTriangles);
    addLayer({"canvas-voronoi", tr("&Unclipped Voronoi"), tr("Show the Voronoi diagram beyond the outline"),
              QKeySequence("Alt+4")},
             &CanvasLayers::hasWholeVoronoi);
    addLayer({"canvas-grid", tr("&Grid"), tr("Show a grid in metres"), QKeySequence("Alt+5")}, &CanvasLayers::hasGrid);
    addLayer({"canvas-legend", tr("&Legend"), tr("Show what signs and colours mean"), QKeySequence("Alt+6")},
             &CanvasLayers::hasLegend);
    addLayer({"canvas-bonds", tr("&Bonds"), tr("Show which cells touch: lines as wide as the edge that they share"),
              QKeySequence("Alt+9")},
             &CanvasLayers::hasBonds);
    menu->addActions(m_canvasActions);

    PatternCanvas& canvas = m_window.views().canvas();
    QMenu* colours = menu->addMenu(tr("C&olour Cells By"));
    auto* group = new QActionGroup(this);
    const std::pair<CellColouring, QString> colourings[] = {
        {CellColouring::None, tr("&Nothing")},       {CellColouring::Piece, tr("&Piece")},
        {CellColouring::Area, tr("&Area")},          {CellColouring::Neighbours, tr("N&eighbours")},
        {CellColouring::Aspect, tr("A&spect")},      {CellColouring::Level, tr("&Level")},
        {CellColouring::Volume, tr("&Volume")},      {CellColouring::Mass, tr("&Mass")},
        {CellColouring::Threshold, tr("&Threshold")}};
    for (const auto& [colouring, text] : colourings) {
        QAction* action = colours->addAction(text);
        action->setCheckable(true);
        action->setChecked(canvas.layers().colouring == colouring);
        action->setStatusTip(tr("Colour the cells of the canvas so"));
        group->addAction(action);
        connect(action, &QAction::triggered, &canvas, [&canvas, value = colouring] {
            CanvasLayers layers = canvas.layers();
            layers.colouring = value;
            canvas.setLayers(layers);
        });
    }
    QAction* snap =
        makeAction(this, {"canvas-snap", tr("S&nap"),
                          tr("Let points and seeds fall on the grid and on the outline; Shift does without"),
                          QKeySequence("Alt+S")});
    snap->setCheckable(true);
    snap->setChecked(canvas.isSnapping());
    connect(snap, &QAction::toggled, &canvas, &PatternCanvas::setSnapping);
    menu->addAction(snap);
    m_canvasActions.append(snap);
}

void ViewActions::addScene() {
    QMenu* menu = m_menu->addMenu(tr("&3D View"));
    menu->addActions(m_window.views().scene().actions());
}

void ViewActions::addPanes() {
    Views& views = m_window.views();
    const auto add = [&](const ActionLook& look) {
        QAction* action = makeAction(this, look);
        m_menu->addAction(action);
        return action;
    };
    QAction* canvas = add({"view-2d", tr("Show C&anvas"), tr("Show the pattern canvas"), QKeySequence("Alt+7")});
    QAction* scene = add({"view-3d", tr("Show 3&D View"), tr("Show the 3D view"), QKeySequence("Alt+8")});
    for (QAction* action : {canvas, scene}) {
        action->setCheckable(true);
        action->setChecked(true);
    }
    connect(canvas, &QAction::toggled, &views, &Views::showCanvas);
    connect(scene, &QAction::toggled, &views, &Views::showScene);
    m_menu->addSeparator();
    m_menu->addMenu(tr("&Docks"))->addActions(views.dockActions());
    QAction* hide =
        add({"view-docks", tr("&Hide or Show Docks"), tr("Hide all docks, or bring them back"), QKeySequence("Tab")});
    connect(hide, &QAction::triggered, &views, &Views::toggleDocks);
    views.keyInViews(*hide);  // elsewhere Tab goes on
    QAction* reset = add({"view-reset-layout", tr("&Reset Layout"), tr("Put all docks back where they were first")});
    connect(reset, &QAction::triggered, &views, &Views::resetLayout);
    QAction* full = add({"view-full-screen", tr("F&ull Screen"), tr("Use the whole screen"), QKeySequence("F11")});
    connect(full, &QAction::triggered, this, &ViewActions::toggleFullScreen);
}

void ViewActions::toggleFullScreen() { m_window.setWindowState(m_window.windowState() ^ Qt::WindowFullScreen); }

}  // namespace rubble
