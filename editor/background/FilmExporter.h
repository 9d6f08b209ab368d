#pragma once

#include "editor/document/jobs/BackgroundJob.h"
#include "editor/play/PlayEngine.h"
#include "viewport/film/Film.h"

#include <filesystem>
#include <memory>

namespace rubble {

/// A recorded session and how it is filmed.
struct FilmRequest {
    std::shared_ptr<const PlayScene> scene;
    PlayScript script;
    PlayOverlays overlays;
    FilmPlan plan;
    bool isCompared = false;     // without destruction on the left, with it on the right
    std::filesystem::path path;  // of the film (see isFilmPath()), or of the folder for its frames
};

/// Exports films in the background, one at a time: replays the recorded session and renders it without a display.
class FilmExporter : public QObject {
    Q_OBJECT
public:
    explicit FilmExporter(QObject* parent = nullptr);

    bool isBusy() const { return m_job.isRunning(); }
    /// Replaces a running export.
    void start(FilmRequest request);
    /// Cancels the export and deletes its files, as the destructor does.
    void cancel();

signals:
    /// isBusy() changed.
    void changed();
    /// The fraction of the film that is done, in [0, 1].
    void progressed(double fraction);
    void finished(const FilmRequest& request);
    void failed(const QString& sentence);

private:
    BackgroundJob m_job;
};

}  // namespace rubble
