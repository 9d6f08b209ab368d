#pragma once

#include "editor/dialogs/ProjectExport.h"

#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class ExportOnSave;
class PreferenceStore;
class RecentFiles;
class Views;
class Workspace;

/// The File menu: opening, saving, import and export. Unsaved changes are never discarded without asking.
class FileActions : public QObject {
    Q_OBJECT
public:
    FileActions(Views& views, const PreferenceStore& preferences, RecentFiles& recentFiles);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolbarActions() const;
    QAction* openAction() const { return m_open; }
    QAction* importAction() const { return m_import; }

    /// Saves the project, asking for a path if it has none or is read-only, and what to do if another program changed
    /// the file. Returns false if it was not saved.
    bool save();
    bool saveAs();
    /// Asks whether to save unsaved changes, and completes an export that saving started. Returns false if the user
    /// cancels.
    bool confirmClose();
    /// Opens a project file, or imports a mesh file.
    void openFile(const QString& path);
    /// Imports a mesh file with a dialog. Returns false if the user gave up.
    bool importMesh(const QString& path);

signals:
    void newProjectRequested();
    void openProjectRequested(const QString& path);
    /// To open a copy of an example.
    void exampleRequested(const QString& path);
    void quitRequested();
    /// To compare the project with its file.
    void compareRequested();

private:
    void addExamples();
    void openWithDialog();
    void saveTriggered() { save(); }
    void saveAsTriggered() { saveAs(); }
    void revert();
    bool confirmLosingChanges();
    bool saveOverChange();
    bool saveOverUnreadable();
    bool saveTo(const QString& path);
    void askAboutChangeOnDisk();
    void askAboutChange();
    void askAboutDeletion();
    void importWithDialog();
    void exportWithDialog();
    void exportAgain();
    QString folder() const;
    QString suggestedName() const;
    ExportSummary exportWith(const ExportOptions& options);
    void closeWindow();
    void fillRecent();
    void updateEnabled();

    Views& m_views;
    Workspace& m_workspace;
    const PreferenceStore& m_preferences;
    RecentFiles& m_recentFiles;
    ExportOnSave* m_exportOnSave;
    QMenu* m_menu;
    QMenu* m_recent = nullptr;
    QAction* m_new = nullptr;
    QAction* m_open = nullptr;
    QAction* m_save = nullptr;
    QAction* m_revert = nullptr;
    QAction* m_import = nullptr;
    QAction* m_export = nullptr;
    QAction* m_exportAgain = nullptr;
    bool m_isAskingAboutDisk = false;
    bool m_hasChangedMeanwhile = false;  // the file, while the user is asked about it
};

}  // namespace rubble
