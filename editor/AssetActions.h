#pragma once

#include "core/fracture/PatternKind.h"

#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class MainWindow;

/// Asset menu: new prisms, layers of seeds, copies and removals.
class AssetActions : public QObject {
    Q_OBJECT
public:
    explicit AssetActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolbarActions() const { return {m_rectangle, m_triangle, m_polygon, m_draw}; }

private:
    void addRectangle();
    void addTriangle();
    void addPolygon();
    void drawOutline();
    void addShape(const QString& name, const Polygon& outline, double depth);
    void addLayerAction(QMenu& menu, const PatternKind& kind);
    void addSeedsOfMesh();
    void shuffle();
    void showSheet();
    void duplicate();
    void remove();
    void place();
    void update();

    MainWindow& m_window;
    QMenu* m_menu;
    QAction* m_rectangle = nullptr;
    QAction* m_triangle = nullptr;
    QAction* m_polygon = nullptr;
    QAction* m_draw = nullptr;
    QList<QAction*> m_forAsset;  // those that need one at hand
};

}  // namespace rubble
