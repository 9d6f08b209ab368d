#include "core/play/session/Session.h"

#include "core/asset/project/Ranges.h"
#include "core/base/Assert.h"
#include "core/base/Stopwatch.h"
#include "core/play/breaking/ApplyDamage.h"
#include "core/play/breaking/BondBreaking.h"
#include "core/play/breaking/Collapsing.h"
#include "core/play/breaking/DebrisRemoval.h"
#include "core/play/breaking/HitIntervals.h"
#include "core/play/breaking/SharedImpacts.h"
#include "core/play/breaking/Splitting.h"
#include "core/play/breaking/Swap.h"
#include "core/play/events/EventReporting.h"
#include "core/play/session/SessionInputs.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace rubble {
namespace {

WorldSettings worldSettings(const PlayScene& scene, const SessionSettings& settings) {
    return {.gravity = scene.project.gravity,
            .sleeping = settings.sleeping,
            .threads = settings.threads,
            .lanes = settings.lanes};
}

/// The bodies that a hit may break.
std::vector<BodyId> breakableBodies(const SessionState& state) {
    std::vector<BodyId> bodies;
    for (const PlayBody& body : state.bodies) {
        if (body.fracture() != nullptr || body.bondedFracture() != nullptr) bodies.push_back(body.body);
    }
    return bodies;
}

/// Breaks what is hit hard enough in the coming dt seconds. A body that broke bonds and goes on meets what they held in
/// the same time; what came of a swap breaks in the next at the earliest.
void breakBodies(SessionParts& parts, std::span<const Impact> impacts, double dt) {
    constexpr int kMaxPasses = 8;  // of a hit through bonds
    splitBodies(parts, brokenByCollapse(parts));
    // Bonds first: what breaks whole is gone after its swap, and could not take the impulse of bonds.
    const std::vector<Impact> shared = sharedImpacts(parts.world(), impacts);
    bool hasFreed = breakHitBonds(parts, shared);
    breakHitBodies(parts, shared);
    for (int pass = 1; hasFreed && pass < kMaxPasses; ++pass) {
        parts.world().collide(dt);
        hasFreed =
            breakHitBonds(parts, sharedImpacts(parts.world(), parts.world().impacts(breakableBodies(parts.state()))));
    }
    if (parts.world().hasUncollided()) parts.world().collide(dt);
    std::set<Id> changed;
    for (const PlaySplit& split : parts.state().events.splits)
        if (split.body.isHeld) changed.insert(parts.state().origins[split.body.origin].instance);
    planMortarCollapse(parts, changed);
}

/// Whether bonds broke in this step, or anything shortly before it.
bool hasBroken(const SessionState& state, double dt) {
    return !state.events.splits.empty() || timeOf(state, dt) < state.dividedUntil;
}

}  // namespace

std::uint64_t stepOf(double time, double dt) {
    constexpr double kSlack = 1e-6;   // of a step: 0.1 s are six steps of 1/60 s in spite of rounding
    constexpr double kLatest = 1e18;  // fits the type
    return static_cast<std::uint64_t>(std::min(std::max(0.0, std::ceil(time / dt - kSlack)), kLatest));
}

Session::Session(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings)
    : m_scene(std::move(scene)),
      m_settings(settings),
      m_state(std::make_unique<SessionState>()),
      m_world(worldSettings(*m_scene, settings)) {
    m_state->hasDestruction = settings.hasDestruction;
}

Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Result<Session> Session::start(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings) {
    if (const NumberRange& range = rangeOf(ProjectNumber::StepLength); !range.contains(settings.dt)) {
        return Error{ErrorCode::BadInput, "A step must be " + rangeText(range) + " s long."};
    }
    Session session(std::move(scene), settings);
    SessionParts parts{*session.m_scene, session.m_settings, *session.m_state, session.m_world};
    if (const Status placed = placeScene(parts); !placed) return placed.error();
    splitUnjoined(parts);
    session.m_state->events = {};
    return session;
}

Status Session::add(const PlayInput& input) { return add(TimedInput{m_state->step, input}); }

Status Session::add(const TimedInput& timed) {
    if (timed.step < m_state->step) {
        return Error{ErrorCode::BadInput, "An input for step " + std::to_string(timed.step) + " came after " +
                                              std::to_string(m_state->step) + " steps were done."};
    }
    if (const std::optional<std::string> fault = faultOf(timed.input, *m_scene, *m_state)) {
        return Error{ErrorCode::BadInput, *fault};
    }
    const auto place = std::ranges::upper_bound(m_state->pending, timed.step, {}, &TimedInput::step);
    m_state->pending.insert(place, timed);
    return success();
}

Status Session::add(const Shot& shot) {
    return add(TimedInput{m_state->step + stepOf(shot.time, m_settings.dt), ShotInput{shot.name, shot.action}});
}

