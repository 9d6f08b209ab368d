#pragma once

#include <QObject>
#include <QStringList>

namespace rubble {

/// The recently opened and saved projects, newest first, shared by all windows and kept in QSettings.
class RecentFiles : public QObject {
    Q_OBJECT
public:
    static constexpr int kMaxCount = 10;

    explicit RecentFiles(QObject* parent = nullptr);

    /// Returns the paths of the files that still exist.
    QStringList paths() const;
    void add(const QString& path);
    void clear();

signals:
    void changed();

private:
    void store();
    QStringList m_paths;
};

}  // namespace rubble
