#include "editor/widgets/Buttons.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

namespace rubble {

namespace {

struct ButtonTexts {
    Q_DECLARE_TR_FUNCTIONS(rubble::Buttons)
};

QToolButton* flatButton(QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAutoRaise(true);
    return button;
}

}  // namespace

QAction* menuAction(QMenu& menu, const QString& icon, const QString& text, const QString& hint,
                    const std::function<void()>& function) {
    QAction* action = menu.addAction(iconNamed(icon), text, function);
    action->setToolTip(hint);
    action->setStatusTip(hint);
    return action;
}

QToolButton* panelButton(const QString& icon, const QString& text, const QString& hint, QWidget* parent) {
    QToolButton* button = flatButton(parent);
    button->setIcon(iconNamed(icon));
    button->setText(text);
    button->setToolTip(hint);
    button->setStatusTip(hint);
    button->setAccessibleName(text);
    return button;
}

QToolButton* panelButton(QAction* action, QWidget* parent) {
    QToolButton* button = flatButton(parent);
    button->setDefaultAction(action);
    button->setAccessibleName(action->iconText());
    return button;
}

QToolButton* actionButton(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

void addClearButton(QLineEdit& line) {
    line.setClearButtonEnabled(true);
    for (QToolButton* button : line.findChildren<QToolButton*>()) button->setAccessibleName(ButtonTexts::tr("Clear"));
}

}  // namespace rubble
