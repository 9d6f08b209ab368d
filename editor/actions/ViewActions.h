#pragma once

#include "editor/canvas/painting/CanvasOverlays.h"

#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class Views;
struct ActionDefinition;

/// The View menu: canvas tools and overlays, the 3D view, panes, docks and layout.
class ViewActions : public QObject {
    Q_OBJECT
public:
    explicit ViewActions(Views& views);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolActions() const { return m_toolActions; }
    QList<QAction*> canvasActions() const { return m_canvasActions; }

private:
    void addTools();
    void addCanvas();
    void addOverlays();
    void addOverlay(const ActionDefinition& definition, bool CanvasOverlays::*overlay);
    void addColourings(QMenu& menu);
    void addPanes();
    void addLayout();
    void addPresent();
    void toggleFullScreen();

    Views& m_views;
    QMenu* m_menu;
    QList<QAction*> m_toolActions;
    QList<QAction*> m_canvasActions;
};

}  // namespace rubble
