#include "editor/actions/TimelineActions.h"

#include "editor/play/EventText.h"
#include "editor/view3d/SceneView.h"
#include "editor/view3d/TimelineBar.h"
#include "editor/view3d/TimelinePanel.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/Icon.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/workspace/Workspace.h"

#include <QLocale>
#include <QMainWindow>
#include <QMenu>

namespace rubble {

TimelineActions::TimelineActions(Views& views, QAction* step)
    : QObject(&views.window()),
      m_views(views),
      m_menu(new QMenu(tr("T&imeline"), &views.window())),
      m_branches(new QMenu(tr("&Earlier Timelines"), &views.window())),
      m_stepBack(makeAction(
          this, {"play-step-back", tr("Step &Back"), tr("Go back by one step"), QKeySequence(Qt::Key_Comma)})),
      m_loop(makeAction(this, {"play-loop", tr("&Loop Around Break"),
                               tr("Play half a second before and a second after a break again and again"),
                               QKeySequence(Qt::Key_L)})) {
    m_previous = makeAction(this, {"timeline-previous-event", tr("&Previous Event"),
                                   tr("Go back to the previous event that the filter in the Play dock shows")});
    m_next = makeAction(this, {"timeline-next-event", tr("&Next Event"),
                               tr("Go to the next event that the filter in the Play dock shows")});
    TimelineBar& bar = views.scene().timeline().bar();
    QAction* in = makeAction(this, {"timeline-zoom-in", tr("Zoom &In"), tr("Zoom in on the displayed time")});
    QAction* out = makeAction(this, {"timeline-zoom-out", tr("Zoom &Out"), tr("Zoom out of the timeline")});
    QAction* fit = makeAction(this, {"timeline-fit", tr("Show &All"), tr("Show the whole timeline")});
    connect(in, &QAction::triggered, &bar, &TimelineBar::zoomIn);
    connect(out, &QAction::triggered, &bar, &TimelineBar::zoomOut);
    connect(fit, &QAction::triggered, &bar, &TimelineBar::fit);
    connect(m_stepBack, &QAction::triggered, &controller(), &PlayController::stepBack);
    connect(m_loop, &QAction::triggered, &controller(), &PlayController::toggleLoop);
    connect(m_previous, &QAction::triggered, &controller(), &PlayController::previousEvent);
    connect(m_next, &QAction::triggered, &controller(), &PlayController::nextEvent);
    m_loop->setCheckable(true);
    m_loop->setAutoRepeat(false);
    m_menu->addActions({m_loop, m_previous, m_next, in, out, fit});
    m_menu->addMenu(m_branches);
    m_branches->setIcon(iconNamed("timeline-branches"));
    m_branches->setToolTipsVisible(true);
    m_branches->menuAction()->setToolTip(tr("Return to a timeline that a later throw, hit or blast replaced"));
    views.scene().timeline().addButtons({m_stepBack, step, m_loop}, {out, in, fit}, m_branches);
    connect(m_branches, &QMenu::aboutToShow, this, &TimelineActions::fillBranches);
    connect(&controller(), &PlayController::frameChanged, this, &TimelineActions::refreshFrame);
    connect(&controller(), &PlayController::stateChanged, this, &TimelineActions::refreshFrame);
    refreshFrame();
}

PlayController& TimelineActions::controller() const { return m_views.workspace().play(); }

void TimelineActions::refreshFrame() {
    const auto& frame = controller().frame();
    const bool isShown = controller().hasSession() && frame;
    m_menu->menuAction()->setEnabled(isShown);
    m_stepBack->setEnabled(isShown && frame->step > 0);
    for (QAction* action : {m_loop, m_previous, m_next}) action->setEnabled(isShown);
    m_loop->setChecked(isShown && frame->loop);
    const qsizetype branches = isShown ? static_cast<qsizetype>(frame->branches.size()) : 0;
    m_branches->setTitle(branches > 0 ? tr("&Earlier Timelines (%L1)").arg(branches) : tr("&Earlier Timelines"));
    m_branches->menuAction()->setEnabled(branches > 0);
}

void TimelineActions::fillBranches() {
    m_branches->clear();
    if (!controller().frame()) return;
    const double dt = controller().thread().stepLength();
    const auto timeOf = [dt](std::uint64_t step) {
        return fixedQuantity(static_cast<double>(step) * dt, 2, Units::seconds());
    };
    for (const PlayBranch& branch : controller().frame()->branches) {
        QAction* action = m_branches->addAction(
            tr("%1 to %2: %3").arg(timeOf(branch.fork), timeOf(branch.length), textOf(branch.broken)));
        action->setToolTip(tr("Return to this timeline, where it leaves the current one"));
        action->setStatusTip(action->toolTip());
        connect(action, &QAction::triggered, &controller(), [this, id = branch.id] { controller().switchTo(id); });
    }
}

}  // namespace rubble

#include "moc_TimelineActions.cpp"
