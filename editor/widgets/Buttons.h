#pragma once

#include "editor/widgets/Icon.h"

#include <QString>

#include <functional>

class QAction;
class QLineEdit;
class QMenu;
class QToolButton;
class QWidget;

namespace rubble {

/// Adds an action to a menu; the hint becomes its tooltip and status tip.
QAction* menuAction(QMenu& menu, const QString& icon, const QString& text, const QString& hint,
                    const std::function<void()>& function);
/// A flat tool button with an icon, or its text if there is no such icon.
QToolButton* panelButton(const QString& icon, const QString& text, const QString& hint, QWidget* parent);
/// A flat tool button of an action, with its icon.
QToolButton* panelButton(QAction* action, QWidget* parent);

/// A button of an action, as wide as its panel, with icon and text.
QToolButton* actionButton(QAction* action);

/// Adds the button that clears a line of text, with a name for assistive technologies.
void addClearButton(QLineEdit& line);

}  // namespace rubble
