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

}  // namespace

QAction* menuAction(QMenu& menu, const QString& icon, const QString& text, const QString& hint,
                    const std::function<void()>& function) {
    QAction* action = menu.addAction(iconNamed(icon), text, function);
    action->setToolTip(hint);
    action->setStatusTip(hint);
    return action;
}

QToolButton* panelButton(const QString& icon, const QString& text, const QString& hint, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(iconNamed(icon));
    button->setText(text);
    button->setToolTip(hint);
    button->setStatusTip(hint);
    button->setAccessibleName(text);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAutoRaise(true);
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
