#include "editor/document/Autosave.h"

#include "core/base/OutOfMemory.h"
#include "core/io/project/ProjectFile.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr const char* kDoing = "writing the backup";
constexpr std::size_t kMinJournalBytes = std::size_t{1} << 20;

}  // namespace

Result<Autosave::Written> Autosave::writeProject(const Backup& backup, const Project& project,
                                                 const TaskContext& task) {
    const std::string text = projectText(project);
    if (task.isCancelled()) return TaskContext::cancelled();
    if (const Status status = writeBackupMeshes(backup, project); !status) return status.error();
    if (const Status status = writeBackup(backup, QByteArray::fromStdString(text)); !status) return status.error();
    removeUnusedMeshes(backup, project);
    const ContentHash hash = contentHash(text);
    return Written{.text = hash, .textBytes = text.size(), .seal = hash};
}

Result<Autosave::Written> Autosave::writeRecord(const Backup& backup, const ProjectPart& part, Written before) {
    if (const Status status = writeBackupMeshes(backup, part.values); !status) return status.error();
    const bool isNew = before.journalBytes == 0;
    const std::string start = isNew ? journalStart(before.text) : std::string();
    const std::string record = start + journalRecord(part, before.seal);
    if (const Status status = appendToJournal(backup, record, isNew); !status) return status.error();
    before.journalBytes += record.size();
    return before;
}

Autosave::Autosave(const Document& document, const QString& folder, QObject* parent)
    : QObject(parent), m_document(document), m_backup(newBackup(folder)) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::writeInBackground);
    m_recordTimer.setSingleShot(true);
    m_recordTimer.setInterval(kJournalDelay);
    connect(&m_recordTimer, &QTimer::timeout, this, &Autosave::record);
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        m_unrecorded.note(changes);
        noteChange();
    });
    connect(&document, &Document::modifiedChanged, this,
            [this](bool isModified) { isModified ? noteChange() : discardBackup(); });
}

Autosave::~Autosave() {
    discardBackup();
    removeBackup(m_backup);
}

void Autosave::setInterval(std::chrono::seconds interval) {
    m_timer.stop();
    m_interval = interval;
    if (m_hasChange) schedule();
}

void Autosave::adopt(const Backup& backup) {
    stopWriting();
    removeBackup(m_backup);
    m_backup.path = backup.path;
    m_backup.lock = backup.lock;
    m_timer.stop();
    m_recordTimer.stop();
    m_hasChange = false;
    m_unrecorded.forget(m_document.project());
}

void Autosave::noteChange() {
    if (!m_hasChange) m_sinceChange.start();
    m_hasChange = true;
    if (!m_timer.isActive()) schedule();
    if (m_interval.count() > 0 && !m_hasFailed && !m_recordTimer.isActive()) m_recordTimer.start();
}

void Autosave::schedule() {
    const std::chrono::milliseconds elapsed{m_sinceChange.elapsed()};
    if (m_interval.count() > 0) m_timer.start(std::max(m_interval - elapsed, std::chrono::milliseconds(0)));
}

void Autosave::writeNow() {
    if (isWriting()) {  // what it would report is unknown
        stopWriting();
        m_hasChange = true;
    }
    if (!isBackupNeeded()) return;
    lockBackup(m_backup);
    m_hasChange = false;
    m_unrecorded.forget(m_document.project());
    finishWriting(orOutOfMemory(kDoing, [this] { return writeProject(m_backup, m_document.project(), {}); }));
}

/// Appends edits to the journal; writes the whole project where there is none, and where its journal got too long.
void Autosave::record() {
    if (isWriting() || !isBackupNeeded()) return;  // or once that is done
    if (m_written && m_unrecorded.isEmpty()) return;
    const bool isShort = m_written && m_written->journalBytes <= std::max(kMinJournalBytes, 2 * m_written->textBytes);
    if (!isShort || m_unrecorded.isEverything()) return writeInBackground();
    const Written before = *m_written;
    const Status started = orOutOfMemory(kDoing, [&] {
        m_job.start([target = Backup{.path = m_backup.path}, before, part = m_unrecorded.take(m_document.project())](
                        const TaskContext&) { return writeRecord(target, part, before); },
                    [this](const Result<Written>& written) { finishWriting(written); });
        return success();
    });
    if (!started) finishWriting(started.error());
}

/// Writes a copy of the project. Changes meanwhile are written once this is done.
void Autosave::writeInBackground() {
    if (!isBackupNeeded() || isWriting()) return;
    lockBackup(m_backup);
    const Status started = orOutOfMemory(kDoing, [this] {
        const Backup target{.path = m_backup.path, .origin = m_backup.origin};  // the lock stays here
        m_job.start([target, project = m_document.project()](
                        const TaskContext& task) { return writeProject(target, project, task); },
                    [this](const Result<Written>& written) { finishWriting(written); });
        m_unrecorded.forget(m_document.project());
        return success();
    });
    m_hasChange = false;
    if (!started) finishWriting(started.error());
}

void Autosave::finishWriting(const Result<Written>& written) {
    m_hasFailed = !written;
    m_written = written ? std::optional(*written) : std::nullopt;
    if (written) {
        if (m_hasChange && !m_timer.isActive()) schedule();
        if (m_interval.count() > 0 && !m_unrecorded.isEmpty()) m_recordTimer.start();
        return;
    }
    m_hasChange = true;
    if (m_interval.count() > 0) m_timer.start(m_interval);  // there may be room later
    emit failed(tr("The backup could not be written: %1").arg(QString::fromStdString(written.error().message)));
}

/// After this, no backup appears any more. What it would report is unknown: the next one is written as a whole.
void Autosave::stopWriting() {
    m_job.cancelAndWait();
    m_written.reset();
}

void Autosave::discardBackup() {
    m_timer.stop();
    m_recordTimer.stop();
    m_hasChange = false;
    stopWriting();
    m_unrecorded.forget(m_document.project());
    removeBackup(m_backup, BackupMeshes::Kept);
}

}  // namespace rubble

#include "moc_Autosave.cpp"
