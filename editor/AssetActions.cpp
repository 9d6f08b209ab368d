#include "editor/AssetActions.h"

#include "core/geometry/OutlineShapes.h"
#include "core/io/MeshImport.h"
#include "editor/Action.h"
#include "editor/ContactSheetWindow.h"
#include "editor/FileActions.h"
#include "editor/MainWindow.h"
#include "editor/MeshReading.h"
#include "editor/MeshSeedsDialog.h"
#include "editor/ShapeDialog.h"
#include "editor/Views.h"
#include "editor/WhatChanged.h"
#include "editor/commands/LayerKind.h"
#include "editor/commands/PatternPlaces.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/LayerText.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

namespace rubble {

namespace {

/// "Blue Noise" of "Blue noise".
QString inTitleCase(QString text) {
    for (qsizetype k = 1; k < text.size(); ++k) {
        if (text[k - 1] == ' ') text[k] = text[k].toUpper();
    }
    return text;
}

}  // namespace

AssetActions::AssetActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("&Asset"), &window)) {
    const auto add = addingTo(*m_menu, this);
    m_rectangle = add({"shape-rectangle", tr("Add &Rectangle…"), tr("Add a box: a rectangle with a depth")},
                      &AssetActions::addRectangle);
    m_triangle = add({"shape-triangle", tr("Add &Triangle…"), tr("Add a gable: an isosceles triangle with a depth")},
                     &AssetActions::addTriangle);
    m_polygon = add({"shape-polygon", tr("Add &Polygon…"), tr("Add a column: a regular polygon with a depth")},
                    &AssetActions::addPolygon);
    m_draw = add({"shape-draw", tr("&Draw Outline…"), tr("Add a prism whose outline you draw point by point")},
                 &AssetActions::drawOutline);
    m_menu->addSeparator();
    QMenu* layers = m_menu->addMenu(tr("Add &Layer"));
    for (const PatternKind* kind : patternKinds()) addLayerAction(*layers, *kind);
    m_forAsset = layers->actions();
    m_forAsset +=
        {add({"layer-mesh", tr("&Seeds from Mesh…"), tr("Add a layer of seeds, one at each point of a mesh file")},
             &AssetActions::addSeedsOfMesh),
         add({"asset-shuffle", tr("Scatter A&gain"), tr("Give every scattered layer another random seed"),
              QKeySequence("Ctrl+R")},
             &AssetActions::shuffle),
         add({"asset-duplicate", tr("D&uplicate Asset"), tr("Add a copy of the asset at hand"), QKeySequence("Ctrl+D")},
             &AssetActions::duplicate),
         add({"instance-add", tr("Place &Instance"), tr("Stand the asset at hand in the scene once more")},
             &AssetActions::place),
         add({"asset-delete", tr("De&lete Asset"), tr("Delete the asset at hand and its instances")},
             &AssetActions::remove)};
    m_menu->addSeparator();
    m_forAsset += add({"asset-sheet", tr("Contact &Sheet…"), tr("Look at variants of the asset at hand side by side"),
                       QKeySequence("Ctrl+T")},
                      &AssetActions::showSheet);
    m_menu->addActions((new WhatChanged(window))->actions());
    connect(&window.workspace().selection(), &Selection::assetChanged, this, &AssetActions::update);
    update();
}

void AssetActions::addRectangle() {
    ShapeDialog dialog(tr("Add Rectangle"), {{tr("&Width:"), 1.0}, {tr("&Height:"), 1.0}, {tr("&Depth:"), 0.5}},
                       &m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    addShape(tr("wall"), rectangleOutline(dialog.length(0), dialog.length(1)), dialog.length(2));
}

void AssetActions::addTriangle() {
    ShapeDialog dialog(tr("Add Triangle"), {{tr("&Base:"), 2.0}, {tr("&Height:"), 1.0}, {tr("&Depth:"), 0.5}},
                       &m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    addShape(tr("gable"), isoscelesTriangleOutline(dialog.length(0), dialog.length(1)), dialog.length(2));
}

void AssetActions::addPolygon() {
    ShapeDialog dialog(tr("Add Polygon"), {{tr("D&iameter:"), 1.0}, {tr("&Depth:"), 1.0}}, &m_window);
    dialog.askCorners(8);
    if (dialog.exec() != QDialog::Accepted) return;
    addShape(tr("column"), regularPolygonOutline(dialog.corners(), dialog.length(0)), dialog.length(1));
}

void AssetActions::drawOutline() {
    m_window.showWork();
    m_window.views().drawNewOutline();
}

void AssetActions::addShape(const QString& name, const Polygon& outline, double depth) {
    m_window.showWork();
    Addition added = addAsset(m_window.workspace().project(), name.toStdString(), {outline, depth});
    m_window.workspace().document().push(std::move(added.edit));
    m_window.workspace().selection().setAsset(added.id);
    m_window.views().fit();
}

void AssetActions::addLayerAction(QMenu& menu, const PatternKind& kind) {
    const LayerParameters usual = kind.suitedTo({{0.0, 0.0}, {1.0, 1.0}});
    QAction* action =
        makeAction(this, {kindIconName(usual), '&' + inTitleCase(kindText(usual)), patternText(kind.hint)});
    menu.addAction(action);
    connect(action, &QAction::triggered, this, [this, &kind] {
        Workspace& workspace = m_window.workspace();
        const Asset& asset = *workspace.asset();
        workspace.document().push(addLayer(workspace.project(), asset.id, kind.suitedTo(boundsToFill(asset))).edit);
    });
}

void AssetActions::addSeedsOfMesh() {
    Workspace& workspace = m_window.workspace();
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Seeds from Mesh"), {}, meshFilter());
    if (path.isEmpty()) return;
    const std::filesystem::path importer = importerBeside(QApplication::applicationDirPath().toStdString());
    std::optional<SourceScene> mesh = readMesh(path, importer, &m_window);
    if (!mesh) return;
    const Asset& asset = *workspace.asset();
    MeshSeedsDialog dialog(QFileInfo(path).fileName(), std::move(*mesh), asset.prism.outline, &m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    workspace.document().push(addLayer(workspace.project(), asset.id, dialog.seeds()).edit);
}

void AssetActions::shuffle() {
    Asset asset = *m_window.workspace().asset();
    for (PatternLayer& layer : ownPattern(asset, m_window.workspace().selection().inside()).layers) ++layer.randomSeed;
    m_window.workspace().document().push(altered(tr("Scatter again"), std::move(asset)));
}

void AssetActions::showSheet() {
    auto* sheet = new ContactSheetWindow(m_window);
    sheet->show();
    sheet->make();
}

void AssetActions::duplicate() {
    Workspace& workspace = m_window.workspace();
    Addition added = duplicateAsset(workspace.project(), workspace.selection().asset());
    workspace.document().push(std::move(added.edit));
    workspace.selection().setAsset(added.id);
}

void AssetActions::place() {
    Workspace& workspace = m_window.workspace();
    Addition added = addInstance(workspace.project(), workspace.selection().asset());
    workspace.document().push(std::move(added.edit));
    workspace.selection().setInstances(workspace.project(), {added.id});
}

void AssetActions::remove() {
    Workspace& workspace = m_window.workspace();
    workspace.document().push(removeAssets(workspace.project(), std::vector{workspace.selection().asset()}));
}

void AssetActions::update() {
    for (QAction* action : m_forAsset) action->setEnabled(m_window.workspace().asset() != nullptr);
}

}  // namespace rubble
