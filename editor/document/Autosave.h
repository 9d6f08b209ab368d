#pragma once

#include "editor/document/Backup.h"
#include "editor/document/Document.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QElapsedTimer>
#include <QTimer>

#include <chrono>

namespace rubble {

/// Writes a backup of a changed document into a folder from time to time, in the background, never over the project
/// itself. The backup is removed when the document is saved or closed.
class Autosave : public QObject {
    Q_OBJECT
public:
    Autosave(const Document& document, const QString& folder, QObject* parent = nullptr);
    ~Autosave() override;

    /// The maximum time from a change to its backup, also of changes made before; zero or less disables backups.
    void setInterval(std::chrono::seconds interval);
    /// The document's file, stored with the backup.
    void setOrigin(const BackupOrigin& origin) { m_backup.origin = origin; }
    /// Takes over the backup that the document was restored from: it covers the document until the next one is wholly
    /// written, or the document saved or closed.
    void adopt(const Backup& backup);
    /// Writes changes that are not backed up yet, before it returns.
    void writeNow();
    /// A backup is being written in the background.
    bool isWriting() const { return m_job.isRunning(); }

signals:
    /// The newest backup could not be written; it is tried again after the interval.
    void failed(const QString& sentence);

private:
    void noteChange();
    void schedule();
    bool isBackupNeeded() const { return m_hasChange && m_document.isModified(); }
    void writeInBackground();
    void finishWriting(const Status& status);
    void stopWriting();
    void discardBackup();

    const Document& m_document;
    Backup m_backup;
    std::chrono::milliseconds m_interval{0};
    QTimer m_timer;
    bool m_hasChange = false;
    QElapsedTimer m_sinceChange;  // since the first one that is not backed up
    BackgroundJob m_job;
};

}  // namespace rubble
