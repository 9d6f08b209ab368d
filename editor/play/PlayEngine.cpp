#include "editor/play/PlayEngine.h"

#include "core/asset/project/Ranges.h"

#include <algorithm>
#include <ranges>

namespace rubble {
namespace {

constexpr double kTrajectorySeconds = 4.0;
constexpr double kForecastInterval = 0.25;  // s, between forecasts of the same throw while the scene moves
constexpr double kListedRatio = 0.1;        // of the threshold: weaker impacts are not listed
constexpr double kSameImpact = 0.25;        // s: a weaker impact this soon belongs to the one before

StepCost costOf(const Session& session) {
    const StepTimes& times = session.world().times();
    return {.step = session.stepsDone(),
            .pairs = times.pairs,
            .collide = times.collide,
            .swaps = session.swapMilliseconds(),
            .solve = times.prepare + times.solve,
            .finish = times.finish};
}

PlayStatistics statisticsOf(const Session& session) {
    const StepCounts counts = session.world().counts();
    const Momenta momenta = session.world().momenta();
    PlayStatistics statistics{.cost = costOf(session),
                              .candidatePairs = counts.candidatePairs,
                              .contactPoints = counts.contactPoints,
                              .energy = momenta.kinetic + momenta.potential};
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground) continue;
        ++statistics.bodies;
        if (session.world().state(body.body).asleep) ++statistics.asleep;
    }
    return statistics;
}

ImpactRecord recordOf(const Session& session, const PlayBreak& broken) {
    return {.step = broken.step,
            .name = session.nameOf(broken.body),
            .impact = broken.impact,
            .threshold = broken.threshold,
            .point = broken.point,
            .pieces = broken.pieces,
            .milliseconds = broken.milliseconds};
}

}  // namespace

PlayScript scriptOf(const Replay& replay) {
    PlayScript script{
        .settings = {.dt = replay.dt, .sleeping = replay.sleeping, .hasDestruction = replay.hasDestruction},
        .inputs = replay.inputs,
        .steps = replay.steps.size()};
    for (const ReplayStep& step : replay.steps) script.hashes.push_back(step.hash);
    return script;
}

PlayScript scriptOf(const Project& project, const PlayTest& test, std::uint64_t begin) {
    PlayScript script{.begin = begin};
    script.steps = std::max<std::uint64_t>(stepOf(test.duration, script.settings.dt), 1);
    for (const Shot& shot : project.shots) {
        if (std::ranges::find(test.shots, shot.id) == test.shots.end()) continue;
        script.inputs.push_back({stepOf(shot.time, script.settings.dt), ShotInput{shot.name, shot.action}});
    }
    std::ranges::stable_sort(script.inputs, {}, &TimedInput::step);
    return script;
}

Result<std::unique_ptr<PlayEngine>> PlayEngine::create(const std::shared_ptr<const PlayScene>& scene, PlayScript script,
                                                       const TaskContext& task) {
    Result<Session> session = Session::start(scene, script.settings);
    if (!session) return session.error();
    Timeline timeline(std::move(*session), std::move(script.inputs), script.steps);
    std::unique_ptr<PlayEngine> engine(new PlayEngine(scene, std::move(timeline), std::move(script.hashes)));
    engine->m_startsWithDestruction = script.settings.hasDestruction;
    engine->m_scriptSteps = script.steps;
    const Status started = engine->m_timeline.seek(script.begin, task, [&engine] { engine->recordStep(); });
    if (!started) return started.error();
    return engine;
}

PlayEngine::PlayEngine(const std::shared_ptr<const PlayScene>& scene, Timeline timeline,
                       std::vector<std::uint64_t> hashes)
    : m_scene(scene), m_timeline(std::move(timeline)), m_builder(scene), m_hashes(std::move(hashes)) {}

