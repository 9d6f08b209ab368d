#include "editor/window/Program.h"

#include "core/asset/library/StarterProject.h"
#include "core/base/OutOfMemory.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectLock.h"
#include "editor/actions/FileActions.h"
#include "editor/actions/LockQuestion.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/document/FilePath.h"
#include "editor/document/Translations.h"
#include "editor/views/Views.h"
#include "editor/widgets/ColourScheme.h"
#include "editor/widgets/ScreenFit.h"
#include "editor/window/Application.h"
#include "editor/window/MainWindow.h"

#include <QApplication>
#include <QDir>
#include <QLocale>
#include <QScreen>
#include <QTimer>

#include <algorithm>

namespace rubble {

namespace {

bool isFolderGone(const Backup& backup) {
    std::error_code error;
    return !std::filesystem::is_directory(toPath(backup.origin.path).parent_path(), error);
}

QString backupQuestion(const Backup& backup) {
    const QString time = QLocale().toString(backup.time, QLocale::ShortFormat);
    if (backup.origin.path.isEmpty()) {
        return Program::tr(
                   "Rubble was not closed properly while an unsaved project was open. Restore its backup of %1?")
            .arg(time);
    }
    return Program::tr("Rubble was not closed properly while \"%1\" was open. Restore its backup of %2?")
        .arg(QDir::toNativeSeparators(backup.origin.path), time);
}

QString backupNote(const Backup& backup) {
    if (backup.holder) {
        return Program::tr(
                   "The backup belongs to %1. Rubble cannot tell whether that program is still running. Take the "
                   "backup over only if it has ended.")
            .arg(holderText(*backup.holder));
    }
    if (backup.origin.path.isEmpty() || !isFolderGone(backup)) return {};
    return Program::tr("The folder of the project no longer exists. Save the restored project to another one.");
}

}  // namespace

Program::Program(QObject* parent) : QObject(parent), m_theme(m_preferences.preferences().theme) {
    installTranslations();
    applyTheme(m_theme);
    connect(&m_preferences, &PreferenceStore::changed, this, &Program::applyPreferences);
    if (auto* application = qobject_cast<Application*>(QCoreApplication::instance()))
        connect(application, &Application::ranOut, this, &Program::tellRanOut);
}

void Program::applyPreferences() {
    const ColourScheme theme = m_preferences.preferences().theme;
    if (std::exchange(m_theme, theme) != theme) applyTheme(theme);
}

void Program::backUp() {
    for (MainWindow* window : windows()) window->workspace().autosave().writeNow();
}

/// Memory or threads have run out: backs up what could be lost, and says so in every window.
void Program::tellRanOut(const QString& sentence) {
    backUp();
    for (MainWindow* window : windows()) window->views().showRefusal(sentence);
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
    connect(window, &MainWindow::playDemoRequested, this, [this, window](const QString& path) {
        if (MainWindow* opened = openCopy(path, window)) opened->playDemo();
    });
    connect(window, &MainWindow::quitRequested, this, &Program::quit);
    connect(window, &MainWindow::desktopThemeChanged, this, [this] {
        if (m_theme == ColourScheme::System) applyTheme(m_theme);
    });
    cascade(*window);
    return window;
}

/// Moves a window that is not shown yet, so that it does not lie exactly over another one.
void Program::cascade(MainWindow& window) const {
    QList<QRect> shown;
    const MainWindow* last = nullptr;
    for (const MainWindow* other : windows()) {
        if (other == &window || !other->isVisible() || other->isMaximized() || other->isFullScreen()) continue;
        shown.append(other->geometry());
        if (last == nullptr || other->isActiveWindow()) last = other;
    }
    if (last == nullptr || window.isMaximized() || window.isFullScreen()) return;
    window.setGeometry(
        cascaded(window.size(), window.minimumSize(), last->geometry(), shown, last->screen()->availableGeometry()));
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
    const std::optional<ProjectAccess> access = askForAccess(absolutePath(path), from);
    if (!access) return nullptr;
    MainWindow* window = windowFor(from);
    if (const Status opened = window->workspace().file().open(path, *access); !opened) {
        discardUnlessShown(window);
        showError(from, opened.error());
        return nullptr;
    }
    m_recentFiles.add(window->workspace().file().path());
    showOpened(*window);
    return window;
}

/// Shows the project of a window, and why it is read-only if it is.
void Program::showOpened(MainWindow& window) {
    window.views().showProject();
    window.show();
    const DocumentFile& file = window.workspace().file();
    if (file.isReadOnly()) window.views().showStatus(file.readOnlyReason());
}

MainWindow* Program::openCopy(const QString& path, MainWindow* from) {
    std::vector<Diagnostic> notes;
    Result<Project> project = orOutOfMemory("opening the project", [&] { return loadProject(toPath(path), &notes); });
    if (!project) {
        showError(from, project.error());
        return nullptr;
    }
    MainWindow* window = windowFor(from);
    window->workspace().document().replace(std::move(*project));
    window->views().showProject();
    window->show();
    window->views().addNotes(notes);
    return window;
}

void Program::offerBackups() {
    for (Backup& backup : orphanedBackups(backupFolder())) {
        if (backup.holder) {
            offerForeignBackup(backup);
            continue;
        }
        enum Answer : std::size_t { kRestore, kDelete, kLater };
        const std::size_t answer = ask(nullptr, {.text = backupQuestion(backup),
                                                 .informativeText = backupNote(backup),
                                                 .answers = {{tr("Restore"), QMessageBox::AcceptRole},
                                                             {tr("Delete Backup"), QMessageBox::DestructiveRole},
                                                             {tr("Ask Again Later"), QMessageBox::RejectRole}},
                                                 .defaultAnswer = kRestore});
        if (answer == kDelete) removeBackup(backup);
        if (answer == kRestore) restoreBackup(backup);
    }
}

/// Offers a backup of a program that may be running: on another computer, or on this one before it was set up anew.
void Program::offerForeignBackup(Backup& backup) {
    enum Answer : std::size_t { kTakeOver, kLater };
    const std::size_t answer = ask(nullptr, {.text = backupQuestion(backup),
                                             .informativeText = backupNote(backup),
                                             .answers = {{tr("Take Over and Restore"), QMessageBox::DestructiveRole},
                                                         {tr("Ask Again Later"), QMessageBox::RejectRole}},
                                             .defaultAnswer = kLater});
    if (answer == kTakeOver && takeOverBackup(backup)) restoreBackup(backup);
}

/// Restores a backup into the window that has its project open; if there is none, into a window of its own. The backup
/// stays until the project is saved.
void Program::restoreBackup(const Backup& backup) {
    const bool hasFile = !backup.origin.path.isEmpty() && !isFolderGone(backup);
    MainWindow* opened = hasFile ? windowWith(backup.origin.path) : nullptr;
    std::optional<ProjectAccess> access;
    if (hasFile && !opened) {
        access = askForAccess(backup.origin.path, nullptr);
        if (!access) return;
    }
    const bool isFree = opened && !opened->workspace().document().isModified();
    MainWindow* window = isFree ? opened : windowFor(pristineWindow());
    DocumentFile& file = window->workspace().file();
    const Result<DocumentFile::Faults> restored = isFree   ? file.restoreHere(backup)
                                                  : access ? file.restore(backup, *access)
                                                           : file.restoreWithoutFile(backup);
    if (!restored) {
        discardUnlessShown(window);
        return showError(QApplication::activeWindow(), restored.error());
    }
    window->workspace().autosave().adopt(backup);
    showOpened(*window);
    showFaults(*window, *restored);
}

/// Shows what is out of range in a restored project; each fault is a message.
void Program::showFaults(MainWindow& window, const DocumentFile::Faults& faults) {
    if (faults.empty()) return;
    for (const std::string& fault : faults)
        window.views().messages().add({.severity = Severity::Error, .text = QString::fromStdString(fault)});
    window.views().showStatus(
        tr("Values of the restored project are out of range. Change them as the messages say, then save."));
}

/// Asks one question for all windows. Saves their projects if that is the answer; then nothing is left to be asked.
Program::Unsaved Program::askForUnsaved(const QList<MainWindow*>& modified) {
    QStringList names;
    for (MainWindow* window : modified) names << window->workspace().file().name();
    enum Answer : std::size_t { kSaveAll, kReview, kDiscardAll, kCancel };
    const std::size_t answer =
        ask(modified.front(), {.text = tr("Save the changes to these projects?") + "\n\n" + names.join('\n'),
                               .informativeText = tr("Unsaved changes will be lost."),
                               .answers = {{tr("Save All"), QMessageBox::AcceptRole},
                                           {tr("Ask for Each"), QMessageBox::AcceptRole},
                                           {tr("Discard All"), QMessageBox::DestructiveRole},
                                           {tr("Cancel"), QMessageBox::RejectRole}},
                               .defaultAnswer = kSaveAll});
    if (answer == kDiscardAll) return Unsaved::Discard;
    if (answer == kReview) return Unsaved::Ask;
    if (answer == kCancel) return Unsaved::Cancel;
    const bool areSaved =
        std::ranges::all_of(modified, [](MainWindow* window) { return window->fileActions().save(); });
    return areSaved ? Unsaved::Ask : Unsaved::Cancel;
}

/// Closes windows once all may be closed; the other ones, such as the manual, after those with projects.
void Program::quit() {
    QList<MainWindow*> modified = windows();
    modified.removeIf([](MainWindow* window) { return !window->workspace().document().isModified(); });
    const Unsaved unsaved = modified.size() > 1 ? askForUnsaved(modified) : Unsaved::Ask;
    if (unsaved == Unsaved::Cancel) return;
    for (MainWindow* window : windows()) {
        if (!(unsaved == Unsaved::Discard ? window->confirmStop() : window->confirmClose())) return;
    }
    for (MainWindow* window : windows()) {
        if (!window->closeWithoutSaving()) return;
    }
    QApplication::closeAllWindows();
}

/// A window for a project: `from` if it is untouched, otherwise a new one, which is not shown yet.
MainWindow* Program::windowFor(MainWindow* from) {
    return from && from->isUntouched() ? from : createWindow(emptyProject());
}

void Program::discardUnlessShown(MainWindow* window) {
    if (!window->isVisible()) delete window;
}

MainWindow* Program::windowWith(const QString& path) const {
    const std::filesystem::path lock = lockPathOf(toPath(path));
    for (MainWindow* window : windows()) {
        const QString opened = window->workspace().file().path();
        if (opened.isEmpty()) continue;
        std::error_code ignored;  // hard links
        const bool isSame = std::filesystem::equivalent(toPath(opened), toPath(path), ignored);
        if (isSame || lockPathOf(toPath(opened)) == lock) return window;
    }
    return nullptr;
}

MainWindow* Program::pristineWindow() const {
    const QList<MainWindow*> all = windows();
    const auto found = std::ranges::find_if(all, &MainWindow::isPristine);
    return found == all.end() ? nullptr : *found;
}

QList<MainWindow*> Program::windows() const {
    QList<MainWindow*> windows;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* window = qobject_cast<MainWindow*>(widget)) windows.append(window);
    }
    return windows;
}

}  // namespace rubble

#include "moc_Program.cpp"
