#include "editor/view3d/tools/ActionKeys.h"

#include "editor/widgets/Action.h"

#include <algorithm>

namespace rubble {

QAction* ActionKeys::actionOf(const QKeyEvent& event) const {
    const auto found = std::ranges::find_if(
        m_actions, [&](const QAction* action) { return action->isEnabled() && isShortcutOf(*action, event); });
    return found != m_actions.end() ? *found : nullptr;
}

bool ActionKeys::overridesShortcut(const QKeyEvent& event) const { return actionOf(event) != nullptr; }

bool ActionKeys::keyPress(const QKeyEvent& event) {
    QAction* action = actionOf(event);
    if (action == nullptr) return false;
    triggerByKey(*action, event);
    return true;
}

}  // namespace rubble

#include "moc_ActionKeys.cpp"
