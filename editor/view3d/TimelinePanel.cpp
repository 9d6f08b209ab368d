#include "editor/view3d/TimelinePanel.h"

#include "editor/view3d/TimelineBar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

namespace rubble {

namespace {

constexpr QSize kTimelineIcon{16, 16};

QToolButton* timelineButton(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setIconSize(kTimelineIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
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
    QToolButton* button = timelineButton(branches->menuAction());
    button->setObjectName("timeline-branches");
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setMenu(branches);
    button->setPopupMode(QToolButton::InstantPopup);
    m_row->addWidget(button);
}

}  // namespace rubble

#include "moc_TimelinePanel.cpp"