void Session::step() {
    SessionParts parts{*m_scene, m_settings, *m_state, m_world};
    m_state->events = {};
    m_swapMilliseconds = 0.0;
    applyInputs(parts);
    int intervals = hasBroken(*m_state, m_settings.dt) ? hitIntervals(m_settings.dt) : 1;
    std::vector<Impact> impacts;
    if (intervals == 1) {
        impacts = impactsWithin(m_settings.dt);
        if (mayBreak(parts, impacts)) intervals = hitIntervals(m_settings.dt);
    }
    const double dt = m_settings.dt / intervals;
    PlayEvents events;
    for (int k = 0; k < intervals; ++k) {
        m_state->elapsed = k * dt;
        if (intervals > 1) impacts = impactsWithin(dt);
        if (mayBreak(parts, impacts)) impacts = hitsWithin(dt);
        playInterval(impacts, dt);
        m_state->events.happened = happenedEvents(parts);
        append(std::exchange(m_state->events, {}), events);
    }
    m_state->events = std::move(events);
    m_state->elapsed = 0.0;
    ++m_state->step;
    removeDebris(parts);
    tellEvents(parts);
}

bool Session::isAtRest() const {
    if (!m_state->pending.empty() || m_world.grabSpring() || m_state->dividedUntil > timeOf(*m_state, m_settings.dt))
        return false;
    const Debris& debris = m_scene->project.debris;
    return std::ranges::none_of(m_state->bodies, [&](const PlayBody& body) {
        const bool isAwake = m_world.kind(body.body) != BodyKind::Static && !m_world.state(body.body).asleep;
        return isAwake || body.collapseStep != PlayBody::kNever || (debris.lifetime && body.isDebris());
    });
}

std::vector<Impact> Session::impactsWithin(double dt) {
    m_world.recollide(dt, {});
    return m_world.impacts(breakableBodies(*m_state));
}

std::vector<Impact> Session::hitsWithin(double dt) {
    const std::vector<BodyId> breakable = breakableBodies(*m_state);
    m_world.recollide(dt, breakable);
    return m_world.impacts(breakable);
}

void Session::playInterval(std::span<const Impact> impacts, double dt) {
    SessionParts parts{*m_scene, m_settings, *m_state, m_world};
    Stopwatch watch;
    breakBodies(parts, impacts, dt);
    m_swapMilliseconds += watch.lap();
    if (m_settings.checksEnergy) {
        RUBBLE_ASSERT(std::ranges::all_of(m_state->events.energy, &EnergyEntry::isConserved));
    }
    if (!m_state->events.breaks.empty() || !m_state->events.splits.empty())
        m_state->dividedUntil = timeOf(*m_state, m_settings.dt) + kDividedTime;
    m_world.solve(dt);
}

std::uint64_t Session::stepsDone() const { return m_state->step; }
double Session::stepLength() const { return m_settings.dt; }
bool Session::isSleeping() const { return m_settings.sleeping; }
const PlayScene& Session::scene() const { return *m_scene; }
const World& Session::world() const { return m_world; }
const std::vector<PlayBody>& Session::bodies() const { return m_state->bodies; }
const PlayBody* Session::body(std::uint32_t number) const { return findBody(*m_state, number); }
const PlayBody* Session::recentBody(std::uint32_t number) const {
    if (const PlayBody* present = body(number)) return present;
    const auto numberOf = [](const auto& one) { return one.body.number; };
    const auto broken = std::ranges::find(events().breaks, number, numberOf);
    if (broken != events().breaks.end()) return &broken->body;
    const auto removed = std::ranges::find(events().removed, number, numberOf);
    return removed != events().removed.end() ? &removed->body : nullptr;
}
const std::vector<PlayOrigin>& Session::origins() const { return m_state->origins; }
const std::vector<StructureState>& Session::structures() const { return m_state->structures; }
std::string Session::nameOf(const PlayBody& body) const { return rubble::nameOf(body, m_state->origins[body.origin]); }
double Session::thresholdOf(const PlayBody& body) const { return rubble::thresholdOf(*m_state, *m_scene, body); }
double Session::fadeOf(const PlayBody& body) const {
    return rubble::fadeOf(body, m_scene->project.debris, m_state->step, m_settings.dt);
}
bool Session::hasDestruction() const { return m_state->hasDestruction; }
SessionDamage Session::damage() const { return damageOfInstances(*m_scene, *m_state); }

Status Session::apply(const SessionDamage& damage) {
    SessionParts parts{*m_scene, m_settings, *m_state, m_world};
    return applyDamage(parts, damage);
}

const PlayEvents& Session::events() const { return m_state->events; }

double Session::heldPotential() const { return rubble::heldPotential(*m_scene, *m_state, m_world); }

double Session::swapMilliseconds() const { return m_swapMilliseconds; }

std::shared_ptr<const SessionSnapshot> Session::snapshot() const {
    return std::make_shared<const SessionSnapshot>(SessionSnapshot{*m_state, m_world.snapshot()});
}

std::size_t Session::snapshotBytes() const { return byteCount(*m_state) + m_world.snapshotBytes(); }

void Session::restore(const SessionSnapshot& snapshot) {
    *m_state = snapshot.state;
    m_world.restore(*snapshot.world);
}

}  // namespace rubble
