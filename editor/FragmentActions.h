#pragma once

#include <QObject>

#include <vector>

class QAction;
class QMenu;

namespace rubble {

class MainWindow;
struct ChosenPiece;

/// The menu of what is done to the fragments of the chosen seeds.
class FragmentActions : public QObject {
    Q_OBJECT
public:
    explicit FragmentActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }

private:
    void fracture();
    void keepWhole();
    void merge();
    void split();
    void restore();
    void update();
    std::vector<ChosenPiece> chosen() const;

    MainWindow& m_window;
    QMenu* m_menu;
    QList<QAction*> m_forPieces;  // those that need chosen fragments
    QAction* m_merge = nullptr;   // of two at least
    QAction* m_restore = nullptr;
};

}  // namespace rubble
