#pragma once

#include <QObject>

class QMenu;

namespace rubble {

class MainWindow;

/// Help menu: the manual, the search for actions, what this program is.
class HelpActions : public QObject {
    Q_OBJECT
public:
    explicit HelpActions(MainWindow& window);
    QMenu* menu() const { return m_menu; }

private:
    void openManual();
    void search();
    void about();

    MainWindow& m_window;
    QMenu* m_menu;
};

}  // namespace rubble
