#include "editor/actions/AssetActions.h"

#include "core/geometry/polygon/OutlineShapes.h"
#include "core/io/mesh/MeshImport.h"
#include "core/io/system/ProgramFolder.h"
#include "editor/actions/CompareActions.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/dialogs/FileFilters.h"
#include "editor/dialogs/ShapeDialog.h"
#include "editor/dialogs/import/MeshReading.h"
#include "editor/dialogs/import/MeshSeedsDialog.h"
#include "editor/dialogs/sheet/ContactSheetWindow.h"
#include "editor/document/ShownText.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/appearance/LayerText.h"
#include "editor/workspace/Workspace.h"

#include <QFileDialog>
#include <QMainWindow>
#include <QMenu>

#include <array>

namespace rubble {

AssetActions::AssetActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_menu(new QMenu(tr("&Asset"), &views.window())),
      m_comparison(new CompareActions(views)) {
    const auto add = actionAdder(*m_menu, this);
    m_rectangle = add({"shape-rectangle", tr("Add &Rectangle…"), tr("Add a prism with a rectangular outline")},
                      &AssetActions::addRectangle);
    m_triangle =
        add({"shape-triangle", tr("Add &Triangle…"), tr("Add a prism with an isosceles triangle as its outline")},
            &AssetActions::addTriangle);
    m_polygon = add({"shape-polygon", tr("Add &Polygon…"), tr("Add a prism with a regular polygon as its outline")},
                    &AssetActions::addPolygon);
    m_draw = add({"shape-draw", tr("&Draw Outline…"), tr("Draw the outline of a new prism point by point")},
                 &AssetActions::drawOutline);
    m_menu->addSeparator();
    addShapeMenu(
        tr("Add to Outli&ne"), ShapeDrawing::Purpose::Add,
        {{"outline-add-rectangle", tr("Add R&ectangle to Outline"), tr("Draw a rectangle that extends the outline")},
         {"outline-add-polygon", tr("Add P&olygon to Outline"), tr("Draw a shape that extends the outline")},
         {"outline-add-circle", tr("Add &Circle to Outline"), tr("Draw a circle that extends the outline")}});
    addShapeMenu(
        tr("&Cut from Outline"), ShapeDrawing::Purpose::Cut,
        {{"outline-cut-rectangle", tr("Cut &Rectangle from Outline"),
          tr("Draw a rectangular door, notch or hole of the outline")},
         {"outline-cut-polygon", tr("Cut &Polygon from Outline"), tr("Draw a notch or a hole of the outline")},
         {"outline-cut-circle", tr("Cut &Circle from Outline"), tr("Draw a round notch or hole of the outline")}});
    m_menu->addSeparator();
    QMenu* layers = m_menu->addMenu(tr("Add &Layer"));
    QString mnemonics;
    for (const PatternKind* kind : patternKinds()) addLayerAction(*layers, *kind, mnemonics);
    m_needAsset += layers->actions();
    m_needAsset +=
        {add({"layer-mesh", tr("Add &Seeds from Mesh…"), tr("Add a layer with a seed at each vertex of a mesh file")},
             &AssetActions::addSeedsFromMesh),
         add({"asset-reseed", tr("R&eseed"), tr("Give each scattered layer a new random seed"), QKeySequence("Ctrl+R")},
             &AssetActions::reseed),
         add({"asset-duplicate", tr("D&uplicate Asset"), tr("Duplicate the active asset"), QKeySequence("Ctrl+D")},
             &AssetActions::duplicate),
         m_addInstance =
             add({"instance-add", tr("Add &Instance"), tr("Add an instance of the active asset to the scene")},
                 &AssetActions::addInstance),
         add({"asset-delete", tr("Delete &Asset"), tr("Delete the active asset and its instances")},
             &AssetActions::remove)};
    m_menu->addSeparator();
    m_needAsset += add({"asset-sheet", tr("Contact S&heet…"), tr("Compare variants of the active asset side by side"),
                        QKeySequence("Ctrl+T")},
                       &AssetActions::showContactSheet);
    m_menu->addActions(m_comparison->actions());
    connect(&m_workspace.selection(), &Selection::assetChanged, this, &AssetActions::updateEnabled);
    updateEnabled();
}

void AssetActions::addRectangle() {
    ShapeDialog dialog(tr("Add Rectangle"), {{tr("&Width:"), 1.0}, {tr("&Height:"), 1.0}, {tr("&Depth:"), 0.5}},
                       m_views.units(), &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    addPrism(tr("rectangle"), rectangleOutline(dialog.length(0), dialog.length(1)), dialog.length(2));
}

void AssetActions::addTriangle() {
    ShapeDialog dialog(tr("Add Triangle"), {{tr("&Base:"), 2.0}, {tr("&Height:"), 1.0}, {tr("&Depth:"), 0.5}},
                       m_views.units(), &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    addPrism(tr("triangle"), isoscelesTriangleOutline(dialog.length(0), dialog.length(1)), dialog.length(2));
}

void AssetActions::addPolygon() {
    ShapeDialog dialog(tr("Add Polygon"), {{tr("D&iameter:"), 1.0}, {tr("&Depth:"), 1.0}}, m_views.units(),
                       &m_views.window());
    dialog.addCorners(8);
    if (dialog.exec() != QDialog::Accepted) return;
    addPrism(tr("polygon"), regularPolygonOutline(dialog.corners(), dialog.length(0)), dialog.length(1));
}

void AssetActions::drawOutline() {
    m_views.showProject();
    m_views.drawShape(ShapeDrawing::Purpose::NewAsset, DraftShape::Polygon);
}

/// `shapes`: the actions that draw a rectangle, a polygon and a circle.
void AssetActions::addShapeMenu(const QString& title, ShapeDrawing::Purpose purpose,
                                const std::vector<ActionDefinition>& shapes) {
    QMenu* menu = m_menu->addMenu(title);
    constexpr std::array kShapes{DraftShape::Rectangle, DraftShape::Polygon, DraftShape::Circle};
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        QAction* action = makeAction(this, shapes[k]);
        menu->addAction(action);
        connect(action, &QAction::triggered, this,
                [this, purpose, shape = kShapes[k]] { m_views.drawShape(purpose, shape); });
        m_needAsset += action;
    }
}

void AssetActions::addPrism(const QString& name, const Polygon& outline, double depth) {
    m_views.showProject();
    Addition added = addAsset(m_workspace.project(), name.toStdString(), {outline, depth});
    if (!m_workspace.document().push(std::move(added.edit))) return;
    m_workspace.selection().setAsset(added.id);
    m_views.frameInstancesOf({{added.id}});
}

/// `mnemonics`: those of the menu, to which it adds one.
void AssetActions::addLayerAction(QMenu& menu, const PatternKind& kind, QString& mnemonics) {
    const QString text = withMnemonic(inTitleCase(patternText(kind.caption)), mnemonics);
    QAction* action = makeAction(this, {kind.icon, text, patternText(kind.hint)});
    menu.addAction(action);
    connect(action, &QAction::triggered, this, [this, &kind] {
        const Asset& asset = *m_workspace.asset();
        const LayerParameters parameters = kind.defaultsFor(domainBox(asset));
        m_workspace.document().push(addLayer(m_workspace.project(), asset.id, parameters).edit);
    });
}

void AssetActions::addSeedsFromMesh() {
    if (!m_workspace.asset()->isPrism())
        return m_views.showStatus(
            tr("Seeds are taken from a mesh into the outline of a prism; the active asset is a mesh."));
    QWidget* window = &m_views.window();
    const QString path = QFileDialog::getOpenFileName(window, tr("Add Seeds from Mesh"), {}, meshFilter());
    if (path.isEmpty()) return;
    const std::filesystem::path importer = importerPath(programFolder());
    std::optional<SourceScene> mesh = readMesh(path, importer, window);
    if (!mesh) return;
    const Asset& asset = *m_workspace.asset();
    MeshSeedsDialog dialog(fileNameText(path), std::move(*mesh), asset.prism().outline, window);
    if (dialog.exec() != QDialog::Accepted) return;
    m_workspace.document().push(addLayer(m_workspace.project(), asset.id, dialog.seeds()).edit);
}

void AssetActions::reseed() {
    Asset asset = *m_workspace.asset();
    for (PatternLayer& layer : ownPattern(asset, m_workspace.selection().enteredFragment()).layers) {
        ++layer.randomSeed;
        layer.scatteredIn.reset();
    }
    m_workspace.document().push(modify(tr("Reseed"), std::move(asset)));
}

void AssetActions::showContactSheet() {
    auto* sheet = new ContactSheetWindow(m_workspace, m_views.units(), &m_views.window());
    sheet->show();
    sheet->generate();
}

void AssetActions::duplicate() {
    Addition added = duplicateAsset(m_workspace.project(), m_workspace.selection().asset());
    if (m_workspace.document().push(std::move(added.edit))) m_workspace.selection().setAsset(added.id);
}

void AssetActions::addInstance() {
    Addition added = rubble::addInstance(m_workspace.project(), m_workspace.selection().asset());
    if (!m_workspace.document().push(std::move(added.edit))) return;
    m_workspace.selection().setInstances(m_workspace.project(), {added.id});
}

void AssetActions::remove() {
    m_workspace.document().push(removeAssets(m_workspace.project(), std::vector{m_workspace.selection().asset()}));
}

void AssetActions::updateEnabled() {
    for (QAction* action : m_needAsset) action->setEnabled(m_workspace.asset() != nullptr);
}

}  // namespace rubble

#include "moc_AssetActions.cpp"
