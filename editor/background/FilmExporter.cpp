#include "editor/background/FilmExporter.h"

#include "core/io/media/FilmFile.h"

#include <utility>

namespace rubble {

namespace {

Result<SessionPlayback> playbackOf(const FilmRequest& request, const SessionSettings& settings,
                                   std::vector<TimedInput> inputs) {
    Result<Session> session = Session::start(request.scene, settings);
    if (!session) return session.error();
    return SessionPlayback(request.scene, std::move(*session), std::move(inputs),
                           {.hasHulls = request.overlays.hasHulls}, request.overlays);
}

/// The session as recorded; or, to compare, twice: without destruction and with it, whatever the recording switched.
Result<std::vector<SessionPlayback>> playbacksOf(const FilmRequest& request) {
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
                      [](const TimedInput& one) { return std::holds_alternative<DestructionInput>(one.input); });
        settings.hasDestruction = false;
        if (const Status added = add(); !added) return added.error();
        settings.hasDestruction = true;
    }
    if (const Status added = add(); !added) return added.error();
    return playbacks;
}

Status exportFilm(const FilmRequest& request, const TaskContext& task) {
    Result<std::vector<SessionPlayback>> playbacks = playbacksOf(request);
    if (!playbacks) return playbacks.error();
    if (isFilmPath(request.path)) return renderFilm(*playbacks, request.plan, request.path, task);
    return renderFrames(*playbacks, request.plan, request.path, Unfinished::Removed, task);
}

}  // namespace

FilmExporter::FilmExporter(QObject* parent) : QObject(parent) {
    connect(&m_job, &BackgroundJob::progressed, this, &FilmExporter::progressed);
}

void FilmExporter::cancel() {
    if (!isBusy()) return;
    m_job.cancel();
    emit changed();
}

void FilmExporter::start(FilmRequest request) {
    cancel();
    m_job.start([request](const TaskContext& task) { return exportFilm(request, task); },
                [this, request](const Status& status) {
                    emit changed();
                    status ? emit finished(request) : emit failed(QString::fromStdString(status.error().message));
                });
    emit changed();
    emit progressed(0.0);
}

}  // namespace rubble

#include "moc_FilmExporter.cpp"
