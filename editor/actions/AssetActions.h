#pragma once

#include "core/fracture/pattern/PatternKind.h"
#include "core/geometry/polygon/Polygon.h"
#include "editor/canvas/tools/ShapeDrawing.h"

#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class CompareActions;
struct ActionDefinition;
class Views;
class Workspace;

/// The Asset menu: adding prisms and layers, and editing the active asset.
class AssetActions : public QObject {
    Q_OBJECT
public:
    explicit AssetActions(Views& views);

    QMenu* menu() const { return m_menu; }
    /// The actions that add an asset.
    QList<QAction*> additions() const { return {m_rectangle, m_triangle, m_polygon, m_draw}; }
    QAction* addInstanceAction() const { return m_addInstance; }
    CompareActions& comparison() { return *m_comparison; }

private:
    void addRectangle();
    void addTriangle();
    void addPolygon();
    void drawOutline();
    void addShapeMenu(const QString& title, ShapeDrawing::Purpose purpose, const std::vector<ActionDefinition>& shapes);
    void addPrism(const QString& name, const Polygon& outline, double depth);
    void addLayerAction(QMenu& menu, const PatternKind& kind, QString& mnemonics);
    void addSeedsFromMesh();
    void reseed();
    void showContactSheet();
    void duplicate();
    void remove();
    void addInstance();
    void updateEnabled();

    Views& m_views;
    Workspace& m_workspace;
    QMenu* m_menu;
    CompareActions* m_comparison;
    QAction* m_rectangle = nullptr;
    QAction* m_triangle = nullptr;
    QAction* m_polygon = nullptr;
    QAction* m_draw = nullptr;
    QAction* m_addInstance = nullptr;
    QList<QAction*> m_needAsset;  // enabled while there is an active asset
};

}  // namespace rubble