bool PlayEngine::hasDestruction() const {
    for (const TimedInput& one : std::views::reverse(m_timeline.inputs())) {
        const auto* input = std::get_if<DestructionInput>(&one.input);
        if (input != nullptr && one.step <= session().stepsDone()) return input->isOn;
    }
    return m_startsWithDestruction;
}

void PlayEngine::step() {
    const Status played = m_timeline.step();
    if (!played) report(DiagnosticCode::UnappliedInput, played.error().message);
    recordStep();
}

void PlayEngine::seek(std::uint64_t step, const TaskContext& task) {
    const Status gone = m_timeline.seek(step, task, [this] { recordStep(); });
    if (!gone && gone.error().code != ErrorCode::Cancelled) {
        report(DiagnosticCode::UnappliedInput, gone.error().message);
    }
}

void PlayEngine::report(DiagnosticCode code, std::string message) {
    m_update.diagnostics.push_back(diagnostic(code, {}, std::move(message)));
}

/// Records a step that is played for the first time.
void PlayEngine::recordStep() {
    const std::uint64_t step = session().stepsDone();
    if (step <= m_recordedSteps) return;
    m_recordedSteps = step;
    const PlayEvents& events = session().events();
    recordImpacts();
    m_update.diagnostics.insert(m_update.diagnostics.end(), events.diagnostics.begin(), events.diagnostics.end());
    m_update.costs.push_back(costOf(session()));
    if (step > m_hashes.size() || m_hashes[step - 1] == session().hash().low) return;
    report(DiagnosticCode::ReplayMismatch, "Step " + std::to_string(step) + " differs from the recording.");
    m_hashes.clear();
}

/// Records the breaks of the last step, and the impacts that bodies withstood.
void PlayEngine::recordImpacts() {
    const PlayEvents& events = session().events();
    const std::uint64_t step = session().stepsDone(), same = stepOf(kSameImpact, session().stepLength());
    for (const PlayBreak& broken : events.breaks) m_update.impacts.push_back(recordOf(session(), broken));
    for (const PlayImpact& impact : events.impacts) {
        const PlayBody* body = session().body(impact.body);
        if (body == nullptr || impact.damage < kListedRatio * impact.threshold) continue;  // null: it broke
        ImpactRecord record{.step = step,
                            .name = session().nameOf(*body),
                            .impact = impact.damage,
                            .threshold = impact.threshold,
                            .point = impact.point};
        const auto last = m_lastImpacts.find(impact.body);
        const bool isSame = last != m_lastImpacts.end() && step <= last->second.step + same;
        if (isSame && record.impact <= last->second.impact) continue;
        m_lastImpacts.insert_or_assign(impact.body, record);
        m_update.impacts.push_back(std::move(record));
    }
}

void PlayEngine::add(const PlayInput& input) {
    const std::uint64_t now = session().stepsDone();
    if (const Status added = m_timeline.add(input); !added) {
        return report(DiagnosticCode::UnappliedInput, added.error().message);
    }
    if (m_recordedSteps > now) {  // the recorded future is void
        m_recordedSteps = now;
        m_update.discardAfter = now;
        std::erase_if(m_update.impacts, [now](const ImpactRecord& one) { return one.step > now; });
        std::erase_if(m_lastImpacts, [now](const auto& one) { return one.second.step > now; });
        std::erase_if(m_update.costs, [now](const StepCost& one) { return one.step > now; });
    }
    if (m_hashes.size() > now) m_hashes.resize(now);
    m_scriptSteps = 0;
}

void PlayEngine::fire(const std::string& name, const ShotAction& action) {
    const ShotInput shot{name, action};
    add(shot);
    m_update.shot = shot;
}

/// The throw along a ray, with its speed.
Throw PlayEngine::throwOf(const ChargedThrow& charged, const Ray& ray) const {
    Throw thrown = charged.projectile;
    if (charged.isSpeedAutomatic) thrown.speed = reachingSpeed(session(), thrown, ray);
    thrown.speed *= 1.0 + charged.charge * (kFullCharge - 1.0);
    thrown.speed = std::min(thrown.speed, rangeOf(ProjectNumber::ProjectileSpeed).max);
    return rubble::throwAlong(session(), thrown, ray);
}

