#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMenu>

namespace rubble {

/// What an action is called, looks like and says. Its name is also its icon's.
struct ActionLook {
    const char* name;  // "file-open"
    QString text;      // "&Open…"
    QString tip;       // one sentence, for tooltip and status bar
    QKeySequence shortcut = {};
};

/// An action that looks so, belonging to `parent`. Its tooltip tells name and shortcut, too.
QAction* makeAction(QObject* parent, const ActionLook& look);

/// A function that adds actions to a menu: each looks as it is told, belongs to `owner` and calls one of its slots.
template <class Owner>
auto addingTo(QMenu& menu, Owner* owner) {
    return [&menu, owner](const ActionLook& look, void (Owner::*slot)()) {
        QAction* action = makeAction(owner, look);
        QObject::connect(action, &QAction::triggered, owner, slot);
        menu.addAction(action);
        return action;
    };
}

}  // namespace rubble
