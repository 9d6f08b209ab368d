#pragma once

#include "core/base/Result.h"
#include "editor/document/Backup.h"
#include "editor/document/Document.h"
#include "editor/document/ProjectAccess.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QTimer>

namespace rubble {

/// A file compared with what was loaded from it or saved to it last.
enum class DiskState {
    Unchanged,
    Changed,
    Deleted,
    Unreadable,  // it is too large, may not be read or is no file at all
};

/// The file of a document: opens and saves it, holds its lock, and watches for changes by other programs.
class DocumentFile : public QObject {
    Q_OBJECT
public:
    explicit DocumentFile(Document& document, QObject* parent = nullptr);

    /// Empty until the document has been opened or saved.
    const QString& path() const { return m_path; }
    /// The name of the file: "house.rubble", or "Untitled".
    QString name() const;
    /// Whether the file can only be saved to another path.
    bool isReadOnly() const { return !m_path.isEmpty() && m_access.isReadOnly(); }
    /// The right to write to the file.
    const ProjectAccess& access() const { return m_access; }
    const QString& readOnlyReason() const { return m_access.readOnlyReason; }

    /// Loads a file into the document. On an error nothing changes.
    ///
    /// Errors: those of readFile() and readProjectText(); Limit if memory runs out; Io if another process holds the
    /// lock: the message names it.
    Status open(const QString& path);
    /// The same with access to the path that the caller has, which may be read-only.
    Status open(const QString& path, const ProjectAccess& access);
    /// What is out of range in a backup, as sentences. Until it is mended, the project cannot be saved.
    using Faults = std::vector<std::string>;
    /// Loads a backup into the document, unsaved, as the project that it was made of.
    ///
    /// Errors: those of recoverProject().
    Result<Faults> restore(const Backup& backup, const ProjectAccess& access);
    /// Loads a backup into the document, unsaved, as the project that is open, or as one without a file.
    Result<Faults> restoreHere(const Backup& backup);
    Result<Faults> restoreWithoutFile(const Backup& backup);
    /// Saves to path(), which must not be empty, whatever is on the disk.
    ///
    /// Errors: those of saveProject(); Limit if memory runs out; Io if the file is read-only.
    Status save();
    /// Saves to another path, which becomes path().
    ///
    /// Errors: those of saveProject(); Io if the path cannot be locked.
    Status saveAs(const QString& path);
    /// The same with access to the path that the caller has.
    Status saveAs(const QString& path, const ProjectAccess& access);
    /// Whether a path is that of the file or of a link to it, and the file is locked.
    bool isLockedHere(const QString& path) const;
    /// Loads the file again and discards unsaved changes.
    Status reload() { return open(m_path, m_access); }

    /// Reads the file; changedOnDisk() does not report the same content again, nor a file that cannot be read.
    DiskState diskState();
    /// The file when it was last read: by diskState(), or in the background before changedOnDisk(). Never Unreadable.
    DiskState seenState() const;

signals:
    /// The path or the right to write to it.
    void pathChanged(const QString& path);
    /// The path, or the content of the file that later changes are based on.
    void originChanged(const rubble::BackupOrigin& origin);
    /// Another program wrote or removed the file.
    void changedOnDisk();
    /// Parts of the file that was loaded were left out; see readProjectText().
    void noted(const std::vector<rubble::Diagnostic>& notes);

private:
    /// What changes when a file is written or replaced.
    struct Version {
        qint64 size = -1;  // -1: there is no file
        QDateTime written, changed;
        bool operator==(const Version&) const = default;
    };
    struct SeenFile {
        Version version;
        std::optional<ContentHash> hash;  // none: there was no file
    };
    static Version versionOf(const QString& path);
    static Result<SeenFile> seenFile(const QString& path);
    Result<Faults> restore(const Backup& backup, const BackupOrigin& origin, const ProjectAccess& access);
    void expect(const std::optional<ContentHash>& content);
    void setFile(const BackupOrigin& origin, const ProjectAccess& access);
    std::string identifyFor(const QString& path);
    Status write(const QString& path);
    void watch();
    void checkForChange();
    bool isKnownVersion() const;
    void finishCheck(const Result<SeenFile>& file);

    Document& m_document;
    QString m_path;
    ProjectAccess m_access;
    QFileSystemWatcher m_watcher;
    QTimer m_watchDelay;                // other programs remove and write in several steps
    QTimer m_poll;                      // of a path that Qt cannot watch
    std::optional<ContentHash> m_base;  // of the file that was loaded or saved last; none: there was no file
    SeenFile m_seen;                    // when it was last compared
    BackgroundJob m_check;              // reads the file after a change
};

}  // namespace rubble
