#include "editor/document/Autosave.h"

#include "core/base/OutOfMemory.h"
#include "core/io/project/ProjectFile.h"

#include <algorithm>

namespace rubble {

Autosave::Autosave(const Document& document, const QString& folder, QObject* parent)
    : QObject(parent), m_document(document), m_backup(newBackup(folder)) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::writeNow);
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
    if (!m_hasChange || !m_document.isModified()) return;
    lockBackup(m_backup);
    const Status status = orOutOfMemory("writing the backup", [&] {
        return writeBackup(m_backup, QByteArray::fromStdString(projectText(m_document.project())));
    });
    m_hasChange = !status;
    if (status) return;
    if (m_interval.count() > 0) m_timer.start(m_interval);  // there may be room later
    emit failed(tr("The backup could not be written: %1").arg(QString::fromStdString(status.error().message)));
}

void Autosave::discardBackup() {
    m_timer.stop();
    m_hasChange = false;
    removeBackup(m_backup);
}

}  // namespace rubble

#include "moc_Autosave.cpp"
