#include "editor/document/DocumentFile.h"

#include "core/io/AtomicFile.h"
#include "core/io/ProjectFile.h"

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
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &DocumentFile::look);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &DocumentFile::look);
}

QString DocumentFile::name() const { return m_path.isEmpty() ? tr("Untitled") : QFileInfo(m_path).fileName(); }

Status DocumentFile::open(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    Result<Project> project = loadProject(toPath(absolute));
    if (!project) return project.error();
    return take(std::move(*project), absolute);
}

Status DocumentFile::restore(const QString& backupPath, const QString& path) {
    Result<Project> project = loadProject(toPath(backupPath));
    if (!project) return project.error();
    const Status taken = take(std::move(*project), path);
    if (taken) m_document.setUnsaved();
    return taken;
}

Status DocumentFile::save() {
    const Status saved = write(m_path);
    if (saved) watch();  // the file was renamed into place: another one to watch
    return saved;
}

Status DocumentFile::saveAs(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (absolute == m_path) return save();
    const Result<std::shared_ptr<ProjectLock>> lock = ProjectLock::take(absolute);
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

/// Edits another project in place of the one before, and locks and watches its path if it has one.
Status DocumentFile::take(Project project, const QString& path) {
    if (!path.isEmpty() && path != m_path) {
        const Result<std::shared_ptr<ProjectLock>> lock = ProjectLock::take(path);
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

void DocumentFile::look() {
    const std::optional<ContentHash> now = hashOnDisk(m_path);
    if (!m_watcher.files().contains(m_path)) m_watcher.addPath(m_path);
    if (now == m_onDisk) return;
    m_onDisk = now;
    emit changedOnDisk();
}

}  // namespace rubble
