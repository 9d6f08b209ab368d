#pragma once

#include "editor/icons/Icon.h"

#include <QString>

#include <functional>

class QAction;
class QMenu;
class QToolButton;
class QWidget;

namespace rubble {

/// An action of a menu with its tooltip.
QAction* menuAction(QMenu& menu, const QString& icon, const QString& text, const QString& hint,
                    const std::function<void()>& function);
/// A small button of a panel: an icon, or its text where that is missing, with a tooltip.
QToolButton* panelButton(const QString& icon, const QString& text, const QString& hint, QWidget* parent);

/// A button as wide as its panel that does what an action does, and looks as it does.
QToolButton* actionButton(QAction* action);

}  // namespace rubble
