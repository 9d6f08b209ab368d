#pragma once

#include <QObject>

#include <vector>

class QAction;
class QMenu;

namespace rubble {

class MainWindow;
struct ChosenPiece;

/// The menu of what is done to the fragments of the chosen seeds, and of going into one.
class FragmentActions : public QObject {
    Q_OBJECT
public:
    explicit FragmentActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }
    /// Those that take the canvas into a fragment and out of it.
    QList<QAction*> placeActions() const { return {m_into, m_out}; }
    QList<QAction*> breakingActions() const;

private:
    void fracture();
    void keepWhole();
    void merge();
    void split();
    void restore();
    void goIntoChosen();
    void goOutOfIt();
    void update();
    std::vector<ChosenPiece> chosen() const;

    MainWindow& m_window;
    QMenu* m_menu;
    QList<QAction*> m_forPieces;  // those that need chosen fragments
    QAction* m_merge = nullptr;   // of two at least
    QAction* m_restore = nullptr;
    QAction* m_into = nullptr;
    QAction* m_out = nullptr;
};

}  // namespace rubble
