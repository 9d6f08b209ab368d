#pragma once

#include "core/base/Result.h"

#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class MainWindow;

/// File menu: projects and meshes in and out. Nothing that is unsaved is ever dropped without being asked about.
class FileActions : public QObject {
    Q_OBJECT
public:
    explicit FileActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolbarActions() const;
    QAction* openAction() const { return m_open; }
    QAction* importAction() const { return m_import; }
    QAction* exportAction() const { return m_export; }

    /// Saves, asking where if need be. False where it was not saved.
    bool save();
    bool saveAs();
    /// Asks about what is unsaved. False where the user wants to stay.
    bool mayBeClosed();
    /// Opens a project, or imports a mesh.
    void take(const QString& path);
    void importMesh(const QString& path);

private:
    void newProject();
    void open();
    void saveSlot() { save(); }
    void saveAsSlot() { saveAs(); }
    void revert();
    void importSlot();
    void exportAs();
    void exportAgain();
    void exportWith(const struct ExportChoice& choice);
    void closeWindow();
    void fillRecent();
    void tell(const Status& status);

    MainWindow& m_window;
    QMenu* m_menu;
    QMenu* m_recent = nullptr;
    QAction* m_new = nullptr;
    QAction* m_open = nullptr;
    QAction* m_save = nullptr;
    QAction* m_revert = nullptr;
    QAction* m_import = nullptr;
    QAction* m_export = nullptr;
    QAction* m_exportAgain = nullptr;
};

/// The end of project files' names, and what a file dialog shows of them.
inline constexpr const char* kProjectSuffix = ".rubble";
QString projectFilter();
/// The same for the meshes that can be imported.
QString meshFilter();
bool isMeshPath(const QString& path);

}  // namespace rubble
