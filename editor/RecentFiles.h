#pragma once

#include <QObject>
#include <QStringList>

namespace rubble {

/// The projects that were opened or saved last, newest first, shared by all windows; kept by QSettings.
class RecentFiles : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 10;

    explicit RecentFiles(QObject* parent = nullptr);

    /// Those that are still there.
    QStringList paths() const;
    void add(const QString& path);
    void clear();

signals:
    void changed();

private:
    void keep();
    QStringList m_paths;
};

}  // namespace rubble
