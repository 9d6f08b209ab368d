#include "editor/widgets/Action.h"

#include "editor/widgets/Icon.h"

#include <QKeyEvent>

#include <algorithm>

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

QString withMnemonic(QString text, QString& used) {
    for (qsizetype k = 0; k < text.size(); ++k) {
        if (!text[k].isLetter() || used.contains(text[k], Qt::CaseInsensitive)) continue;
        used += text[k];
        return text.insert(k, '&');
    }
    return text;
}

bool isShortcutOf(const QAction& action, const QEvent& event) {
    if (event.type() != QEvent::ShortcutOverride && event.type() != QEvent::KeyPress) return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    const QKeyCombination pressed(key.modifiers() & ~Qt::KeypadModifier, static_cast<Qt::Key>(key.key()));
    return action.shortcuts().contains(QKeySequence(pressed));
}

void triggerByKey(QAction& action, const QKeyEvent& press) {
    if (!press.isAutoRepeat() || action.autoRepeat()) action.trigger();
}

bool handleShortcut(const QList<QAction*>& actions, QEvent& event) {
    const auto action =
        std::ranges::find_if(actions, [&](QAction* candidate) { return isShortcutOf(*candidate, event); });
    if (action == actions.end()) return false;
    event.accept();
    if (event.type() == QEvent::KeyPress) triggerByKey(**action, static_cast<const QKeyEvent&>(event));
    return true;
}

}  // namespace rubble