void PlayEngine::throwAlong(const ChargedThrow& thrown, const Ray& ray) { fire("throw", throwOf(thrown, ray)); }

void PlayEngine::hammerAlong(double impulse, const Ray& ray) {
    if (const std::optional<Hammer> blow = rubble::hammerAlong(session(), impulse, ray)) fire("hammer", *blow);
}

void PlayEngine::explosionAlong(const Explosion& explosion, const Ray& ray) {
    if (const std::optional<Explosion> blast = rubble::explosionAlong(session(), explosion, ray)) fire("blast", *blast);
}

void PlayEngine::grabAlong(double force, const Ray& ray) {
    const std::optional<CastHit> hit = firstHit(session().world(), ray);
    if (!hit || session().world().kind(hit->body) != BodyKind::Dynamic) return;
    m_grabDistance = glm::dot(hit->point - ray.from, ray.direction);
    add(GrabInput{static_cast<std::uint32_t>(session().world().tag(hit->body)), hit->point, force});
}

void PlayEngine::dragAlong(const Ray& ray) {
    if (m_grabDistance) add(DragInput{ray.at(*m_grabDistance)});
}

void PlayEngine::release() {
    if (m_grabDistance) add(ReleaseInput{});
    m_grabDistance.reset();
}

void PlayEngine::aim(std::optional<ChargedThrow> thrown, const Ray& ray) {
    m_aim.reset();
    if (thrown) m_aim = Aim{*thrown, ray};
}

void PlayEngine::setOverlays(const PlayOverlays& overlays) {
    m_hasHeat = overlays.hasHeat;
    m_builder.setOverlays(overlays);
}

/// Orders a forecast if the aimed throw has changed, or the scene since the last one. Another throw invalidates what is
/// shown.
void PlayEngine::orderForecast(const std::optional<Throw>& thrown) {
    const std::optional<Throw> wanted = m_hasHeat ? thrown : std::nullopt;
    const std::uint64_t step = session().stepsDone();
    const bool isOther = wanted != m_forecastThrow || step < m_forecastStep;
    if (isOther) {
        m_builder.setForecast(std::nullopt);
        m_hasForecast = false;
    }
    if (!isOther && step < m_forecastStep + stepOf(kForecastInterval, session().stepLength())) return;
    m_forecastThrow = wanted;
    m_forecastStep = step;
    if (!wanted) return;
    const SessionSettings settings{.dt = session().stepLength(), .sleeping = session().isSleeping()};
    m_update.order =
        std::make_shared<const ForecastOrder>(ForecastOrder{m_scene, settings, session().snapshot(), *wanted});
}

void PlayEngine::setForecast(const Throw& thrown, const std::vector<BodyForecast>& bodies) {
    if (m_forecastThrow != thrown) return;
    m_builder.setForecast(bodies);
    m_hasForecast = true;
}

PlayFrame PlayEngine::frame() {
    std::optional<Throw> aimed;
    if (m_aim) aimed = throwOf(m_aim->thrown, m_aim->ray);
    orderForecast(aimed);
    PlayFrame frame{.played = m_scene,
                    .scene = m_builder.sceneOf(session()),
                    .step = session().stepsDone(),
                    .length = m_timeline.length(),
                    .statistics = statisticsOf(session()),
                    .aimed = aimed,
                    .hasForecast = m_hasForecast,
                    .isHolding = m_grabDistance.has_value(),
                    .hasDestruction = hasDestruction()};
    if (aimed) frame.trajectory = trajectoryOf(session(), *aimed, kTrajectorySeconds);
    return frame;
}

PlayUpdate PlayEngine::takeUpdate() {
    PlayFrame newest = frame();  // it may order a forecast
    PlayUpdate update = std::exchange(m_update, {});
    update.frame = std::move(newest);
    return update;
}

}  // namespace rubble
