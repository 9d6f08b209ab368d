#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class PlayController;
class Views;

/// The Timeline submenu of the Play menu, and the buttons of the timeline: steps, the loop around a break, the next and
/// previous event, zoom, and branches to return to.
class TimelineActions : public QObject {
    Q_OBJECT
public:
    /// `step` is the action that plays the next step.
    TimelineActions(Views& views, QAction* step);

    QMenu* menu() const { return m_menu; }
    QAction* stepBack() const { return m_stepBack; }
    QAction* loop() const { return m_loop; }

private:
    void refreshFrame();
    void fillBranches();
    PlayController& controller() const;

    Views& m_views;
    QMenu* m_menu;
    QMenu* m_branches;
    QAction* m_stepBack;
    QAction* m_loop;
    QAction* m_previous = nullptr;
    QAction* m_next = nullptr;
};

}  // namespace rubble
