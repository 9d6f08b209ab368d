#include "editor/actions/FileActions.h"

#include "core/io/mesh/MeshImport.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/ProgramFolder.h"
#include "editor/actions/LockQuestion.h"
#include "editor/actions/PictureActions.h"
#include "editor/dialogs/ExportDialog.h"
#include "editor/dialogs/ExportOnSave.h"
#include "editor/dialogs/FileFilters.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/dialogs/OutputPath.h"
#include "editor/dialogs/import/ImportDialog.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/InstalledData.h"
#include "editor/workspace/PreferenceStore.h"
#include "editor/workspace/RecentFiles.h"
#include "editor/workspace/Workspace.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QStandardPaths>

namespace rubble {

namespace {

constexpr const char* kImportFolderKey = "import/folder";

}  // namespace

FileActions::FileActions(Views& views, const PreferenceStore& preferences, RecentFiles& recentFiles)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_preferences(preferences),
      m_recentFiles(recentFiles),
      m_exportOnSave(new ExportOnSave(m_workspace, views.messages(), this)),
      m_menu(new QMenu(tr("&File"), &views.window())) {
    const auto add = actionAdder(*m_menu, this);
    m_new =
        add({"file-new", tr("&New"), tr("Create a new project"), QKeySequence::New}, &FileActions::newProjectRequested);
    m_open = add({"file-open", tr("&Open…"), tr("Open an existing project"), QKeySequence::Open},
                 &FileActions::openWithDialog);
    m_recent = m_menu->addMenu(tr("Open &Recent"));
    connect(m_recent, &QMenu::aboutToShow, this, &FileActions::fillRecent);
    addExamples();
    m_menu->addSeparator();
    m_save = add({"file-save", tr("&Save"), tr("Save the project"), QKeySequence::Save}, &FileActions::saveTriggered);
    add({"file-save-as", tr("Save &As…"), tr("Save the project to another file"), QKeySequence("Ctrl+Shift+S")},
        &FileActions::saveAsTriggered);
    m_revert = add({"file-revert", tr("Re&vert"), tr("Reload the project as last saved")}, &FileActions::revert);
    m_menu->addSeparator();
    m_import = add({"file-import", tr("&Import Mesh…"), tr("Import the objects from a mesh file as assets"),
                    QKeySequence("Ctrl+I")},
                   &FileActions::importWithDialog);
    m_export = add({"file-export", tr("&Export…"), tr("Export packs and meshes for engines and other programs"),
                    QKeySequence("Ctrl+E")},
                   &FileActions::exportWithDialog);
    m_exportAgain =
        add({"file-export-again", tr("Export A&gain"),
             tr("Repeat all exports of this project, to each of their folders"), QKeySequence("Ctrl+Shift+E")},
            &FileActions::exportAgain);
    m_menu->addAction((new PictureActions(views))->action());
    m_menu->addSeparator();
    add({"file-close", tr("&Close Window"), tr("Close this window"), QKeySequence::Close}, &FileActions::closeWindow);
    add({"file-quit", tr("&Quit"), tr("Close all windows and quit"), QKeySequence("Ctrl+Q")},
        &FileActions::quitRequested);
    connect(&m_workspace.document(), &Document::modifiedChanged, this, &FileActions::updateEnabled);
    connect(&m_workspace.document(), &Document::changed, this, &FileActions::updateEnabled);
    connect(&m_workspace.file(), &DocumentFile::pathChanged, this, &FileActions::updateEnabled);
    connect(m_exportOnSave, &ExportOnSave::finished, this, [this](const QString& text) { m_views.showStatus(text); });
    connect(&m_workspace.file(), &DocumentFile::changedOnDisk, this, &FileActions::askAboutChangeOnDisk);
    updateEnabled();
}

/// Copies of the installed examples.
void FileActions::addExamples() {
    const QStringList paths = exampleProjects();
    if (paths.isEmpty()) return;
    QMenu* examples = m_menu->addMenu(tr("Exam&ples"));
    examples->setObjectName("file-examples");
    for (const QString& path : paths) {
        QAction* action = examples->addAction(exampleTitle(path));
        action->setStatusTip(tr("Open a copy of this example"));
        connect(action, &QAction::triggered, this, [this, path] { emit exampleRequested(path); });
    }
}

QList<QAction*> FileActions::toolbarActions() const { return {m_new, m_open, m_save, m_import, m_export}; }

void FileActions::updateEnabled() {
    m_revert->setEnabled(!m_workspace.file().path().isEmpty() && m_workspace.document().isModified());
    for (QAction* action : {m_export, m_exportAgain}) action->setEnabled(!m_workspace.project().assets.empty());
}

/// The folder of the project, or of the project used last.
QString FileActions::folder() const {
    if (!m_workspace.file().path().isEmpty()) return QFileInfo(m_workspace.file().path()).path();
    const QStringList recent = m_recentFiles.paths();
    if (!recent.isEmpty()) return QFileInfo(recent.front()).path();
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void FileActions::openWithDialog() {
    const QString path = QFileDialog::getOpenFileName(&m_views.window(), tr("Open Project"), folder(), projectFilter());
    if (!path.isEmpty()) openFile(path);
}

void FileActions::openFile(const QString& path) {
    if (isMeshPath(path)) {
        importMesh(path);
        return;
    }
    emit openProjectRequested(path);
}

bool FileActions::save() {
    DocumentFile& file = m_workspace.file();
    if (file.isReadOnly()) m_views.showStatus(file.readOnlyReason());
    if (file.path().isEmpty() || file.isReadOnly()) return saveAs();
    const DiskState state = file.diskState();
    if (state == DiskState::Unreadable) return saveOverUnreadable();
    return state == DiskState::Changed ? saveOverChange() : saveTo(file.path());
}

/// Asks whether to overwrite a file that another program made unreadable.
bool FileActions::saveOverUnreadable() {
    DocumentFile& file = m_workspace.file();
    enum Answer : std::size_t { kSaveAs, kOverwrite, kCancel };
    const Result<std::string> bytes = readFile(toPath(file.path()));
    const QString reason = bytes ? QString() : QString::fromStdString(bytes.error().message) + ' ';
    m_isAskingAboutDisk = true;
    const std::size_t answer =
        ask(&m_views.window(),
            {.text = tr("\"%1\" was changed by another program, and cannot be compared.").arg(file.name()),
             .informativeText = reason + tr("Overwriting it discards what is there now."),
             .answers = {{tr("Save As…"), QMessageBox::AcceptRole},
                         {tr("Overwrite"), QMessageBox::DestructiveRole},
                         {tr("Cancel"), QMessageBox::RejectRole}},
             .defaultAnswer = kSaveAs});
    m_isAskingAboutDisk = false;
    if (answer == kSaveAs) return saveAs();
    return answer == kOverwrite && saveTo(file.path());
}

/// Asks whether to overwrite a file that another program changed.
bool FileActions::saveOverChange() {
    DocumentFile& file = m_workspace.file();
    enum Answer : std::size_t { kSaveAs, kCompare, kOverwrite, kCancel };
    m_isAskingAboutDisk = true;
    const std::size_t answer =
        ask(&m_views.window(), {.text = tr("\"%1\" was changed by another program.").arg(file.name()),
                                .informativeText = tr("Overwriting it discards what the other program saved."),
                                .answers = {{tr("Save As…"), QMessageBox::AcceptRole},
                                            {tr("Compare"), QMessageBox::AcceptRole},
                                            {tr("Overwrite"), QMessageBox::DestructiveRole},
                                            {tr("Cancel"), QMessageBox::RejectRole}},
                                .defaultAnswer = kSaveAs});
    m_isAskingAboutDisk = false;
    if (answer == kCompare) emit compareRequested();
    if (answer == kSaveAs) return saveAs();
    return answer == kOverwrite && saveTo(file.path());
}

/// The name of the file; of a read-only project, which cannot be saved to it, a free name in the same folder.
QString FileActions::suggestedName() const {
    const DocumentFile& file = m_workspace.file();
    if (file.path().isEmpty()) return tr("untitled") + kProjectSuffix;
    const QFileInfo info(file.path());
    if (!file.isReadOnly()) return info.fileName();
    return QFileInfo(unusedPath(info.absolutePath(), tr("%1 copy").arg(info.completeBaseName()), kProjectSuffix))
        .fileName();
}

bool FileActions::saveAs() {
    DocumentFile& file = m_workspace.file();
    QFileDialog dialog(&m_views.window(), tr("Save Project"), folder(), projectFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QString(kProjectSuffix).mid(1));
    dialog.selectFile(suggestedName());
    if (dialog.exec() != QDialog::Accepted) return false;
    const QString path = dialog.selectedFiles().first();
    if (const QString fault = outputFault(path, {}, {kProjectSuffix}); !fault.isEmpty()) {
        showError(&m_views.window(), fault);
        return false;
    }
    if (!saveTo(path)) return false;
    m_recentFiles.add(file.path());
    m_views.showProject();  // of a start page
    return true;
}

bool FileActions::saveTo(const QString& path) {
    DocumentFile& file = m_workspace.file();
    const std::optional<ProjectAccess> access =
        file.isLockedHere(path) ? file.access() : askToSave(absolutePath(path), &m_views.window());
    if (!access) return false;
    const Status saved = file.saveAs(path, *access);
    showIfError(&m_views.window(), saved);
    if (!saved) return false;
    m_exportOnSave->start();
    const QString text = m_exportOnSave->isRunning() ? tr("Saved %1. Exporting…") : tr("Saved %1.");
    m_views.showStatus(text.arg(file.name()));
    return true;
}

void FileActions::revert() {
    const QString question =
        tr("Discard all changes to \"%1\" since it was last saved?").arg(m_workspace.file().name());
    if (!confirmLoss(&m_views.window(), question, tr("Revert"), tr("Cancel"))) return;
    showIfError(&m_views.window(), m_workspace.file().reload());
}

void FileActions::askAboutChangeOnDisk() {
    if (m_isAskingAboutDisk) {
        m_hasChangedMeanwhile = true;
        return;
    }
    m_isAskingAboutDisk = true;
    do {
        m_hasChangedMeanwhile = false;
        const DiskState state = m_workspace.file().seenState();
        if (state == DiskState::Changed) askAboutChange();
        if (state == DiskState::Deleted) askAboutDeletion();
    } while (m_hasChangedMeanwhile);
    m_isAskingAboutDisk = false;
}

/// Unless the answer is Reload, the next save asks again before it overwrites the file.
void FileActions::askAboutChange() {
    const bool isModified = m_workspace.document().isModified();
    enum Answer : std::size_t { kSaveAs, kCompare, kReload, kKeep };
    const std::size_t answer =
        ask(&m_views.window(), {.text = tr("\"%1\" was changed by another program.").arg(m_workspace.file().name()),
                                .informativeText = isModified ? tr("Reloading it discards your unsaved changes.")
                                                              : tr("You have no unsaved changes."),
                                .answers = {{tr("Save As…"), QMessageBox::AcceptRole},
                                            {tr("Compare"), QMessageBox::AcceptRole},
                                            {tr("Reload"), QMessageBox::DestructiveRole},
                                            {tr("Keep Current Version"), QMessageBox::RejectRole}},
                                .defaultAnswer = isModified ? kSaveAs : kReload});
    if (answer == kReload) {
        const Status reloaded = m_workspace.file().reload();
        showIfError(&m_views.window(), reloaded);
        if (reloaded) return;
    }
    m_workspace.document().setUnsaved();
    if (answer == kSaveAs) saveAs();
    if (answer == kCompare) emit compareRequested();
}

void FileActions::askAboutDeletion() {
    m_workspace.document().setUnsaved();
    const Question question{
        .text = tr("\"%1\" was deleted by another program.").arg(m_workspace.file().name()),
        .informativeText = tr("The project is still open here. Saving it creates the file again."),
        .answers = {{tr("Save As…"), QMessageBox::AcceptRole}, {tr("Keep Current Version"), QMessageBox::RejectRole}},
        .defaultAnswer = 1};
    if (ask(&m_views.window(), question) == 0) saveAs();
}

bool FileActions::confirmClose() {
    if (!confirmLosingChanges()) return false;
    m_exportOnSave->complete(&m_views.window());
    return true;
}

bool FileActions::confirmLosingChanges() {
    if (!m_workspace.document().isModified()) return true;
    enum Answer : std::size_t { kSave, kDiscard, kCancel };
    const std::size_t answer =
        ask(&m_views.window(), {.text = tr("Save changes to \"%1\"?").arg(m_workspace.file().name()),
                                .informativeText = tr("Unsaved changes will be lost."),
                                .answers = {{tr("Save"), QMessageBox::AcceptRole},
                                            {tr("Discard"), QMessageBox::DestructiveRole},
                                            {tr("Cancel"), QMessageBox::RejectRole}},
                                .defaultAnswer = kSave});
    return answer == kSave ? save() : answer == kDiscard;
}

void FileActions::importWithDialog() {
    const QString last = pathOf(QSettings().value(kImportFolderKey));
    const QString from = QFileInfo(last).isDir() ? last : folder();
    const QStringList paths = QFileDialog::getOpenFileNames(&m_views.window(), tr("Import Mesh"), from, meshFilter());
    if (paths.isEmpty()) return;
    QSettings().setValue(kImportFolderKey, settingOf(QFileInfo(paths.first()).absolutePath()));
    for (const QString& path : paths) {
        if (!importMesh(path)) return;
    }
}

bool FileActions::importMesh(const QString& path) {
    ImportDialog dialog(path, m_workspace.project(), m_preferences.preferences(), &m_views.window());
    const std::filesystem::path importer = importerPath(programFolder());
    if (!dialog.read(importer)) return true;
    if (dialog.exec() != QDialog::Accepted) return false;
    m_views.showProject();
    for (Message& message : dialog.messages()) m_views.messages().add(std::move(message));
    if (!m_workspace.document().push(dialog.edit())) return true;
    const std::vector<Id> assets = dialog.assets();
    m_workspace.selection().setAsset(assets.front());
    m_views.frameInstancesOf(assets);
    m_views.showStatus(tr("Imported %1.").arg(fileNameText(path)));
    return true;
}

void FileActions::exportWithDialog() {
    ExportDialog dialog(m_workspace, &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    const ExportOptions options = dialog.options();
    const ExportSummary summary = exportWith(options);
    if (summary.isExported && summary.assetErrors.isEmpty()) {
        offerFolder(&m_views.window(), summary.sentence, options.folder);
    }
}

void FileActions::exportAgain() {
    std::vector<ExportOptions> targets = earlierExports(m_workspace);
    std::erase_if(targets, [](const ExportOptions& target) { return target.assets && target.assets->empty(); });
    if (targets.size() > 1)
        std::erase_if(targets, [](const ExportOptions& target) { return !QFileInfo::exists(target.folder); });
    if (targets.empty()) return exportWithDialog();
    QStringList sentences;
    for (const ExportOptions& target : targets) sentences += exportWith(target).sentence;
    m_views.showStatus(sentences.join(' '));
}

ExportSummary FileActions::exportWith(const ExportOptions& options) {
    m_exportOnSave->cancel();
    const ExportSummary summary = exportProject(m_workspace, options, m_views.messages(), &m_views.window());
    m_views.showStatus(summary.sentence);
    return summary;
}

void FileActions::closeWindow() { m_views.window().close(); }

void FileActions::fillRecent() {
    m_recent->clear();
    for (const QString& path : m_recentFiles.paths()) {
        QAction* action = m_recent->addAction(menuText(fileNameText(path)), this, [this, path] { openFile(path); });
        action->setStatusTip(pathText(path));
    }
    if (m_recent->isEmpty()) m_recent->addAction(tr("No Recent Projects"))->setEnabled(false);
    m_recent->addSeparator();
    m_recent->addAction(tr("&Clear Recent Projects"), &m_recentFiles, &RecentFiles::clear);
}

}  // namespace rubble

#include "moc_FileActions.cpp"
