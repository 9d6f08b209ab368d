#include "core/play/analysis/Forecast.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

constexpr double kRefinementTime = 0.25;  // s

/// The hardest impacts so far, by body.
class ImpactRecord {
public:
    /// Records the last step of a session. Bodies from number `end` on were born in the forecast and do not count.
    void record(const PlayEvents& events, std::uint32_t end) {
        for (const PlayImpact& impact : events.impacts) {
            if (impact.body < end) keepLarger(impact.body, std::min(impact.damage / impact.threshold, kLargestWhole));
        }
        for (const PlayBreak& broken : events.breaks) {
            if (broken.body.number < end)
                keepLarger(broken.body.number, std::max(broken.impact / broken.threshold, 1.0));
        }
        for (const PlaySplit& split : events.splits) {
            if (split.body.number < end) keepLarger(split.body.number, utilizationOf(events, split.body.number));
        }
    }
    const std::vector<BodyForecast>& bodies() const { return m_bodies; }
    /// True if it has changed since the last call.
    bool takeChange() { return std::exchange(m_isChanged, false); }

private:
    static constexpr double kLargestWhole = 1.0 - 1e-9;  // of a body that breaks under no impact, without destruction

    /// The largest utilization of a bond of a body in a step in which one of them broke, at least 1.
    static double utilizationOf(const PlayEvents& events, std::uint32_t body) {
        double largest = 1.0;
        for (const PlayImpact& impact : events.impacts) {
            if (impact.body == body && impact.threshold > 0.0)
                largest = std::max(largest, impact.damage / impact.threshold);
        }
        return largest;
    }

    void keepLarger(std::uint32_t body, double ratio) {
        const auto place = std::ranges::lower_bound(m_bodies, body, {}, &BodyForecast::body);
        if (place == m_bodies.end() || place->body != body) {
            m_bodies.insert(place, {body, ratio});
        } else {
            if (ratio <= place->largest) return;
            place->largest = ratio;
        }
        m_isChanged = true;
    }

    std::vector<BodyForecast> m_bodies;  // ascending number
    bool m_isChanged = false;
};

}  // namespace

Result<std::vector<BodyForecast>> breakForecast(const ForecastOrder& order, const TaskContext& task,
                                                const ForecastRefinement& refine) {
    Result<Session> session = Session::start(order.scene, order.settings);
    if (!session) return session.error();
    session->restore(*order.start);
    if (const Status added = session->add(ShotInput{"throw", order.thrown}); !added) return added.error();
    const std::uint64_t steps = stepOf(kForecastTime, session->stepLength());
    const std::uint64_t interval = std::max<std::uint64_t>(stepOf(kRefinementTime, session->stepLength()), 1);
    ImpactRecord record;
    for (std::uint64_t step = 1; step <= steps; ++step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        session->step();
        record.record(session->events(), order.start->state.nextNumber);
        if (refine && step % interval == 0 && record.takeChange()) refine(record.bodies());
    }
    return record.bodies();
}

}  // namespace rubble
