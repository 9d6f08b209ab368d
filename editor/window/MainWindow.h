#pragma once

#include "editor/workspace/PreferenceStore.h"
#include "editor/workspace/RecentFiles.h"
#include "editor/workspace/Workspace.h"

#include <QMainWindow>

class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolBar;
class QToolButton;

namespace rubble {

class AssetActions;
class EditActions;
class FileActions;
class VideoActions;
class PlayActions;
class ViewActions;
class Views;

/// A window with one project: menus, toolbars, docks, canvas and 3D view; or the start page until there is a project.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// `preferences` and `recentFiles` are shared by all windows and outlive them.
    MainWindow(Project project, PreferenceStore& preferences, RecentFiles& recentFiles);
    ~MainWindow() override;

    Workspace& workspace() { return m_workspace; }
    Views& views() { return *m_views; }
    FileActions& fileActions() { return *m_fileActions; }

    /// Whether it still shows the start page.
    bool isPristine() const;
    /// Whether another project may be opened in it: it shows the start page, or an empty project that was never saved.
    bool isUntouched();
    /// Asks whether to stop what is being exported; false if the window has to stay open for it or for a dialog.
    bool confirmStop();
    /// Asks, besides, whether to save unsaved changes; false if the window has to stay open.
    bool confirmClose();
    /// Starts the simulation of the demo: a click in the 3D view throws.
    void playDemo();
    /// Closes the window without questions, and loses its changes; false if a dialog keeps it open.
    bool closeWithoutSaving();

signals:
    void newProjectRequested();
    void openProjectRequested(const QString& path);
    /// Requests to open a copy of a project, such as an example.
    void openCopyRequested(const QString& path);
    /// Requests to open a copy of the demo project and to play it.
    void playDemoRequested(const QString& path);
    void quitRequested();
    /// The colours of the desktop have changed.
    void desktopThemeChanged();

protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void addActions();
    void addStartPage();
    void addToolBars();
    void addStatusBar();
    void restoreWindow();
    void fitToScreen();
    void connectWorkspace();
    void showProject();
    void present(bool isOn);
    void updateStatusBar();
    void updateBondBar();
    int toolBarWidth() const;
    void measureToolBars();
    void updateToolButtonStyle();
    void applyPreferences();
    void updateTitle();
    void updateCounts();
    void updateBakeProgress(Id asset, double fraction);
    void showStatus(const QString& sentence);

    PreferenceStore& m_preferences;
    RecentFiles& m_recentFiles;
    Workspace m_workspace;
    QStackedWidget* m_pages = nullptr;  // start page and views
    Views* m_views = nullptr;
    FileActions* m_fileActions = nullptr;
    EditActions* m_editActions = nullptr;
    AssetActions* m_assetActions = nullptr;
    ViewActions* m_viewActions = nullptr;
    VideoActions* m_videoActions = nullptr;
    PlayActions* m_playActions = nullptr;
    QList<QToolBar*> m_toolBars;
    QList<QToolBar*> m_barsBeforePresenting;  // those that presenting hides
    QToolBar* m_bondBar = nullptr;            // one of m_toolBars
    QList<QToolBar*> m_labelledToolBars;      // those of play and tools, which show texts if there is room
    /// A button of theirs.
    struct LabelledButton {
        QToolButton* button = nullptr;
        int textWidth = 0;  // pixels that its text takes
    };
    QList<LabelledButton> m_labelledButtons;  // the most important first
    int m_labelledWidth = 0;                  // pixels that all toolbars need with texts; 0: not measured
    int m_plainWidth = 0;                     // and without
    bool m_isBlocked = false;                 // by a dialog or a task
    bool m_isDiscarding = false;              // closing without saving
    bool m_isFitted = false;                  // to the screen
    QLabel* m_hint = nullptr;
    QLabel* m_position = nullptr;
    QLabel* m_counts = nullptr;
    QLabel* m_readOnly = nullptr;
    QProgressBar* m_bakeProgress = nullptr;
    QToolButton* m_cancelBake = nullptr;
};

}  // namespace rubble
