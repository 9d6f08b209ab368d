#pragma once

#include "editor/document/Document.h"

#include <QDateTime>
#include <QLockFile>
#include <QTimer>

#include <chrono>
#include <vector>

namespace rubble {

/// A backup whose program ended without saving or discarding its changes.
struct Backup {
    QString path;         // of the backup
    QString projectPath;  // the project it backs up; empty if that was never saved
    QDateTime time;       // when it was written
};

/// The user's folder for backups.
QString backupFolder();

/// The backups in a folder whose program has ended, newest first.
std::vector<Backup> orphanedBackups(const QString& folder);
/// Removes a backup and its description.
void removeBackup(const Backup& backup);

/// Writes a backup of a changed document into a folder from time to time, never over the project itself. The backup is
/// removed when the document is saved or closed.
class Autosave : public QObject {
    Q_OBJECT
public:
    Autosave(const Document& document, const QString& folder, QObject* parent = nullptr);
    ~Autosave() override;

    /// The maximum time from a change to its backup; zero or less disables backups.
    void setInterval(std::chrono::seconds interval);
    /// The path of the document's file, stored with the backup.
    void setProjectPath(const QString& path) { m_projectPath = path; }
    /// Writes changes that are not backed up yet.
    void writeNow();

signals:
    void failed(const QString& sentence);

private:
    void noteChange();
    void discardBackup();

    const Document& m_document;
    QString m_path;
    QString m_projectPath;
    QLockFile m_lock;
    QTimer m_timer;
    bool m_hasChange = false;
};

}  // namespace rubble
