#pragma once

#include "editor/document/jobs/BackgroundJob.h"
#include "editor/play/PlayEngine.h"
#include "viewport/video/Video.h"

#include <filesystem>
#include <memory>

namespace rubble {

/// A session, recorded or yet to be played, and how it is rendered.
struct VideoRequest {
    std::shared_ptr<const PlayScene> scene;  // null: that of the project, which is baked first
    Project project;
    PlayScript script;
    PlayOverlays overlays;
    VideoPlan plan;
    bool isCompared = false;     // without destruction on the left, with it on the right
    std::filesystem::path path;  // of the video (see isVideoPath()), or of the folder for its frames
};

/// Exports videos in the background, one at a time: replays a recorded session, or plays a saved throw, and renders it
/// without a display.
class VideoExporter : public QObject {
    Q_OBJECT
public:
    explicit VideoExporter(QObject* parent = nullptr);

    bool isBusy() const { return m_job.isRunning(); }
    /// Replaces a running export.
    void start(VideoRequest request);
    /// Cancels the export and deletes its files, as the destructor does.
    void cancel();

signals:
    /// isBusy() changed.
    void changed();
    /// The fraction of the video that is done, in [0, 1].
    void progressed(double fraction);
    void finished(const VideoRequest& request);
    void failed(const QString& sentence);

private:
    BackgroundJob m_job;
};

}  // namespace rubble
