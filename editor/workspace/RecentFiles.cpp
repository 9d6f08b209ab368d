#include "editor/workspace/RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

namespace rubble {

namespace {
constexpr const char* kKey = "recentFiles";
}

RecentFiles::RecentFiles(QObject* parent) : QObject(parent), m_paths(QSettings().value(kKey).toStringList()) {}

QStringList RecentFiles::paths() const {
    QStringList existing;
    for (const QString& path : m_paths) {
        if (QFileInfo(path).isFile()) existing.append(path);
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
    QSettings().setValue(kKey, m_paths);
    emit changed();
}

}  // namespace rubble

#include "moc_RecentFiles.cpp"
