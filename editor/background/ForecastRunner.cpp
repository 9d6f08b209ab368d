#include "editor/background/ForecastRunner.h"

namespace rubble {

ForecastRunner::ForecastRunner(PlayController& controller, QObject* parent)
    : QObject(parent), m_controller(controller) {
    connect(&controller, &PlayController::forecastOrdered, this, &ForecastRunner::take);
    connect(&controller, &PlayController::stateChanged, this, [this] {
        if (m_controller.isInPlay()) return;
        m_job.cancel();
        m_running.reset();
        m_waiting.reset();
    });
}

void ForecastRunner::take(const std::shared_ptr<const ForecastOrder>& order) {
    if (m_job.isRunning() && m_running->thrown == order->thrown) {
        m_waiting = order;
    } else {
        start(order);
    }
}

void ForecastRunner::start(std::shared_ptr<const ForecastOrder> order) {
    m_running = order;
    m_waiting.reset();
    m_job.start(
        [this, order](const TaskContext& task, const BackgroundJob::Post& post) {
            return breakForecast(*order, task, [&](const std::vector<BodyForecast>& bodies) {
                post([this, order, bodies] { m_controller.showForecast(order->thrown, bodies); });
            });
        },
        [this, order](const Result<std::vector<BodyForecast>>& bodies) {
            if (bodies) m_controller.showForecast(order->thrown, *bodies);
            if (m_waiting) start(m_waiting);
        });
}

}  // namespace rubble

#include "moc_ForecastRunner.cpp"
