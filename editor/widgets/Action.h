#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMenu>

namespace rubble {

/// The texts, icon and shortcut of an action.
struct ActionDefinition {
    const char* name;  // object name and icon name: "file-open"
    QString text;      // "&Open…"
    QString tip;       // one short imperative sentence, for tooltip and status bar
    QKeySequence shortcut = {};
};

/// Returns a new action owned by `parent`. Its tooltip shows name, shortcut and tip.
QAction* makeAction(QObject* parent, const ActionDefinition& definition);

/// Returns a function that creates actions owned by `owner`, connects each to one of the owner's slots and appends it
/// to `menu`.
template <class Owner>
auto actionAdder(QMenu& menu, Owner* owner) {
    return [&menu, owner](const ActionDefinition& definition, void (Owner::*slot)()) {
        QAction* action = makeAction(owner, definition);
        QObject::connect(action, &QAction::triggered, owner, slot);
        menu.addAction(action);
        return action;
    };
}

}  // namespace rubble
