#pragma once

#include "editor/play/PlayEngine.h"
#include "viewport/film/Film.h"

#include <QObject>
#include <QThreadPool>

namespace rubble {

/// What was played, and how it is to be filmed.
struct FilmOrder {
    std::shared_ptr<const PlayScene> scene;
    PlayScript script;
    PlayOverlays overlays;
    FilmPlan plan;
    bool isCompared = false;      // nothing breaks on the left, all that is hit hard enough on the right
    std::filesystem::path place;  // a film's path (see isFilmPath), or the folder of its pictures
};

/// Films what was played, one film at a time, in the background: the play is played again and drawn without a display.
class FilmMaker : public QObject {
    Q_OBJECT
public:
    explicit FilmMaker(QObject* parent = nullptr);
    /// Cancels; nothing of an unfinished film stays.
    ~FilmMaker() override;

    bool isBusy() const { return m_isBusy; }
    /// Begins a film; what is being made is cancelled first.
    void make(FilmOrder order);
    /// Nothing of the film stays.
    void cancel();

signals:
    /// A film was begun, or is no longer being made.
    void changed();
    /// How much of it is done, in [0, 1].
    void progressed(double fraction);
    void finished(const FilmOrder& order);
    void failed(const QString& sentence);

private:
    void end(int film, const FilmOrder& order, const Status& made);

    QThreadPool m_thread;
    CancelToken m_cancel;
    int m_film = 0;  // what is of an earlier one comes too late
    bool m_isBusy = false;
};

}  // namespace rubble
