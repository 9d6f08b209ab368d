#pragma once

#include "editor/document/jobs/BackgroundJob.h"
#include "editor/play/PlayController.h"

namespace rubble {

/// Computes the forecasts that a play controller orders, in the background, and hands them back while they are refined.
/// The forecast of another throw replaces the running one; one of the same throw, for a scene that has moved, waits for
/// it.
class ForecastRunner : public QObject {
    Q_OBJECT
public:
    explicit ForecastRunner(PlayController& controller, QObject* parent = nullptr);

    bool isBusy() const { return m_job.isRunning(); }

private:
    void take(const std::shared_ptr<const ForecastOrder>& order);
    void start(std::shared_ptr<const ForecastOrder> order);

    PlayController& m_controller;
    BackgroundJob m_job;
    std::shared_ptr<const ForecastOrder> m_running;
    std::shared_ptr<const ForecastOrder> m_waiting;
};

}  // namespace rubble
