#include "editor/widgets/Action.h"

#include "editor/widgets/Icon.h"

namespace rubble {

QAction* makeAction(QObject* parent, const ActionDefinition& definition) {
    auto* action = new QAction(iconNamed(definition.name), definition.text, parent);
    action->setObjectName(definition.name);
    action->setShortcut(definition.shortcut);
    action->setStatusTip(definition.tip);
    const QString shortcut = definition.shortcut.toString(QKeySequence::NativeText);
    const QString name = definition.text.section('\t', 0, 0).remove('&').remove(u'…');
    if (definition.text.contains('\t')) action->setIconText(name);  // the key after the tab is not part of a button
    action->setToolTip((shortcut.isEmpty() ? name : QString("%1 (%2)").arg(name, shortcut)) + '\n' + definition.tip);
    return action;
}

}  // namespace rubble
