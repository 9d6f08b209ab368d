#pragma once

#include "editor/Workspace.h"

#include <QMainWindow>

class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolBar;

namespace rubble {

class AssetActions;
class EditActions;
class FileActions;
class FragmentActions;
class HelpActions;
class InstanceActions;
class MaterialActions;
class PlayActions;
class Program;
class SelectActions;
class ViewActions;
class Views;

/// A window with one project: menus, toolbars, docks, the pattern canvas and the 3D view; or the start page, as long as
/// there is nothing to show.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow(Program& program, Project project);
    ~MainWindow() override;

    Workspace& workspace() { return m_workspace; }
    Program& program() { return m_program; }
    Views& views() { return *m_views; }
    FileActions& fileActions() { return *m_fileActions; }
    AssetActions& assetActions() { return *m_assetActions; }

    /// Nothing was opened or edited in it yet: another project may take its place.
    bool isPristine() const;
    /// Leaves the start page.
    void showWork();
    /// One sentence for a while in the status bar.
    void say(const QString& sentence);

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeToolBars();
    void nameTools();
    void makeStatusBar();
    void updateTitle();
    void updateCounts();
    void showProgress(Id asset, double fraction);
    void askAboutChangeOnDisk();

    Program& m_program;
    Workspace m_workspace;
    QStackedWidget* m_pages = nullptr;
    Views* m_views = nullptr;
    FileActions* m_fileActions = nullptr;
    EditActions* m_editActions = nullptr;
    SelectActions* m_selectActions = nullptr;
    AssetActions* m_assetActions = nullptr;
    FragmentActions* m_fragmentActions = nullptr;
    InstanceActions* m_instanceActions = nullptr;
    MaterialActions* m_materialActions = nullptr;
    ViewActions* m_viewActions = nullptr;
    PlayActions* m_playActions = nullptr;
    HelpActions* m_helpActions = nullptr;
    QList<QToolBar*> m_toolBars;
    QList<QToolBar*> m_namedBars;  // of play and tools
    int m_namedWidth = 0;          // pixels that all bars need with names
    QLabel* m_hint = nullptr;
    QLabel* m_place = nullptr;
    QLabel* m_counts = nullptr;
    QProgressBar* m_progress = nullptr;
    QWidget* m_cancelBake = nullptr;
    bool m_isShowingWork = false;
};

}  // namespace rubble
