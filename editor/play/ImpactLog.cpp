#include "editor/play/ImpactLog.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kListedRatio = 0.1;  // of the threshold: weaker impacts are not listed
constexpr double kSameImpact = 0.25;  // s: a weaker impact this soon belongs to the one before

/// A record of an impact on a breakable body in the session's last step.
ImpactRecord recordOf(const Session& session, const PlayBody& body) {
    return {
        .step = session.stepsDone(),
        .name = session.nameOf(body),
        .asset = body.asset->bake->asset,
        .scale = body.asset->solid(body.fragment).threshold ? 0.0 : body.asset->solid(body.fragment).thresholdScale};
}

ImpactRecord recordOf(const Session& session, const PlayBreak& broken) {
    ImpactRecord record = recordOf(session, broken.body);
    record.impact = broken.impact;
    record.threshold = broken.threshold;
    record.point = broken.point;
    record.fragmentCount = broken.fragmentCount;
    record.milliseconds = broken.milliseconds;
    return record;
}

ImpactRecord recordOf(const Session& session, const PlayBody& body, const PlayImpact& impact) {
    ImpactRecord record = recordOf(session, body);
    record.impact = impact.damage;
    record.threshold = impact.threshold;
    record.point = impact.point;
    return record;
}

}  // namespace

std::size_t ImpactLog::breaks() const {
    return static_cast<std::size_t>(std::ranges::count_if(m_impacts, &ImpactRecord::isBreak));
}

std::span<const ImpactRecord> ImpactLog::record(const Session& session) {
    m_steps = session.stepsDone();
    const std::size_t before = m_impacts.size();
    for (const PlayBreak& broken : session.events().breaks) m_impacts.push_back(recordOf(session, broken));
    for (const PlayImpact& impact : session.events().impacts) addWithstood(session, impact);
    return std::span(m_impacts).subspan(before);
}

void ImpactLog::addWithstood(const Session& session, const PlayImpact& impact) {
    const PlayBody* body = session.body(impact.body);
    if (body == nullptr || impact.damage < kListedRatio * impact.threshold) return;  // null: it broke
    ImpactRecord record = recordOf(session, *body, impact);
    const auto last = m_lastWithstood.find(impact.body);
    const bool isSame =
        last != m_lastWithstood.end() && m_steps <= last->second.step + stepOf(kSameImpact, session.stepLength());
    if (isSame && record.impact <= last->second.impact) return;
    m_lastWithstood.insert_or_assign(impact.body, record);
    m_impacts.push_back(std::move(record));
}

void ImpactLog::discardAfter(std::uint64_t step) {
    m_steps = std::min(m_steps, step);
    std::erase_if(m_impacts, [step](const ImpactRecord& impact) { return impact.step > step; });
    std::erase_if(m_lastWithstood, [step](const auto& entry) { return entry.second.step > step; });
}

}  // namespace rubble
