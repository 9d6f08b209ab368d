#include "editor/document/Autosave.h"

#include "core/base/OutOfMemory.h"
#include "core/io/project/ProjectFile.h"

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
    m_timer.setInterval(interval);
    if (m_hasChange) noteChange();
}

void Autosave::adopt(const Backup& backup) {
    removeBackup(m_backup);
    m_backup.path = backup.path;
    m_backup.lock = backup.lock;
    m_timer.stop();
    m_hasChange = false;
}

void Autosave::noteChange() {
    m_hasChange = true;
    if (m_timer.interval() > 0 && !m_timer.isActive()) m_timer.start();
}

void Autosave::writeNow() {
    if (!m_hasChange || !m_document.isModified()) return;
    lockBackup(m_backup);
    const Status status = orOutOfMemory("writing the backup", [&] {
        return writeBackup(m_backup, QByteArray::fromStdString(projectText(m_document.project())));
    });
    m_hasChange = !status;
    if (status) return;
    if (m_timer.interval() > 0) m_timer.start();  // there may be room later
    emit failed(tr("The backup could not be written: %1").arg(QString::fromStdString(status.error().message)));
}

void Autosave::discardBackup() {
    m_timer.stop();
    m_hasChange = false;
    removeBackup(m_backup);
}

}  // namespace rubble

#include "moc_Autosave.cpp"
