#pragma once

#include "editor/document/Autosave.h"
#include "editor/document/DocumentFile.h"
#include "editor/workspace/PreferenceStore.h"
#include "editor/workspace/RecentFiles.h"

#include <QObject>

namespace rubble {

class MainWindow;

/// The windows of the program and what they share.
class Program : public QObject {
    Q_OBJECT
public:
    explicit Program(QObject* parent = nullptr);

    PreferenceStore& preferences() { return m_preferences; }
    RecentFiles& recentFiles() { return m_recentFiles; }

    /// Opens one window per file, or one with the start page, and offers to restore backups that a crash left behind.
    void start(const QStringList& files);
    /// Opens a window that shows a project without a file.
    MainWindow* showProject(Project project);
    /// Opens a window with the start page.
    MainWindow* showStartPage();
    /// Opens a project file: in the window that has it already open, otherwise in `from` if that is untouched (see
    /// MainWindow::isUntouched()), otherwise in a new one. If another process holds its lock, asks what to do. Returns
    /// null if the user cancels, or, after showing the error, if the file cannot be opened.
    MainWindow* open(const QString& path, MainWindow* from = nullptr);
    /// Opens a copy of a project file, such as an example. The copy has no file yet. Shows an error and returns null if
    /// the file cannot be read.
    MainWindow* openCopy(const QString& path, MainWindow* from = nullptr);
    /// Closes all windows, until the user cancels.
    void quit();
    /// Writes a backup of each project with changes that are not backed up yet.
    void backUp();

private:
    /// What becomes of the unsaved changes of several windows.
    enum class Unsaved { Ask, Discard, Cancel };
    Unsaved askForUnsaved(const QList<MainWindow*>& modified);
    MainWindow* createWindow(Project project);
    void cascade(MainWindow& window) const;
    void applyPreferences();
    void tellRanOut(const QString& sentence);
    void offerBackups();
    void offerForeignBackup(Backup& backup);
    void restoreBackup(const Backup& backup);
    void showOpened(MainWindow& window);
    void showFaults(MainWindow& window, const DocumentFile::Faults& faults);
    MainWindow* windowFor(MainWindow* from);
    static void discardUnlessShown(MainWindow* window);
    MainWindow* windowWith(const QString& path) const;
    MainWindow* pristineWindow() const;
    QList<MainWindow*> windows() const;

    PreferenceStore m_preferences;
    RecentFiles m_recentFiles;
    ColourScheme m_theme;
};

}  // namespace rubble
