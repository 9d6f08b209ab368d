#pragma once

#include "editor/document/Document.h"

#include <QDateTime>
#include <QLockFile>
#include <QTimer>

#include <chrono>
#include <vector>

namespace rubble {

/// A project that a program saved aside and then did not live to save or drop.
struct Backup {
    QString path;         // of the backup
    QString projectPath;  // what it is a backup of; empty where that was never saved
    QDateTime time;       // when it was written
};

/// Where backups lie: a folder of the user's own.
QString backupFolder();

/// The backups in a folder whose program has ended, newest first.
std::vector<Backup> leftBackups(const QString& folder);
/// Removes a backup and what belongs to it.
void removeBackup(const Backup& backup);

/// Saves a document aside every so often, if it was changed since, into a file of its own in a folder; never over the
/// project. The backup goes when the document is saved or closed.
class Autosave : public QObject {
    Q_OBJECT
public:
    Autosave(const Document& document, const QString& folder, QObject* parent = nullptr);
    ~Autosave() override;

    /// How long after a change it is saved, at the latest; zero or less: never.
    void setInterval(std::chrono::seconds interval);
    /// What the document is saved as, for who restores it.
    void setProjectPath(const QString& path) { m_projectPath = path; }
    /// Writes what has not been written yet.
    void writeNow();

signals:
    void failed(const QString& sentence);

private:
    void noteChange();
    void dropBackup();

    const Document& m_document;
    QString m_path;
    QString m_projectPath;
    QLockFile m_lock;
    QTimer m_timer;
    bool m_hasChange = false;
};

}  // namespace rubble
