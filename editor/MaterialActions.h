#pragma once

#include <QList>
#include <QObject>

class QAction;

namespace rubble {

class MainWindow;

/// What is done with the library of materials: choose from it, and add to it. Offered by the Asset menu, the tree and the inspector.
class MaterialActions : public QObject {
    Q_OBJECT
public:
    explicit MaterialActions(MainWindow& window);

    QList<QAction*> actions() const { return {m_library, m_save}; }

private:
    void openLibrary();
    void saveAsPreset();

    MainWindow& m_window;
    QAction* m_library = nullptr;
    QAction* m_save = nullptr;
};

}  // namespace rubble
