#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QMenu>

class QKeyEvent;

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

/// Returns a text for a menu with a mnemonic, the first of its letters that none of the texts before has, if there is
/// one; adds it to `used`.
QString withMnemonic(QString text, QString& used);

/// True if an event is the press of one of the action's shortcuts, or the ShortcutOverride before it.
bool isShortcutOf(const QAction& action, const QEvent& event);
/// Triggers an action by a key press that is one of its shortcuts; not by the repeats of a held key if the action does
/// not repeat.
void triggerByKey(QAction& action, const QKeyEvent& press);
/// Handles an event that is a shortcut of one of the actions: accepts it and, on the press, triggers the action.
/// Returns false for any other event. For event filters of widgets whose shortcuts precede those of the window.
bool handleShortcut(const QList<QAction*>& actions, QEvent& event);

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
