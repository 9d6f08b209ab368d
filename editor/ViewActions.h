#pragma once

#include "editor/canvas/CanvasLayers.h"

#include <QObject>

class QAction;
class QActionGroup;
class QMenu;

namespace rubble {

class MainWindow;

/// View menu: what canvas and 3D view show, and where from; docks and their layout.
class ViewActions : public QObject {
    Q_OBJECT
public:
    explicit ViewActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolActions() const { return m_toolActions; }
    QList<QAction*> canvasActions() const { return m_canvasActions; }
    /// On the start page there is nothing to view.
    void setWorking(bool isWorking);

private:
    void addTools();
    void addCanvasLayers();
    void addScene();
    void addPanes();
    void addLayer(const struct ActionLook& look, bool CanvasLayers::*layer);
    void toggleFullScreen();

    MainWindow& m_window;
    QMenu* m_menu;
    QList<QAction*> m_toolActions;  // these and the following: for toolbars
    QList<QAction*> m_canvasActions;
};

}  // namespace rubble
