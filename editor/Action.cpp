#include "editor/Action.h"

#include "editor/icons/Icon.h"

namespace rubble {

QAction* makeAction(QObject* parent, const ActionLook& look) {
    auto* action = new QAction(iconNamed(look.name), look.text, parent);
    action->setObjectName(look.name);
    action->setShortcut(look.shortcut);
    action->setStatusTip(look.tip);
    const QString keys = look.shortcut.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? look.tip : QString("%1 (%2)").arg(look.tip, keys));
    return action;
}

}  // namespace rubble
