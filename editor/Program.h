#pragma once

#include "editor/EnglishPlurals.h"
#include "editor/Preferences.h"
#include "editor/RecentFiles.h"
#include "editor/document/Autosave.h"

#include <QObject>

namespace rubble {

class MainWindow;

/// What all windows of the program share: preferences, recent files, examples; and the windows themselves.
class Program : public QObject {
    Q_OBJECT
public:
    explicit Program(QObject* parent = nullptr);

    const Preferences& preferences() const { return m_preferences; }
    void setPreferences(const Preferences& preferences);
    RecentFiles& recentFiles() { return m_recentFiles; }

    /// Opens the first windows: one for each file, or one with the start page; and offers what a crash left behind.
    void start(const QStringList& files);
    /// A window with a project that lies nowhere yet.
    MainWindow* showNew(Project project, bool isAtWork);
    /// Opens a project file: in the window that shows it already, in `from` where that is pristine, else in a new one.
    /// Tells the user what keeps it from being opened. Null where it could not be opened.
    MainWindow* open(const QString& path, MainWindow* from = nullptr);
    /// Opens a copy that lies nowhere yet: an example.
    MainWindow* openCopy(const QString& path, MainWindow* from = nullptr);
    /// Closes all windows, until the user wants to stay in one.
    void quit();

    /// The folder with `projects` and `docs`: beside the program as installed, else the source tree it was built in.
    static QString dataFolder();
    /// The demo projects.
    static QStringList examples();

signals:
    void preferencesChanged();

private:
    void offerBackups();
    MainWindow* windowFor(MainWindow* from);
    MainWindow* windowWith(const QString& path) const;
    QList<MainWindow*> windows() const;

    EnglishPlurals m_plurals;
    Preferences m_preferences;
    RecentFiles m_recentFiles;
};

}  // namespace rubble
