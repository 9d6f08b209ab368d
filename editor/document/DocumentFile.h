#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "editor/document/Document.h"
#include "editor/document/ProjectLock.h"

#include <QFileSystemWatcher>

namespace rubble {

/// The file of a document: opens and saves it, holds its lock, and watches for changes by other programs.
class DocumentFile : public QObject {
    Q_OBJECT
public:
    explicit DocumentFile(Document& document, QObject* parent = nullptr);

    /// Empty until the document has been opened or saved.
    const QString& path() const { return m_path; }
    /// The name of the file: "house.rubble", or "Untitled".
    QString name() const;

    /// Loads a file into the document. On an error nothing changes.
    ///
    /// Errors: those of loadProject() and ProjectLock::acquire().
    Status open(const QString& path);
    /// Loads a backup into the document, unsaved, as the project at `path`; empty: a project that was never saved.
    Status restore(const QString& backupPath, const QString& path);
    /// Saves to path(), which must not be empty.
    Status save();
    /// Saves to another path, which becomes path().
    ///
    /// Errors: those of saveProject() and ProjectLock::acquire().
    Status saveAs(const QString& path);
    /// Loads the file again and discards unsaved changes.
    Status reload() { return open(m_path); }

signals:
    void pathChanged(const QString& path);
    /// Another program wrote or removed the file.
    void changedOnDisk();

private:
    Status replaceDocument(Project project, const QString& path);
    Status write(const QString& path);
    void watch();
    void checkForChange();

    Document& m_document;
    QString m_path;
    std::shared_ptr<ProjectLock> m_lock;
    QFileSystemWatcher m_watcher;
    std::optional<ContentHash> m_onDisk;  // of the bytes last read or written
};

}  // namespace rubble
