#include "editor/window/Program.h"

#include "core/asset/project/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/actions/FileActions.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/document/Translations.h"
#include "editor/views/Views.h"
#include "editor/widgets/Theme.h"
#include "editor/window/MainWindow.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QTimer>

namespace rubble {

namespace {

QString backupQuestion(const Backup& backup) {
    const QString time = QLocale().toString(backup.time, QLocale::ShortFormat);
    if (backup.projectPath.isEmpty()) {
        return Program::tr(
                   "Rubble was not closed properly while an unsaved project was open. Restore its backup of %1?")
            .arg(time);
    }
    return Program::tr("Rubble was not closed properly while \"%1\" was open. Restore its backup of %2?")
        .arg(QDir::toNativeSeparators(backup.projectPath), time);
}

}  // namespace

Program::Program(QObject* parent) : QObject(parent), m_theme(m_preferences.preferences().theme) {
    installTranslations();
    applyTheme(m_theme);
    connect(&m_preferences, &PreferenceStore::changed, this, &Program::applyPreferences);
}

void Program::applyPreferences() {
    const ColourScheme theme = m_preferences.preferences().theme;
    if (std::exchange(m_theme, theme) != theme) applyTheme(theme);
}

void Program::start(const QStringList& files) {
    MainWindow* first = showStartPage();
    for (const QString& file : files) first->fileActions().openFile(file);
    QTimer::singleShot(0, this, &Program::offerBackups);  // once the window is shown
}

MainWindow* Program::createWindow(Project project) {
    auto* window = new MainWindow(std::move(project), m_preferences, m_recentFiles);
    window->setAttribute(Qt::WA_DeleteOnClose);
    connect(window, &MainWindow::newProjectRequested, this, [this] { showProject(emptyProject()); });
    connect(window, &MainWindow::openProjectRequested, this,
            [this, window](const QString& path) { open(path, window); });
    connect(window, &MainWindow::openCopyRequested, this,
            [this, window](const QString& path) { openCopy(path, window); });
    connect(window, &MainWindow::quitRequested, this, &Program::quit);
    return window;
}

MainWindow* Program::showProject(Project project) {
    MainWindow* window = createWindow(std::move(project));
    window->views().showProject();
    window->show();
    return window;
}

MainWindow* Program::showStartPage() {
    MainWindow* window = createWindow(emptyProject());
    window->show();
    return window;
}

MainWindow* Program::open(const QString& path, MainWindow* from) {
    if (MainWindow* window = windowWith(path)) {
        window->raise();
        window->activateWindow();
        return window;
    }
    MainWindow* window = windowFor(from);
    if (const Status opened = window->workspace().file().open(path); !opened) {
        showError(window, opened.error());
        return nullptr;
    }
    m_recentFiles.add(window->workspace().file().path());
    window->views().showProject();
    return window;
}

MainWindow* Program::openCopy(const QString& path, MainWindow* from) {
    MainWindow* window = windowFor(from);
    Result<Project> project = loadProject(path.toStdString());
    if (!project) {
        showError(window, project.error());
        return nullptr;
    }
    window->workspace().document().replace(std::move(*project));
    window->views().showProject();
    return window;
}

void Program::offerBackups() {
    for (const Backup& backup : orphanedBackups(backupFolder())) {
        enum Answer : std::size_t { kRestore, kDelete, kLater };
        const std::size_t answer = ask(nullptr, {.text = backupQuestion(backup),
                                                 .answers = {{tr("Restore"), QMessageBox::AcceptRole},
                                                             {tr("Delete Backup"), QMessageBox::DestructiveRole},
                                                             {tr("Ask Again Later"), QMessageBox::RejectRole}},
                                                 .defaultAnswer = kRestore});
        if (answer == kDelete) removeBackup(backup);
        if (answer == kRestore) restoreBackup(backup);
    }
}

void Program::restoreBackup(const Backup& backup) {
    MainWindow* window = showProject(emptyProject());
    if (const Status restored = window->workspace().file().restore(backup.path, backup.projectPath); !restored) {
        showError(window, restored.error());
        window->close();
        return;
    }
    window->workspace().autosave().writeNow();  // a backup of this process replaces the old one
    removeBackup(backup);
}

void Program::quit() {
    for (MainWindow* window : windows()) {
        if (!window->close()) return;
    }
}

MainWindow* Program::windowFor(MainWindow* from) { return from && from->isPristine() ? from : showStartPage(); }

MainWindow* Program::windowWith(const QString& path) const {
    const QFileInfo file(path);
    for (MainWindow* window : windows()) {
        const QString opened = window->workspace().file().path();
        if (!opened.isEmpty() && QFileInfo(opened) == file) return window;
    }
    return nullptr;
}

QList<MainWindow*> Program::windows() const {
    QList<MainWindow*> windows;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* window = qobject_cast<MainWindow*>(widget)) windows.append(window);
    }
    return windows;
}

}  // namespace rubble
