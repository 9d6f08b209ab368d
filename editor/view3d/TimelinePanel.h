#pragma once

#include <QWidget>

class QAction;
class QHBoxLayout;
class QMenu;

namespace rubble {

class PlayController;
class TimelineBar;

/// The timeline of a session with its buttons, below the 3D view.
class TimelinePanel : public QWidget {
    Q_OBJECT
public:
    explicit TimelinePanel(PlayController& controller, QWidget* parent = nullptr);

    TimelineBar& bar() { return *m_bar; }
    /// Adds buttons for actions to the left and to the right of the bar, and one with the menu of branches at the end.
    void addButtons(const QList<QAction*>& left, const QList<QAction*>& right, QMenu* branches);

private:
    QHBoxLayout* m_row;
    TimelineBar* m_bar;
};

}  // namespace rubble
