#include "editor/Program.h"

#include "core/asset/StarterProject.h"
#include "core/io/ProjectFile.h"
#include "editor/FileActions.h"
#include "editor/MainWindow.h"
#include "editor/Theme.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace rubble {

namespace {

void tell(QWidget* parent, const Error& error) {
    QMessageBox::warning(parent, QApplication::applicationDisplayName(), QString::fromStdString(error.message));
}

QString sentenceAbout(const Backup& backup) {
    const QString time = QLocale().toString(backup.time, QLocale::ShortFormat);
    if (backup.projectPath.isEmpty()) {
        return Program::tr(
                   "The program ended while a project that was never saved was being edited. Its backup is of %1.")
            .arg(time);
    }
    return Program::tr("The program ended while \"%1\" was being edited. Its backup is of %2.")
        .arg(QDir::toNativeSeparators(backup.projectPath), time);
}

}  // namespace

Program::Program(QObject* parent) : QObject(parent), m_preferences(readPreferences(QSettings())) {
    QCoreApplication::installTranslator(&m_plurals);
    applyTheme(m_preferences.theme);
}

void Program::setPreferences(const Preferences& preferences) {
    if (preferences == m_preferences) return;
    const bool isOtherTheme = preferences.theme != m_preferences.theme;
    m_preferences = preferences;
    QSettings settings;
    writePreferences(preferences, settings);
    if (isOtherTheme) applyTheme(preferences.theme);
    emit preferencesChanged();
}

void Program::start(const QStringList& files) {
    MainWindow* first = showNew(emptyProject(), false);
    for (const QString& file : files) first->fileActions().take(file);
    QTimer::singleShot(0, this, &Program::offerBackups);  // when the window is there to ask in
}

MainWindow* Program::showNew(Project project, bool isAtWork) {
    auto* window = new MainWindow(*this, std::move(project));
    window->setAttribute(Qt::WA_DeleteOnClose);
    if (isAtWork) window->showWork();
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
        tell(window, opened.error());
        return nullptr;
    }
    m_recentFiles.add(window->workspace().file().path());
    window->showWork();
    return window;
}

MainWindow* Program::openCopy(const QString& path, MainWindow* from) {
    MainWindow* window = windowFor(from);
    Result<Project> project = loadProject(path.toStdString());
    if (!project) {
        tell(window, project.error());
        return nullptr;
    }
    window->workspace().document().replace(std::move(*project));
    window->showWork();
    return window;
}

void Program::offerBackups() {
    for (const Backup& backup : leftBackups(backupFolder())) {
        QMessageBox box(QMessageBox::Question, QApplication::applicationDisplayName(), sentenceAbout(backup));
        QPushButton* restore = box.addButton(tr("Restore"), QMessageBox::AcceptRole);
        QPushButton* remove = box.addButton(tr("Delete backup"), QMessageBox::DestructiveRole);
        box.addButton(tr("Ask again later"), QMessageBox::RejectRole);
        box.setDefaultButton(restore);
        box.exec();
        if (box.clickedButton() == remove) removeBackup(backup);
        if (box.clickedButton() != restore) continue;
        MainWindow* window = showNew(emptyProject(), true);
        const Status restored = window->workspace().file().restore(backup.path, backup.projectPath);
        if (!restored) {
            tell(window, restored.error());
            window->close();
            continue;
        }
        window->workspace().autosave().writeNow();  // from now on this program's own
        removeBackup(backup);
    }
}

void Program::quit() {
    for (MainWindow* window : windows()) {
        if (!window->close()) return;
    }
}

QString Program::dataFolder() {
    const QDir program(QApplication::applicationDirPath());
    for (const char* folder : {"../share/rubble", "../../.."}) {
        if (program.exists(QString(folder) + "/projects")) return QDir::cleanPath(program.filePath(folder));
    }
    return program.path();
}

QStringList Program::examples() {
    QStringList paths;
    const QDir projects(dataFolder() + "/projects");
    for (const QFileInfo& file : projects.entryInfoList({"*.rubble"}, QDir::Files))
        paths.append(file.absoluteFilePath());
    return paths;
}

MainWindow* Program::windowFor(MainWindow* from) {
    return from && from->isPristine() ? from : showNew(emptyProject(), false);
}

MainWindow* Program::windowWith(const QString& path) const {
    const QFileInfo wanted(path);
    for (MainWindow* window : windows()) {
        const QString open = window->workspace().file().path();
        if (!open.isEmpty() && QFileInfo(open) == wanted) return window;
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
