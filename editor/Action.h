#pragma once

#include <QAction>
#include <QKeySequence>

namespace rubble {

/// What an action is called, looks like and says. Its name is also its icon's.
struct ActionLook {
    const char* name;  // "file-open"
    QString text;      // "&Open…"
    QString tip;       // one sentence, for tooltip and status bar
    QKeySequence shortcut = {};
};

/// An action that looks so, belonging to `parent`. Its tooltip tells the shortcut, too.
QAction* makeAction(QObject* parent, const ActionLook& look);

}  // namespace rubble
