#pragma once

#include "editor/document/Backup.h"
#include "editor/document/Document.h"
#include "editor/document/UnrecordedEdits.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QElapsedTimer>
#include <QTimer>

#include <chrono>
#include <optional>

namespace rubble {

/// Writes a backup of a changed document into a folder, in the background, never over the project itself: soon after
/// the first change, then from time to time. Edits meanwhile are appended to its journal, so that a program that is
/// killed loses only what was done within kJournalDelay and the time that writing takes. The backup is removed when the
/// document is saved or closed.
class Autosave : public QObject {
    Q_OBJECT
public:
    Autosave(const Document& document, const QString& folder, QObject* parent = nullptr);
    ~Autosave() override;

    /// From an edit to its record in the journal.
    static constexpr std::chrono::milliseconds kJournalDelay{500};

    /// The maximum time from a change to a backup without a journal, also of changes made before; zero or less disables
    /// backups.
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
    /// A text that is on the disk, and its journal.
    struct Written {
        ContentHash text;
        std::size_t textBytes = 0;
        ContentHash seal;              // of the journal
        std::size_t journalBytes = 0;  // 0: there is none
    };

    void noteChange();
    void schedule();
    bool isBackupNeeded() const { return m_hasChange && m_document.isModified(); }
    void record();
    static Result<Written> writeProject(const Backup& backup, const Project& project, const TaskContext& task);
    static Result<Written> writeRecord(const Backup& backup, const ProjectPart& part, Written before);
    void writeInBackground();
    void finishWriting(const Result<Written>& written);
    void stopWriting();
    void discardBackup();

    const Document& m_document;
    Backup m_backup;
    std::chrono::milliseconds m_interval{0};
    QTimer m_timer;
    QTimer m_recordTimer;
    UnrecordedEdits m_unrecorded;
    std::optional<Written> m_written;  // none: the next record has to be a whole backup
    bool m_hasFailed = false;          // the last attempt; the next one waits for the interval
    bool m_hasChange = false;          // since the last backup, recorded or not
    QElapsedTimer m_sinceChange;       // since the first one that is not backed up
    BackgroundJob m_job;
};

}  // namespace rubble
