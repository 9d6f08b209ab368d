#include "editor/Action.h"

#include "editor/icons/Icon.h"

namespace rubble {

QAction* makeAction(QObject* parent, const ActionLook& look) {
    auto* action = new QAction(iconNamed(look.name), look.text, parent);
    action->setObjectName(look.name);
    action->setShortcut(look.shortcut);
    action->setStatusTip(look.tip);
    const QString keys = look.shortcut.toString(QKeySequence::NativeText);
    const QString name = look.text.section('\t', 0, 0).remove('&').remove(u'…');
    if (look.text.contains('\t')) action->setIconText(name);  // the key is not part of a button
    action->setToolTip((keys.isEmpty() ? name : QString("%1 (%2)").arg(name, keys)) + '\n' + look.tip);
    return action;
}

}  // namespace rubble
