#include "editor/document/ProjectAccess.h"

#include "core/io/project/ProjectLock.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>

namespace rubble {

namespace {

struct ProjectAccessTexts {
    Q_DECLARE_TR_FUNCTIONS(ProjectAccess)
};

QString timeText(std::chrono::system_clock::time_point time) {
    const QDateTime local = QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(time));
    return QLocale().toString(local, QLocale::ShortFormat);
}

QString orUnknown(const std::string& name, const QString& unknown) { return name.empty() ? unknown : nameText(name); }

}  // namespace

ProjectAccess accessProject(const QString& path, LockTakeover takeover) {
    LockAttempt attempt = lockProject(toPath(path), takeover);
    const QString name = fileNameText(path);
    ProjectAccess access{.lock = std::move(attempt.lock), .holder = std::move(attempt.holder)};
    if (access.holder) {
        access.readOnlyReason = ProjectAccessTexts::tr(
                                    "\"%1\" is read-only, because it is open in %2. Save it under "
                                    "another name.")
                                    .arg(name, holderText(*access.holder));
    } else if (!access.lock) {
        const QString folder = pathText(QFileInfo(path).absolutePath());
        access.readOnlyReason = ProjectAccessTexts::tr(
                                    "\"%1\" is read-only, because \"%2\" cannot be written to: %3. Save it to another "
                                    "folder.")
                                    .arg(name, folder, QString::fromStdString(attempt.reason));
    }
    return access;
}

QString holderText(const LockHolder& holder) {
    if (holder.isThisProcess) return ProjectAccessTexts::tr("another window");
    const QString program = orUnknown(holder.program, ProjectAccessTexts::tr("an unknown program"));
    const QString since = timeText(holder.since);
    if (holder.process <= 0) return ProjectAccessTexts::tr("%1 since %2").arg(program, since);
    return ProjectAccessTexts::tr("%1 on \"%2\" (user %3, process %4) since %5")
        .arg(program, orUnknown(holder.host, ProjectAccessTexts::tr("an unknown host")),
             orUnknown(holder.user, ProjectAccessTexts::tr("unknown")), QString::number(holder.process), since);
}

}  // namespace rubble
