#pragma once

#include <QIcon>

#include <functional>

class QAction;
class QMenu;
class QToolButton;

namespace rubble {

/// The program's icon with a name, ":/icons/<name>.svg"; an empty one where there is none.
QIcon iconNamed(const QString& name);
/// The same; the style's where there is none of ours.
QIcon iconNamed(const QString& name, int standardPixmap);

/// An action of a menu with its tooltip.
QAction* menuAction(QMenu& menu, const QString& icon, const QString& text, const QString& hint,
                    const std::function<void()>& function);
/// A small button of a panel: an icon, or its text where that is missing, with a tooltip.
QToolButton* panelButton(const QString& icon, const QString& text, const QString& hint, QWidget* parent);

}  // namespace rubble
