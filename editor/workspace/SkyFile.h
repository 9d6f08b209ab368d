#pragma once

#include "editor/document/jobs/BackgroundJob.h"

#include <QString>

namespace rubble {

struct SkyLight;

/// Loads the sky of a view from a file, in the background.
class SkyFile : public QObject {
    Q_OBJECT
public:
    explicit SkyFile(QObject* parent = nullptr);

    /// The path of the file; empty: none.
    const QString& path() const { return m_path; }
    /// Loads another file; an empty path: none.
    void setPath(const QString& path);
    /// None before it is loaded, and where it cannot be.
    const std::shared_ptr<const SkyLight>& light() const { return m_light; }

signals:
    /// There is another light, or none any more.
    void lightChanged();
    /// The file cannot be read; the sentence says why, and what lights the scene.
    void failed(const QString& sentence);

private:
    QString m_path;
    std::shared_ptr<const SkyLight> m_light;
    BackgroundJob m_job;
};

}  // namespace rubble
