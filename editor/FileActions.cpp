#include "editor/FileActions.h"

#include "core/asset/StarterProject.h"
#include "core/io/MeshImport.h"
#include "editor/Action.h"
#include "editor/ExportDialog.h"
#include "editor/ImportDialog.h"
#include "editor/MainWindow.h"
#include "editor/Program.h"
#include "editor/Views.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

namespace rubble {

namespace {

const QStringList kMeshSuffixes = {"obj", "gltf", "glb", "fbx", "stl", "ply"};

}  // namespace

QString projectFilter() { return FileActions::tr("Rubble projects (*%1)").arg(kProjectSuffix); }

QString meshFilter() { return FileActions::tr("Meshes (%1)").arg("*." + kMeshSuffixes.join(" *.")); }

bool isMeshPath(const QString& path) { return kMeshSuffixes.contains(QFileInfo(path).suffix().toLower()); }

FileActions::FileActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("&File"), &window)) {
    const auto add = addingTo(*m_menu, this);
    m_new = add({"file-new", tr("&New"), tr("Start a new project"), QKeySequence::New}, &FileActions::newProject);
    m_open = add({"file-open", tr("&Open…"), tr("Open a project"), QKeySequence::Open}, &FileActions::open);
    m_recent = m_menu->addMenu(tr("Open &Recent"));
    connect(m_recent, &QMenu::aboutToShow, this, &FileActions::fillRecent);
    m_menu->addSeparator();
    m_save = add({"file-save", tr("&Save"), tr("Save the project"), QKeySequence::Save}, &FileActions::saveSlot);
    add({"file-save-as", tr("Save &As…"), tr("Save the project under another name"), QKeySequence("Ctrl+Shift+S")},
        &FileActions::saveAsSlot);
    m_revert =
        add({"file-revert", tr("Re&vert"), tr("Read the project from disk again, dropping what was changed since")},
            &FileActions::revert);
    m_menu->addSeparator();
    m_import = add(
        {"file-import", tr("&Import Mesh…"), tr("Make assets of the objects of a mesh file"), QKeySequence("Ctrl+I")},
        &FileActions::importSlot);
    m_export = add({"file-export", tr("&Export…"), tr("Choose what to write for other programs: packs, OBJ and GLB"),
                    QKeySequence("Ctrl+Shift+E")},
                   &FileActions::exportAs);
    m_exportAgain = add({"file-export-again", tr("Export A&gain"), tr("Export as it was done last for this project"),
                         QKeySequence("Ctrl+E")},
                        &FileActions::exportAgain);
    m_menu->addSeparator();
    add({"file-close", tr("&Close Window"), tr("Close this window"), QKeySequence::Close}, &FileActions::closeWindow);
    QAction* quit = makeAction(
        this, {"file-quit", tr("&Quit"), tr("Close all windows and end the program"), QKeySequence("Ctrl+Q")});
    connect(quit, &QAction::triggered, &window.program(), &Program::quit);
    m_menu->addAction(quit);

    const auto update = [this] {
        const bool isOnDisk = !m_window.workspace().file().path().isEmpty();
        m_revert->setEnabled(isOnDisk && m_window.workspace().document().isModified());
    };
    connect(&window.workspace().document(), &Document::modifiedChanged, this, update);
    connect(&window.workspace().file(), &DocumentFile::pathChanged, this, update);
    update();
}

QList<QAction*> FileActions::toolbarActions() const { return {m_new, m_open, m_save, m_import, m_export}; }

void FileActions::newProject() {
    if (m_window.isPristine()) return m_window.showWork();
    m_window.program().showNew(emptyProject(), true);
}

void FileActions::open() {
    const QString folder = QFileInfo(m_window.workspace().file().path()).path();
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open Project"), folder, projectFilter());
    if (!path.isEmpty()) take(path);
}

void FileActions::take(const QString& path) {
    if (isMeshPath(path)) return importMesh(path);
    m_window.program().open(path, &m_window);
}

