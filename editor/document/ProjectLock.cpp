#include "editor/document/ProjectLock.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace rubble {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("ProjectLock", text); }

Error refusal(const QLockFile& file, const QString& projectPath) {
    const QString name = QFileInfo(projectPath).fileName();
    if (file.error() != QLockFile::LockFailedError) {
        const QString folder = QFileInfo(projectPath).absolutePath();
        return {ErrorCode::Io,
                tr("\"%1\" cannot be locked: the folder \"%2\" cannot be written to.").arg(name, folder).toStdString()};
    }
    qint64 process = 0;
    QString host, program;
    if (!file.getLockInfo(&process, &host, &program)) {
        return {ErrorCode::Io, tr("\"%1\" is open in another program.").arg(name).toStdString()};
    }
    return {ErrorCode::Io, tr("\"%1\" is already open in %2 on %3, process %4. Close it there first.")
                               .arg(name, program, host)
                               .arg(process)
                               .toStdString()};
}

}  // namespace

QString lockPathOf(const QString& projectPath) {
    const QFileInfo file(projectPath);
    const QString canonical = file.canonicalFilePath();  // symbolic links to one file share a lock
    const QFileInfo real(canonical.isEmpty() ? file.absoluteFilePath() : canonical);
    return real.absolutePath() + "/." + real.fileName() + ".lock";
}

Result<std::shared_ptr<ProjectLock>> ProjectLock::acquire(const QString& projectPath) {
    const std::shared_ptr<ProjectLock> lock(new ProjectLock(lockPathOf(projectPath)));
    lock->m_file.setStaleLockTime(0);  // a lock is stale only once its process has ended
    if (!lock->m_file.tryLock(0)) return refusal(lock->m_file, projectPath);
    return lock;
}

}  // namespace rubble
