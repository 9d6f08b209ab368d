#include "editor/document/DocumentFile.h"

#include "core/base/OutOfMemory.h"
#include "core/base/Utf8.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectIdentity.h"
#include "core/io/project/ProjectLock.h"
#include "core/io/system/AtomicFile.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"

#include <QFileInfo>

#include <utility>

namespace rubble {

namespace {

constexpr std::chrono::milliseconds kWatchDelay{100};
constexpr std::chrono::seconds kPollInterval{1};
constexpr std::chrono::milliseconds kClockPrecision{2000};  // of the coarsest file systems

/// The hash of a file, none if it does not exist.
///
/// Errors: those of readFile() but NotFound.
Result<std::optional<ContentHash>> hashOnDisk(const QString& path) {
    const Result<std::string> bytes = readFile(toPath(path));
    if (bytes) return std::optional(contentHash(*bytes));
    if (bytes.error().code == ErrorCode::NotFound) return std::optional<ContentHash>();
    return bytes.error();
}

struct ReadFile {
    Project project;
    ContentHash hash;
    std::vector<Diagnostic> notes;
};

Result<ReadFile> readProjectFile(const std::filesystem::path& path) {
    const Result<std::string> text = readFile(path);
    if (!text) return text.error();
    std::vector<Diagnostic> notes;
    Result<Project> project = readProjectText(*text, path, &notes);
    if (!project) return project.error();
    return ReadFile{std::move(*project), contentHash(*text), std::move(notes)};
}

}  // namespace

DocumentFile::DocumentFile(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    m_watchDelay.setSingleShot(true);
    m_watchDelay.setInterval(kWatchDelay);
    const auto checkSoon = [this] { m_watchDelay.start(); };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, checkSoon);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, checkSoon);
    connect(&m_watchDelay, &QTimer::timeout, this, &DocumentFile::checkForChange);
    m_poll.setInterval(kPollInterval);
    connect(&m_poll, &QTimer::timeout, this, &DocumentFile::checkForChange);
}

QString DocumentFile::name() const { return m_path.isEmpty() ? tr("Untitled") : fileNameText(m_path); }

Status DocumentFile::open(const QString& path) {
    const ProjectAccess access = accessProject(absolutePath(path));
    if (access.holder) return Error{ErrorCode::Io, access.readOnlyReason.toStdString()};
    return open(path, access);
}

Status DocumentFile::open(const QString& path, const ProjectAccess& access) {
    const QString absolute = absolutePath(path);
    Result<ReadFile> file = orOutOfMemory("opening the project", [&] { return readProjectFile(toPath(absolute)); });
    if (!file) return file.error();
    setFile({absolute, file->hash}, access);
    m_document.replace(std::move(file->project));
    if (!file->notes.empty()) emit noted(file->notes);
    return success();
}

Result<DocumentFile::Faults> DocumentFile::restore(const Backup& backup, const ProjectAccess& access) {
    BackupOrigin origin = backup.origin;
    if (!origin.hash) {  // there was no file, or it could not be read
        const Result<std::optional<ContentHash>> onDisk = hashOnDisk(origin.path);
        if (onDisk) origin.hash = *onDisk;
    }
    return restore(backup, origin, access);
}

Result<DocumentFile::Faults> DocumentFile::restoreHere(const Backup& backup) {
    return restore(backup, {m_path, backup.origin.hash ? backup.origin.hash : m_base}, m_access);
}

Result<DocumentFile::Faults> DocumentFile::restoreWithoutFile(const Backup& backup) {
    return restore(backup, BackupOrigin(), {});
}

Result<DocumentFile::Faults> DocumentFile::restore(const Backup& backup, const BackupOrigin& origin,
                                                   const ProjectAccess& access) {
    Result<RecoveredProject> recovered = orOutOfMemory(
        "restoring the backup", [&] { return recoverProject(toPath(backup.path), toPath(journalPath(backup))); });
    if (!recovered) return recovered.error();
    setFile(origin, access);
    m_document.replaceUnsaved(std::move(recovered->project));
    return std::move(recovered->faults);
}

Status DocumentFile::save() {
    if (isReadOnly()) return Error{ErrorCode::Io, m_access.readOnlyReason.toStdString()};
    const Status saved = write(m_path);
    if (saved) setFile({m_path, m_base}, m_access);
    return saved;
}

Status DocumentFile::saveAs(const QString& path) {
    return saveAs(path, isLockedHere(path) ? m_access : accessProject(absolutePath(path)));
}

bool DocumentFile::isLockedHere(const QString& path) const {
    if (!m_access.lock) return false;
    std::error_code ignored;  // hard links of our own file
    return m_access.lock->path() == lockPathOf(toPath(absolutePath(path))) ||
           std::filesystem::equivalent(toPath(m_path), toPath(path), ignored);
}

