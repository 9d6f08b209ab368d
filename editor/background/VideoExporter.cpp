#include "editor/background/VideoExporter.h"

#include "core/io/media/VideoFile.h"

#include <utility>

namespace rubble {

namespace {

constexpr double kBakingFraction = 0.05;  // of the time of an export, if there is no scene yet

Result<SessionPlayback> playbackOf(const VideoRequest& request, const SessionSettings& settings,
                                   std::vector<TimedInput> inputs) {
    Result<Session> session = Session::start(request.scene, settings);
    if (!session) return session.error();
    return SessionPlayback(request.scene, std::move(*session), std::move(inputs),
                           {.hasHulls = request.overlays.hasHulls}, request.overlays);
}

/// The session as recorded; or, to compare, twice: without destruction and with it, whatever the recording switched.
Result<std::vector<SessionPlayback>> playbacksOf(const VideoRequest& request) {
    SessionSettings settings = request.script.settings;
    std::vector<TimedInput> inputs = request.script.inputs;
    std::vector<SessionPlayback> playbacks;
    const auto add = [&]() -> Status {
        Result<SessionPlayback> playback = playbackOf(request, settings, inputs);
        if (!playback) return playback.error();
        playbacks.push_back(std::move(*playback));
        return success();
    };
    if (request.isCompared) {
        std::erase_if(inputs,
                      [](const TimedInput& timed) { return std::holds_alternative<DestructionInput>(timed.input); });
        settings.hasDestruction = false;
        if (const Status added = add(); !added) return added.error();
        settings.hasDestruction = true;
    }
    if (const Status added = add(); !added) return added.error();
    return playbacks;
}

Status exportVideo(VideoRequest request, TaskContext task) {
    if (!request.scene) {
        Result<std::shared_ptr<const PlayScene>> scene = playScene(request.project, task.stage(0.0, kBakingFraction));
        if (!scene) return scene.error();
        request.scene = std::move(*scene);
        task = task.stage(kBakingFraction, 1.0);
    }
    Result<std::vector<SessionPlayback>> playbacks = playbacksOf(request);
    if (!playbacks) return playbacks.error();
    if (isVideoPath(request.path)) return renderVideo(*playbacks, request.plan, request.path, task);
    return renderFrames(*playbacks, request.plan, request.path, Unfinished::Removed, task);
}

}  // namespace

VideoExporter::VideoExporter(QObject* parent) : QObject(parent) {
    connect(&m_job, &BackgroundJob::progressed, this, &VideoExporter::progressed);
}

void VideoExporter::cancel() {
    if (!isBusy()) return;
    m_job.cancel();
    emit changed();
}

void VideoExporter::start(VideoRequest request) {
    cancel();
    m_job.start([request](const TaskContext& task) { return exportVideo(request, task); },
                [this, request](const Status& status) {
                    emit changed();
                    status ? emit finished(request) : emit failed(QString::fromStdString(status.error().message));
                });
    emit changed();
    emit progressed(0.0);
}

}  // namespace rubble

#include "moc_VideoExporter.cpp"
