#include "editor/play/EventLog.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

constexpr double kListedRatio =
    0.1;  // of the threshold: weaker impacts that the session does not report are not listed
constexpr double kSameImpact = 0.25;  // s: a weaker impact this soon belongs to the one before

std::string nameOf(const Session& session, std::uint32_t number) {
    const PlayBody* const body = number == kNone ? nullptr : session.recentBody(number);
    return body == nullptr ? std::string() : session.nameOf(*body);
}

PlayEvent eventOf(const Session& session, EventRecord record) {
    PlayEvent event{.record = std::move(record)};
    event.name = nameOf(session, event.record.body);
    event.otherName = nameOf(session, event.record.other);
    return event;
}

/// An event that the session does not report one by one.
PlayEvent unreportedEvent(const Session& session, EventKind kind, const PlayBody& body, Vec3 point) {
    PlayEvent event{.record = {.step = session.stepsDone(),
                               .kind = kind,
                               .body = body.number,
                               .instance = session.origins()[body.origin].instance,
                               .point = point},
                    .name = session.nameOf(body),
                    .isReported = false};
    if (body.asset && body.fragment != kNone) event.record.fragment = body.asset->bake->fragmentPath(body.fragment);
    return event;
}

ImpactStrength strengthOf(const Session& session, const PlayBody& body, double impact, double threshold) {
    const auto& solid = body.asset->solid(body.fragment);
    return {.name = session.nameOf(body),
            .impact = impact,
            .threshold = threshold,
            .asset = body.asset->bake->asset,
            .scale = solid.threshold ? 0.0 : solid.thresholdScale};
}

void addBreak(const Session& session, const PlayBreak& broken, std::vector<PlayEvent>& events) {
    const auto isIts = [&](const PlayEvent& event) {
        return event.record.kind == EventKind::Broken && event.record.body == broken.body.number;
    };
    auto event = std::ranges::find_if(events, isIts);
    if (event == events.end()) {
        PlayEvent unreported = unreportedEvent(session, EventKind::Broken, broken.body, broken.point);
        unreported.otherName = nameOf(session, broken.impactorNumber);
        unreported.record.other = broken.impactorNumber;
        unreported.record.normal = broken.normal;
        unreported.record.impulse = broken.impact;
        unreported.record.speed = broken.approachSpeed;
        unreported.record.count = broken.fragmentCount;
        event = events.insert(events.end(), std::move(unreported));
    }
    event->strength = strengthOf(session, broken.body, broken.impact, broken.threshold);
    event->milliseconds = broken.milliseconds;
}

/// The reported impact that this was: the strongest one of the body, or else one on it, whose body has no threshold.
PlayEvent* reportedImpact(std::uint32_t body, std::vector<PlayEvent>& events) {
    PlayEvent* found = nullptr;
    for (PlayEvent& event : events) {
        const bool isCandidate = event.record.kind == EventKind::Impact && event.isReported && !event.strength &&
                                 (event.record.body == body || event.record.other == body);
        if (!isCandidate) continue;
        const auto rank = [body](const PlayEvent& one) {
            return std::pair(one.record.body == body, one.record.energy);
        };
        if (found == nullptr || rank(event) > rank(*found)) found = &event;
    }
    return found;
}

/// Counts and sums the reported events but breaks, and drops the others.
void keepBreaks(LoggedStep& events) {
    for (const PlayEvent& event : events.events) {
        if (event.isBreak() || !event.isReported) continue;
        OmittedEvents& omitted = events.omitted[static_cast<std::size_t>(event.record.kind)];
        ++omitted.count;
        omitted.energy += event.record.energy;
    }
    std::erase_if(events.events, [](const PlayEvent& event) { return !event.isBreak(); });
}

}  // namespace

std::shared_ptr<const LoggedStep> EventLog::record(const Session& session) {
    m_steps = session.stepsDone();
    const PlayEvents& happened = session.events();
    LoggedStep events{.step = m_steps, .omitted = happened.report.omitted, .restEnergy = happened.report.restEnergy};
    for (const EventRecord& record : happened.report.records) events.events.push_back(eventOf(session, record));
    for (const PlayBreak& broken : happened.breaks) addBreak(session, broken, events.events);
    for (const PlayImpact& impact : happened.impacts) addWithstood(session, impact, events);
    if (m_course.size() >= m_maxEvents) keepBreaks(events);
    std::ranges::stable_sort(events.events, {}, [](const PlayEvent& event) {
        return std::tuple(event.record.kind, event.record.body, event.record.other);
    });
    if (events.events.empty() && happened.report.isEmpty()) return nullptr;
    events.events.shrink_to_fit();
    auto recorded = std::make_shared<const LoggedStep>(std::move(events));
    m_course.append(recorded);
    return recorded;
}

void EventLog::addWithstood(const Session& session, const PlayImpact& impact, LoggedStep& events) {
    const PlayBody* body = session.body(impact.body);
    if (body == nullptr) return;  // it broke
    PlayEvent* const reported = reportedImpact(impact.body, events.events);
    if (reported != nullptr) reported->strength = strengthOf(session, *body, impact.damage, impact.threshold);
    if (impact.damage < kListedRatio * impact.threshold) return;
    const auto last = m_lastWithstood.find(impact.body);
    const bool isSame =
        last != m_lastWithstood.end() && m_steps <= last->second.step + stepOf(kSameImpact, session.stepLength());
    if (isSame && impact.damage <= last->second.impact) return;
    m_lastWithstood.insert_or_assign(impact.body, Withstood{m_steps, impact.damage});
    if (reported != nullptr) return;
    PlayEvent unreported = unreportedEvent(session, EventKind::Impact, *body, impact.point);
    unreported.record.impulse = impact.damage;
    unreported.strength = strengthOf(session, *body, impact.damage, impact.threshold);
    events.events.push_back(std::move(unreported));
}

void EventLog::discardAfter(std::uint64_t step) {
    m_steps = std::min(m_steps, step);
    m_course.discardAfter(step);
    std::erase_if(m_lastWithstood, [step](const auto& entry) { return entry.second.step > step; });
}

}  // namespace rubble
