#include "editor/workspace/RecentFiles.h"

#include "editor/document/FilePath.h"

#include <QSettings>

namespace rubble {

namespace {

constexpr const char* kKey = "recentFiles";

QStringList storedPaths() {
    QStringList paths;
    for (const QVariant& path : QSettings().value(kKey).toList()) paths.append(pathOf(path));
    return paths;
}

}  // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent), m_paths(storedPaths()) {}

QStringList RecentFiles::paths() const {
    QStringList existing;
    for (const QString& path : m_paths) {
        if (is_regular_file(statusOf(path))) existing.append(path);
    }
    return existing;
}

void RecentFiles::add(const QString& path) {
    m_paths.removeAll(path);
    m_paths.prepend(path);
    m_paths.resize(std::min<qsizetype>(m_paths.size(), kMaxCount));
    store();
}

void RecentFiles::clear() {
    m_paths.clear();
    store();
}

void RecentFiles::store() {
    QVariantList paths;
    for (const QString& path : m_paths) paths.append(settingOf(path));
    QSettings().setValue(kKey, paths);
    emit changed();
}

}  // namespace rubble

#include "moc_RecentFiles.cpp"
