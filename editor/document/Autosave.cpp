#include "editor/document/Autosave.h"

#include "core/base/OutOfMemory.h"
#include "core/io/project/ProjectFile.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr const char* kDoing = "writing the backup";

Status writeProject(const Backup& backup, const Project& project, const TaskContext& task) {
    const std::string text = projectText(project);
    return task.isCancelled() ? success() : writeBackup(backup, QByteArray::fromStdString(text));
}

}  // namespace

Autosave::Autosave(const Document& document, const QString& folder, QObject* parent)
    : QObject(parent), m_document(document), m_backup(newBackup(folder)) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::writeInBackground);
    connect(&document, &Document::changed, this, &Autosave::noteChange);
    connect(&document, &Document::modifiedChanged, this,
            [this](bool isModified) { isModified ? noteChange() : discardBackup(); });
}

Autosave::~Autosave() { discardBackup(); }

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
    m_hasChange = false;
}

void Autosave::noteChange() {
    if (!m_hasChange) m_sinceChange.start();
    m_hasChange = true;
    if (!m_timer.isActive()) schedule();
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
    finishWriting(orOutOfMemory(kDoing, [this] { return writeProject(m_backup, m_document.project(), {}); }));
}

/// Writes a copy of the project. Changes meanwhile are written once this is done.
void Autosave::writeInBackground() {
    if (!isBackupNeeded() || isWriting()) return;
    lockBackup(m_backup);
    const Status started = orOutOfMemory(kDoing, [this] {
        const Backup target{.path = m_backup.path, .origin = m_backup.origin};  // the lock stays here
        m_job.start([target, project = m_document.project()](
                        const TaskContext& task) { return writeProject(target, project, task); },
                    [this](const Status& status) { finishWriting(status); });
        return success();
    });
    m_hasChange = false;
    if (!started) finishWriting(started);
}

void Autosave::finishWriting(const Status& status) {
    if (status) {
        if (m_hasChange) schedule();
        return;
    }
    m_hasChange = true;
    if (m_interval.count() > 0) m_timer.start(m_interval);  // there may be room later
    emit failed(tr("The backup could not be written: %1").arg(QString::fromStdString(status.error().message)));
}

/// After this, no backup appears any more.
void Autosave::stopWriting() { m_job.cancelAndWait(); }

void Autosave::discardBackup() {
    m_timer.stop();
    m_hasChange = false;
    stopWriting();
    removeBackup(m_backup);
}

}  // namespace rubble

#include "moc_Autosave.cpp"
