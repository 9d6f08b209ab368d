#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "editor/document/Document.h"
#include "editor/document/ProjectLock.h"

#include <QFileSystemWatcher>

namespace rubble {

/// Where a document lies on disk: it opens and saves it, holds its lock and notices when somebody else writes the file.
class DocumentFile : public QObject {
    Q_OBJECT
public:
    explicit DocumentFile(Document& document, QObject* parent = nullptr);

    /// Empty until it was saved or opened.
    const QString& path() const { return m_path; }
    /// "house.rubble", or "Untitled".
    QString name() const;

    /// Puts a file's project into the document. On a fault all stays as it was.
    ///
    /// Errors: those of loadProject() and ProjectLock::take().
    Status open(const QString& path);
    /// Takes a restored backup for the document, unsaved, as what lies (or will lie) at `path`, which may be empty.
    Status restore(const QString& backupPath, const QString& path);
    /// Saves where it lies; path() is not empty.
    Status save();
    /// Saves elsewhere, and stays there.
    ///
    /// Errors: those of saveProject() and ProjectLock::take().
    Status saveAs(const QString& path);
    /// Reads the file again, whatever was changed here.
    Status reload() { return open(m_path); }

signals:
    void pathChanged(const QString& path);
    /// Another program has written the file, or removed it.
    void changedOnDisk();

private:
    Status take(Project project, const QString& path);
    Status write(const QString& path);
    void watch();
    void look();

    Document& m_document;
    QString m_path;
    std::shared_ptr<ProjectLock> m_lock;
    QFileSystemWatcher m_watcher;
    std::optional<ContentHash> m_onDisk;  // of the bytes that were read or written last
};

}  // namespace rubble
