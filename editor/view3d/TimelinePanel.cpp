#include "editor/view3d/TimelinePanel.h"

#include "editor/view3d/TimelineBar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

namespace rubble {

namespace {

constexpr QSize kTimelineIcon{16, 16};

QToolButton* timelineButton() {
    auto* button = new QToolButton;
    button->setIconSize(kTimelineIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QToolButton* timelineButton(QAction* action) {
    QToolButton* button = timelineButton();
    button->setDefaultAction(action);
    return button;
}

/// A button that opens a menu and looks as its action does, which cannot be a button's default action.
QToolButton* timelineButton(QMenu* menu) {
    QToolButton* button = timelineButton();
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    const auto refresh = [button, action = menu->menuAction()] {
        button->setIcon(action->icon());
        button->setText(action->iconText());
        button->setToolTip(action->toolTip());
        button->setEnabled(action->isEnabled());
    };
    QObject::connect(menu->menuAction(), &QAction::changed, button, refresh);
    refresh();
    return button;
}

}  // namespace

TimelinePanel::TimelinePanel(PlayController& controller, QWidget* parent)
    : QWidget(parent), m_row(new QHBoxLayout(this)), m_bar(new TimelineBar(controller)) {
    m_row->setContentsMargins(4, 0, 4, 0);
    m_row->setSpacing(1);
    m_row->addWidget(m_bar, 1);
}

void TimelinePanel::addButtons(const QList<QAction*>& left, const QList<QAction*>& right, QMenu* branches) {
    int place = 0;
    for (QAction* action : left) m_row->insertWidget(place++, timelineButton(action));
    for (QAction* action : right) m_row->addWidget(timelineButton(action));
    QToolButton* button = timelineButton(branches);
    button->setObjectName("timeline-branches");
    m_row->addWidget(button);
}

}  // namespace rubble

#include "moc_TimelinePanel.cpp"
