#pragma once

#include "core/asset/Project.h"

#include <QKeySequence>
#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class InstanceGizmo;
class MainWindow;
struct ActionLook;

/// Instance menu: what can be done to the instances that are chosen. Its keys are those of the 3D view, where it has the focus;
/// its actions are in the context menus of 3D view and project tree, too.
class InstanceActions : public QObject {
    Q_OBJECT
public:
    explicit InstanceActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAction* add(const ActionLook& look, void (InstanceActions::*slot)());
    QAction* addMode(const ActionLook& look);
    void addPlacing();
    void addTools();
    void addCopies();
    void addMarks();
    void addContextMenus();
    void choosePlaced();
    void place(Id asset);
    void move();
    void turn();
    void drop();
    void duplicate();
    void arrayInRows();
    void arrayInRing();
    void giveVariants();
    void hide();
    void isolate();
    void showAll();
    void lock();
    void unlockAll();
    void remove();
    void chooseSince(Id first, bool haveVariants);
    void update();

    std::vector<Id> chosen() const;
    InstanceGizmo& gizmo() const;

    MainWindow& m_window;
    QMenu* m_menu;
    QAction* m_place = nullptr;
    QAction* m_showAll = nullptr;
    QAction* m_unlockAll = nullptr;
    QList<QAction*> m_forChosen;   // those that need instances
    QList<QAction*> m_forMovable;  // those that need one that is neither locked nor hidden
};

}  // namespace rubble
