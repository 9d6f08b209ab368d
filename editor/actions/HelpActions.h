#pragma once

#include <QObject>

class QMainWindow;
class QMenu;

namespace rubble {

/// The Help menu: the manual, the search for actions, and the About box.
class HelpActions : public QObject {
    Q_OBJECT
public:
    explicit HelpActions(QMainWindow& window);

    QMenu* menu() const { return m_menu; }

private:
    void openManual();
    void searchActions();
    void showAbout();

    QMainWindow& m_window;
    QMenu* m_menu;
};

}  // namespace rubble
