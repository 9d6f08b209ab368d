#include "editor/play/FilmMaker.h"

#include "core/io/FilmFile.h"

#include <QMetaObject>

#include <utility>

namespace rubble {

namespace {

Result<Take> takeOf(const FilmOrder& order, const SessionSettings& settings, std::vector<TimedInput> inputs) {
    Result<Session> session = Session::start(order.scene, settings);
    if (!session) return session.error();
    return Take(order.scene, std::move(*session), std::move(inputs), {.hasHulls = order.overlays.hasHulls},
                order.overlays);
}

/// As it was played; or the same twice, without destruction and with it, whatever was switched meanwhile.
Result<std::vector<Take>> takesOf(const FilmOrder& order) {
    SessionSettings settings = order.script.settings;
    std::vector<TimedInput> inputs = order.script.inputs;
    std::vector<Take> takes;
    const auto add = [&]() -> Status {
        Result<Take> take = takeOf(order, settings, inputs);
        if (!take) return take.error();
        takes.push_back(std::move(*take));
        return success();
    };
    if (order.isCompared) {
        std::erase_if(inputs,
                      [](const TimedInput& one) { return std::holds_alternative<DestructionInput>(one.input); });
        settings.hasDestruction = false;
        if (const Status added = add(); !added) return added.error();
        settings.hasDestruction = true;
    }
    if (const Status added = add(); !added) return added.error();
    return takes;
}

Status filmed(const FilmOrder& order, const TaskContext& task) {
    Result<std::vector<Take>> takes = takesOf(order);
    if (!takes) return takes.error();
    if (isFilmPath(order.place)) return filmFile(*takes, order.plan, order.place, task);
    return filmPictures(*takes, order.plan, order.place, Unfinished::Removed, task);
}

}  // namespace

FilmMaker::FilmMaker(QObject* parent) : QObject(parent) { m_thread.setMaxThreadCount(1); }

FilmMaker::~FilmMaker() {
    m_cancel.cancel();
    m_thread.waitForDone();
}

void FilmMaker::cancel() {
    m_cancel.cancel();
    ++m_film;
    if (std::exchange(m_isBusy, false)) emit changed();
}

void FilmMaker::make(FilmOrder order) {
    cancel();
    m_cancel = CancelToken();
    m_isBusy = true;
    emit changed();
    emit progressed(0.0);
    m_thread.start([this, film = m_film, order = std::move(order), cancel = m_cancel] {
        const auto inWindow = [this](auto work) { QMetaObject::invokeMethod(this, work); };
        TaskContext task{.cancel = cancel};
        task.progress = [this, film, inWindow](double fraction) {
            inWindow([this, film, fraction] {
                if (film == m_film) emit progressed(fraction);
            });
        };
        const Status made = filmed(order, task);
        inWindow([this, film, order, made] { end(film, order, made); });
    });
}

void FilmMaker::end(int film, const FilmOrder& order, const Status& made) {
    if (film != m_film) return;
    m_isBusy = false;
    emit changed();
    if (!made) return emit failed(QString::fromStdString(made.error().message));
    emit finished(order);
}

}  // namespace rubble
