#include "editor/document/Autosave.h"

#include "core/io/project/ProjectFile.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace rubble {

namespace {

constexpr const char* kBackupSuffix = ".rubble";
constexpr const char* kLockSuffix = ".lock";
constexpr const char* kOriginSuffix = ".json";  // names the project it backs up
constexpr const char* kProjectKey = "project";

QString withSuffix(const QString& backupPath, const char* suffix) {
    return backupPath.chopped(static_cast<int>(qstrlen(kBackupSuffix))) + suffix;
}

Status written(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit()) return success();
    return Error{ErrorCode::Io, ("\"" + path + "\": " + file.errorString() + ".").toStdString()};
}

QString projectOf(const QString& backupPath) {
    QFile file(withSuffix(backupPath, kOriginSuffix));
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QJsonDocument::fromJson(file.readAll()).object().value(kProjectKey).toString();
}

}  // namespace

QString backupFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/backups"; }

std::vector<Backup> orphanedBackups(const QString& folder) {
    std::vector<Backup> backups;
    for (const QFileInfo& file : QDir(folder).entryInfoList({QString("*") + kBackupSuffix}, QDir::Files)) {
        const QString path = file.absoluteFilePath();
        QLockFile lock(withSuffix(path, kLockSuffix));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0)) continue;  // its program is running
        backups.push_back({path, projectOf(path), file.lastModified()});
    }
    std::ranges::stable_sort(backups, [](const Backup& a, const Backup& b) { return a.time > b.time; });
    return backups;
}

void removeBackup(const Backup& backup) {
    for (const char* suffix : {kBackupSuffix, kOriginSuffix}) QFile::remove(withSuffix(backup.path, suffix));
}

Autosave::Autosave(const Document& document, const QString& folder, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_path(folder + '/' + QUuid::createUuid().toString(QUuid::WithoutBraces) + kBackupSuffix),
      m_lock(withSuffix(m_path, kLockSuffix)) {
    QDir().mkpath(folder);
    m_lock.setStaleLockTime(0);
    m_lock.tryLock(0);
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

void Autosave::noteChange() {
    m_hasChange = true;
    if (m_timer.interval() > 0 && !m_timer.isActive()) m_timer.start();
}

void Autosave::writeNow() {
    if (!m_hasChange || !m_document.isModified()) return;
    const QJsonObject origin{{kProjectKey, m_projectPath}};
    Status status = written(withSuffix(m_path, kOriginSuffix), QJsonDocument(origin).toJson());
    if (status) status = written(m_path, QByteArray::fromStdString(projectText(m_document.project())));
    m_hasChange = !status;
    if (!status)
        emit failed(tr("The backup could not be written: %1").arg(QString::fromStdString(status.error().message)));
}

void Autosave::discardBackup() {
    m_timer.stop();
    m_hasChange = false;
    removeBackup({m_path, {}, {}});
}

}  // namespace rubble
