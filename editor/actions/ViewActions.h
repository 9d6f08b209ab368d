#pragma once

#include "editor/canvas/painting/CanvasOverlays.h"

#include <QObject>
#include <QStringList>

class QAction;
class QActionGroup;
class QMenu;

namespace rubble {

class Views;
enum class CanvasToolKind;
struct ActionDefinition;

/// The View menu: canvas tools and overlays, the 3D view, panes, docks and layout.
class ViewActions : public QObject {
    Q_OBJECT
public:
    explicit ViewActions(Views& views);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolActions() const { return m_toolActions; }
    /// The brushes that paint the bonds of an asset that breaks as bonded, and whether the canvas shows their strength.
    QList<QAction*> bondActions() const { return m_bondActions; }
    QList<QAction*> canvasActions() const { return m_canvasActions; }

private:
    void addTools();
    void addBondBrushes(QActionGroup& group);
    QAction* addTool(QActionGroup& group, CanvasToolKind kind, const ActionDefinition& definition);
    void updateBondActions();
    void addCanvas();
    void addOverlays();
    QAction* addOverlay(const ActionDefinition& definition, bool CanvasOverlays::*overlay);
    void addColourings(QMenu& menu);
    void addPanes();
    void addLayout();
    void addPresent();
    void toggleFullScreen();

    Views& m_views;
    QMenu* m_menu;
    QList<QAction*> m_toolActions;
    QList<QAction*> m_canvasActions;
    QList<QAction*> m_bondActions;
    QStringList m_bondTips;  // of m_bondActions where they are enabled
};

}  // namespace rubble