bool FileActions::save() {
    if (m_window.workspace().file().path().isEmpty()) return saveAs();
    const Status saved = m_window.workspace().file().save();
    tell(saved);
    if (saved) m_window.say(tr("Saved %1.").arg(m_window.workspace().file().name()));
    return saved.hasValue();
}

bool FileActions::saveAs() {
    DocumentFile& file = m_window.workspace().file();
    QFileDialog dialog(&m_window, tr("Save Project"), QFileInfo(file.path()).path(), projectFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QString(kProjectSuffix).mid(1));
    dialog.selectFile(file.path().isEmpty() ? tr("untitled") + kProjectSuffix : file.name());
    if (dialog.exec() != QDialog::Accepted) return false;
    const Status saved = file.saveAs(dialog.selectedFiles().first());
    tell(saved);
    if (!saved) return false;
    m_window.program().recentFiles().add(file.path());
    m_window.say(tr("Saved %1.").arg(file.name()));
    return true;
}

void FileActions::revert() {
    QMessageBox box(
        QMessageBox::Warning, QApplication::applicationDisplayName(),
        tr("Read %1 again and drop what was changed since it was saved?").arg(m_window.workspace().file().name()),
        QMessageBox::Cancel, &m_window);
    QPushButton* drop = box.addButton(tr("Revert"), QMessageBox::DestructiveRole);
    box.exec();
    if (box.clickedButton() == drop) tell(m_window.workspace().file().reload());
}

bool FileActions::mayBeClosed() {
    if (!m_window.workspace().document().isModified()) return true;
    QMessageBox box(QMessageBox::Question, QApplication::applicationDisplayName(),
                    tr("Save the changes to %1?").arg(m_window.workspace().file().name()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box.setInformativeText(tr("What is not saved is lost."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
        case QMessageBox::Save: return save();
        case QMessageBox::Discard: return true;
        default: return false;
    }
}

void FileActions::importSlot() {
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Import Mesh"), {}, meshFilter());
    if (!path.isEmpty()) importMesh(path);
}

void FileActions::importMesh(const QString& path) {
    ImportDialog dialog(path, m_window.workspace().project(), m_window.program().preferences(), &m_window);
    const std::filesystem::path importer = importerBeside(QApplication::applicationDirPath().toStdString());
    if (!dialog.read(importer) || dialog.exec() != QDialog::Accepted) return;
    m_window.showWork();
    for (Message& message : dialog.messages()) m_window.views().messages().add(std::move(message));
    m_window.workspace().document().push(dialog.edit());
    m_window.workspace().selection().setAsset(dialog.firstAsset());
    m_window.say(tr("Imported %1.").arg(QFileInfo(path).fileName()));
}

void FileActions::exportAs() {
    ExportDialog dialog(m_window.workspace(), &m_window);
    if (dialog.exec() == QDialog::Accepted) exportWith(dialog.choice());
}

void FileActions::exportAgain() {
    const std::optional<ExportChoice> last = lastExport(m_window.workspace());
    const bool isNothingLeft = last && last->assets && last->assets->empty();
    if (!last || isNothingLeft) return exportAs();
    exportWith(*last);
}

void FileActions::exportWith(const ExportChoice& choice) {
    m_window.say(exported(m_window.workspace(), choice, m_window.views().messages(), &m_window));
}

void FileActions::closeWindow() { m_window.close(); }

void FileActions::fillRecent() {
    m_recent->clear();
    RecentFiles& recent = m_window.program().recentFiles();
    for (const QString& path : recent.paths()) {
        QAction* action = m_recent->addAction(QFileInfo(path).fileName(), this, [this, path] { take(path); });
        action->setStatusTip(QDir::toNativeSeparators(path));
    }
    if (m_recent->isEmpty()) m_recent->addAction(tr("Nothing was opened yet"))->setEnabled(false);
    m_recent->addSeparator();
    m_recent->addAction(tr("&Clear"), &recent, &RecentFiles::clear);
}

void FileActions::tell(const Status& status) {
    if (status) return;
    QMessageBox::warning(&m_window, QApplication::applicationDisplayName(),
                         QString::fromStdString(status.error().message));
}

}  // namespace rubble
