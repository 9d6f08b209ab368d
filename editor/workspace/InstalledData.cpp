#include "editor/workspace/InstalledData.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace rubble {

QString installedDataFolder() {
    const QDir program(QCoreApplication::applicationDirPath());
    for (const char* folder : {"../share/rubble", "../../.."}) {
        if (program.exists(QString(folder) + "/projects")) return QDir::cleanPath(program.filePath(folder));
    }
    return program.path();
}

QStringList exampleProjects() {
    QStringList paths;
    const QDir projects(installedDataFolder() + "/projects");
    for (const QFileInfo& file : projects.entryInfoList({"*.rubble"}, QDir::Files))
        paths.append(file.absoluteFilePath());
    return paths;
}

QString exampleTitle(const QString& path) {
    QString title = QFileInfo(path).completeBaseName().replace('-', ' ');
    title[0] = title[0].toUpper();
    return title;
}

QString demoProject() {
    const QFileInfo demo(installedDataFolder() + "/projects/house.rubble");
    return demo.isFile() ? demo.absoluteFilePath() : QString();
}

}  // namespace rubble
