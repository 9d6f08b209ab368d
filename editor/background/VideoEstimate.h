#pragma once

#include "editor/document/jobs/BackgroundJob.h"
#include "viewport/render/Renderer.h"

#include <memory>
#include <optional>

namespace rubble {

/// Measures in the background how long a frame of a video takes.
class VideoEstimate : public QObject {
    Q_OBJECT
public:
    explicit VideoEstimate(QObject* parent = nullptr);

    /// Measures a frame of a scene; an earlier measurement is dropped.
    void measure(const std::shared_ptr<const RenderScene>& scene, const RenderView& view, int samples);
    bool isMeasuring() const { return m_job.isRunning(); }
    /// s; none before it is measured, and where nothing can be rendered.
    std::optional<double> secondsPerFrame() const { return m_secondsPerFrame; }

signals:
    /// secondsPerFrame() or isMeasuring() changed.
    void changed();

private:
    std::optional<double> m_secondsPerFrame;
    BackgroundJob m_job;
};

}  // namespace rubble