Status DocumentFile::saveAs(const QString& path, const ProjectAccess& access) {
    const QString absolute = absolutePath(path);
    if (access.isReadOnly()) return Error{ErrorCode::Io, access.readOnlyReason.toStdString()};
    const Status saved = write(absolute);
    if (saved) setFile({absolute, m_base}, ProjectAccess(access));  // which may be our own
    return saved;
}

/// Gives the project an identity where it has none, and another where it is saved beside its file as a copy. Returns
/// the former one.
std::string DocumentFile::identifyFor(const QString& path) {
    std::error_code ignored;  // another file, or none
    const std::string former = m_document.project().identity;
    const bool isCopy =
        !m_path.isEmpty() && path != m_path && !std::filesystem::equivalent(toPath(path), toPath(m_path), ignored);
    if (former.empty() || isCopy) m_document.setIdentity(newIdentity());
    return former;
}

Status DocumentFile::write(const QString& path) {
    const std::string formerIdentity = identifyFor(path);
    ContentHash written;
    const Status saved = orOutOfMemory("saving the project", [&]() -> Status {
        written = contentHash(projectText(m_document.project()));
        return saveProject(toPath(path), m_document.project());
    });
    if (!saved) {  // the file may be in place, but not flushed: that is no change by another program
        const Result<std::optional<ContentHash>> onDisk = hashOnDisk(path);
        if (path != m_path || !onDisk || *onDisk != written) {
            m_document.setIdentity(formerIdentity);
            return saved;
        }
        expect(written);
        emit originChanged({m_path, m_base});
        return saved;
    }
    m_base = written;
    m_document.setSaved();
    return success();
}

/// Takes over a path, its lock, and the content that later changes are based on; watches the path. Saving renames a new
/// file into place, which the watcher does not know.
void DocumentFile::setFile(const BackupOrigin& origin, const ProjectAccess& access) {
    m_path = origin.path;
    m_access = access;
    if (m_access.lock) m_access.lock->holdFile(toPath(m_path));
    expect(origin.hash);
    watch();
    emit pathChanged(m_path);
    emit originChanged(origin);
}

void DocumentFile::watch() {
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty()) m_watcher.removePaths(watched);
    m_poll.stop();
    if (m_path.isEmpty()) return;
    const bool isKnownToQt = isUtf8(toPath(m_path).native());
    if (!isKnownToQt) return m_poll.start();
    for (const QString& path : {m_path, QFileInfo(m_path).absolutePath()}) {
        if (QFileInfo::exists(path)) m_watcher.addPath(path);
    }
}

DocumentFile::Version DocumentFile::versionOf(const QString& path) {
    const QFileInfo file(path);
    if (!file.exists()) return {};
    return {file.size(), file.lastModified(), file.metadataChangeTime()};
}

/// Whether the file is certainly the one that was compared last: a change within the precision of the file system's
/// clock may not be seen. It is read only otherwise, since any change in its folder is a reason to ask.
bool DocumentFile::isKnownVersion() const {
    const Version version = versionOf(m_path);
    const bool isOld = version.changed.msecsTo(QDateTime::currentDateTime()) > kClockPrecision.count();
    return m_seen.hash && isOld && version == m_seen.version;
}

Result<DocumentFile::SeenFile> DocumentFile::seenFile(const QString& path) {
    const Version version = versionOf(path);  // first: what is written meanwhile is another version
    const Result<std::optional<ContentHash>> hash = hashOnDisk(path);
    if (!hash) return hash.error();
    return SeenFile{version, *hash};
}

/// From now on, this content is no change; a check that is running may have read an earlier one.
void DocumentFile::expect(const std::optional<ContentHash>& content) {
    m_check.cancel();
    m_base = content;
    m_seen = {.version = {}, .hash = content};
}

DiskState DocumentFile::diskState() {
    m_check.cancel();  // it may have read an earlier content
    const Result<SeenFile> file = seenFile(m_path);
    if (!file) return DiskState::Unreadable;
    m_seen = *file;
    return seenState();
}

DiskState DocumentFile::seenState() const {
    if (m_seen.hash == m_base) return DiskState::Unchanged;
    return m_seen.hash ? DiskState::Changed : DiskState::Deleted;
}

void DocumentFile::checkForChange() {
    if (!m_watcher.files().contains(m_path) && QFileInfo::exists(m_path)) m_watcher.addPath(m_path);
    if (isKnownVersion()) return;
    if (m_check.isRunning()) return m_watchDelay.start();  // it may have read the file before this change
    m_check.start([path = m_path](const TaskContext&) { return seenFile(path); },
                  [this](const Result<SeenFile>& file) { finishCheck(file); });
}

void DocumentFile::finishCheck(const Result<SeenFile>& file) {
    if (!file) return;
    const bool isOther = file->hash != std::exchange(m_seen, *file).hash;
    if (isOther && seenState() != DiskState::Unchanged) emit changedOnDisk();
}

}  // namespace rubble

#include "moc_DocumentFile.cpp"
