#include "editor/document/DocumentFile.h"

#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"

#include <QFileInfo>

namespace rubble {

namespace {

std::filesystem::path toPath(const QString& path) { return std::filesystem::path(path.toStdU16String()); }

std::optional<ContentHash> hashOnDisk(const QString& path) {
    const Result<std::string> bytes = readFile(toPath(path));
    if (!bytes) return std::nullopt;
    return contentHash(*bytes);
}

}  // namespace

DocumentFile::DocumentFile(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &DocumentFile::checkForChange);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &DocumentFile::checkForChange);
}

QString DocumentFile::name() const { return m_path.isEmpty() ? tr("Untitled") : QFileInfo(m_path).fileName(); }

Status DocumentFile::open(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    Result<Project> project = loadProject(toPath(absolute));
    if (!project) return project.error();
    return replaceDocument(std::move(*project), absolute);
}

Status DocumentFile::restore(const QString& backupPath, const QString& path) {
    Result<Project> project = loadProject(toPath(backupPath));
    if (!project) return project.error();
    const Status replaced = replaceDocument(std::move(*project), path);
    if (replaced) m_document.setUnsaved();
    return replaced;
}

Status DocumentFile::save() {
    const Status saved = write(m_path);
    if (saved) watch();  // saving renames a new file into place, which the watcher does not know
    return saved;
}

Status DocumentFile::saveAs(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (absolute == m_path) return save();
    const Result<std::shared_ptr<ProjectLock>> lock = ProjectLock::acquire(absolute);
    if (!lock) return lock.error();
    const Status saved = write(absolute);
    if (!saved) return saved;
    m_lock = *lock;
    m_path = absolute;
    watch();
    emit pathChanged(m_path);
    return success();
}

Status DocumentFile::write(const QString& path) {
    const Status saved = saveProject(toPath(path), m_document.project());
    if (!saved) return saved;
    m_onDisk = hashOnDisk(path);
    m_document.setSaved();
    return success();
}

/// Replaces the document's project; locks and watches its path if it has one.
Status DocumentFile::replaceDocument(Project project, const QString& path) {
    if (!path.isEmpty() && path != m_path) {
        const Result<std::shared_ptr<ProjectLock>> lock = ProjectLock::acquire(path);
        if (!lock) return lock.error();
        m_lock = *lock;
    }
    if (!path.isEmpty()) {
        m_path = path;
        m_onDisk = hashOnDisk(path);
        watch();
        emit pathChanged(m_path);
    }
    m_document.replace(std::move(project));
    return success();
}

void DocumentFile::watch() {
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty()) m_watcher.removePaths(watched);
    m_watcher.addPaths({m_path, QFileInfo(m_path).absolutePath()});
}

void DocumentFile::checkForChange() {
    const std::optional<ContentHash> now = hashOnDisk(m_path);
    if (!m_watcher.files().contains(m_path)) m_watcher.addPath(m_path);
    if (now == m_onDisk) return;
    m_onDisk = now;
    emit changedOnDisk();
}

}  // namespace rubble
