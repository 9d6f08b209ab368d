#include "editor/play/PlayEngine.h"

#include "core/asset/project/Ranges.h"
#include "core/play/queries/FragmentAt.h"
#include "core/play/queries/WouldFall.h"
#include "core/play/scene/SupportProblems.h"
#include "core/play/session/PlayTestRun.h"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <utility>

namespace rubble {
namespace {

constexpr double kTrajectorySeconds = 4.0;
constexpr double kLoopBefore = 0.5;         // s
constexpr double kLoopAfter = 1.0;          // s
constexpr double kRestTime = 1.5;           // s: heat has cooled down then
constexpr double kForecastInterval = 0.25;  // s, between forecasts of the same throw while the scene moves

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

std::optional<GrabbedBody> grabbedBody(const World& world) {
    const std::optional<GrabSpring> spring = world.grabSpring();
    if (!spring) return std::nullopt;
    const double mass = world.mass(spring->body);
    return GrabbedBody{.point = spring->point,
                       .target = spring->target,
                       .mass = mass,
                       .weight = mass * glm::length(world.gravity()),
                       .force = spring->force};
}

}  // namespace

Result<Session> startOf(const std::shared_ptr<const PlayScene>& scene, PlayScript& script) {
    if (!script.state) return Session::start(scene, script.settings);
    SavedSession saved = *script.state;
    const std::vector<TimedInput> pending = std::exchange(saved.state.pending, {});
    script.inputs.insert(script.inputs.begin(), pending.begin(), pending.end());
    std::ranges::stable_sort(script.inputs, {}, &TimedInput::step);
    return resumedSession(scene, std::move(saved), script.settings);
}

PlayLoop loopAround(std::uint64_t step, double dt) {
    return {step - std::min(step, stepOf(kLoopBefore, dt)), step + stepOf(kLoopAfter, dt)};
}

PlayScript scriptOf(const Replay& replay) {
    PlayScript script{
        .settings = {.dt = replay.dt, .sleeping = replay.sleeping, .hasDestruction = replay.hasDestruction},
        .inputs = replay.inputs,
        .steps = replay.steps.size()};
    for (const ReplayStep& step : replay.steps) script.hashes.push_back(step.hash);
    return script;
}

PlayScript scriptOf(const Project& project, const PlayTest& test, std::uint64_t begin,
                    std::shared_ptr<const SavedSession> state) {
    PlayScript script{.begin = begin};
    const double dt = state ? state->dt : script.settings.dt;
    const std::uint64_t first = state ? state->state.step : 0;
    script.steps = first + std::max<std::uint64_t>(stepOf(test.duration, dt), 1);
    script.inputs = inputsOf(project, test, first, dt);
    script.state = std::move(state);
    return script;
}

Result<std::unique_ptr<PlayEngine>> PlayEngine::create(const std::shared_ptr<const PlayScene>& scene, PlayScript script,
                                                       const TaskContext& task) {
    Result<Session> session = startOf(scene, script);
    if (!session) return session.error();
    const bool hasDestruction = session->hasDestruction();
    Timeline timeline(std::move(*session), std::move(script.inputs), script.steps);
    std::unique_ptr<PlayEngine> engine(new PlayEngine(scene, std::move(timeline), std::move(script.hashes)));
    engine->m_startsWithDestruction = hasDestruction;
    engine->m_scriptSteps = script.steps;
    engine->recordFrame();
    const Status started = engine->m_timeline.seek(script.begin, task, [&engine] { engine->recordStep(); });
    if (!started) return started.error();
    return engine;
}

PlayEngine::PlayEngine(const std::shared_ptr<const PlayScene>& scene, Timeline timeline,
                       std::vector<std::uint64_t> hashes)
    : m_scene(scene),
      m_timeline(std::move(timeline)),
      m_builder(scene),
      m_recorded(std::make_shared<RecordedFrames>(scene, session().stepLength())),
      m_hashes(std::move(hashes)) {
    std::ranges::copy_if(scene->diagnostics, std::back_inserter(m_update.diagnostics), isOfSupport);
}

bool PlayEngine::hasDestruction() const {
    for (const TimedInput& timed : std::views::reverse(m_timeline.inputs())) {
        const auto* input = std::get_if<DestructionInput>(&timed.input);
        if (input != nullptr && timed.step <= session().stepsDone()) return input->isOn;
    }
    return m_startsWithDestruction;
}

void PlayEngine::step() {
    const Status played = m_timeline.step();
    if (!played) report(DiagnosticCode::UnappliedInput, played.error().message);
    recordStep();
}

bool PlayEngine::advance() {
    const std::uint64_t now = session().stepsDone();
    if (m_loop && (now < m_loop->first || now >= m_loop->last)) {
        seek(m_loop->first, {});
        return false;
    }
    step();
    return true;
}

void PlayEngine::setLoop(std::optional<PlayLoop> loop) {
    m_loop = loop;
    if (m_loop && m_scriptSteps > 0) m_loop->last = std::min(m_loop->last, m_scriptSteps);
}

void PlayEngine::seek(std::uint64_t step, const TaskContext& task) {
    const Status gone = m_timeline.seek(step, task, [this] { recordStep(); });
    m_lastMotion = session().stepsDone();
    if (!gone && gone.error().code != ErrorCode::Cancelled) {
        report(DiagnosticCode::UnappliedInput, gone.error().message);
    }
}

bool PlayEngine::isAtRest() const {
    const std::uint64_t now = session().stepsDone();
    const bool isInputAhead = !m_timeline.inputs().empty() && m_timeline.inputs().back().step >= now;
    if (m_loop || isInputAhead || !m_timeline.isAtEnd() || !session().isAtRest()) return false;
    return now >= m_lastMotion + stepOf(kRestTime, session().stepLength()) && !m_builder.hasDebris(session());
}

void PlayEngine::report(DiagnosticCode code, std::string message) {
    m_update.diagnostics.push_back(diagnostic(code, {}, std::move(message)));
}

/// Records a step; what is listed of it only when it is played for the first time.
void PlayEngine::recordStep() {
    const std::uint64_t step = session().stepsDone();
    m_builder.record(session());
    if (!session().isAtRest()) m_lastMotion = step;
    recordFrame();
    if (step <= m_log.steps()) return;
    if (auto events = m_log.record(session())) m_update.events.push_back(std::move(events));
    std::ranges::copy(session().events().diagnostics, std::back_inserter(m_update.diagnostics));
    m_update.costs.push_back(costOf(session()));
    if (step > m_hashes.size() || m_hashes[step - 1] == session().hash().low) return;
    report(DiagnosticCode::ReplayMismatch, "Step " + std::to_string(step) + " differs from the recording.");
    m_hashes.clear();
}

/// Records how the moment looks, if it is a new one.
void PlayEngine::recordFrame() {
    const std::uint64_t step = session().stepsDone();
    if (m_recorded->isKnown(step)) return;
    m_recorded->add({step, statisticsOf(session()), hasDestruction()}, m_builder.momentOf(session()),
                    session().events());
}

void PlayEngine::discardRecordsAfter(std::uint64_t step) {
    m_log.discardAfter(step);
    m_recorded->discardAfter(step);
    m_update.discardAfter = std::min(m_update.discardAfter.value_or(step), step);
    std::erase_if(m_update.events, [step](const auto& events) { return events->step > step; });
    std::erase_if(m_update.costs, [step](const StepCost& cost) { return cost.step > step; });
}

void PlayEngine::add(const PlayInput& input) {
    const std::uint64_t now = session().stepsDone();
    const std::uint32_t course = m_timeline.currentId();
    if (const Status added = m_timeline.add(input); !added) {
        return report(DiagnosticCode::UnappliedInput, added.error().message);
    }
    if (m_timeline.currentId() != course) keepLog(course);
    if (m_log.steps() > now) discardRecordsAfter(now);
    m_recorded->discardAfter(now);
    if (m_hashes.size() > now) m_hashes.resize(now);
    m_scriptSteps = 0;
}

/// Keeps the records of a course that became a branch.
void PlayEngine::keepLog(std::uint32_t course) {
    m_branchLogs[course] = m_log;
    std::erase_if(m_branchLogs, [this](const auto& log) {  // of branches that were dropped
        return std::ranges::find(m_timeline.branches(), log.first, &TimelineBranch::id) == m_timeline.branches().end();
    });
    m_update.isBranchKept = true;
}

void PlayEngine::startOver() {
    const std::uint32_t course = m_timeline.currentId();
    m_timeline.startOver();
    if (m_timeline.currentId() != course) keepLog(course);
    const std::uint64_t first = session().stepsDone();
    discardRecordsAfter(first);
    if (m_hashes.size() > first) m_hashes.resize(first);
    m_scriptSteps = 0;
    m_loop.reset();
    m_grabDistance.reset();
    m_aim.reset();
    m_lastMotion = first;
}

void PlayEngine::switchTo(std::uint32_t branch) {
    const std::uint32_t course = m_timeline.currentId();
    if (const Status switched = m_timeline.switchTo(branch); !switched) {
        return report(DiagnosticCode::UnappliedInput, switched.error().message);
    }
    const std::uint64_t fork = session().stepsDone();
    m_branchLogs[course] = m_log;
    discardRecordsAfter(fork);
    m_log = m_branchLogs.extract(branch).mapped();
    std::ranges::copy_if(m_log.course().steps(), std::back_inserter(m_update.events),
                         [fork](const auto& events) { return events->step > fork; });
    if (m_hashes.size() > fork) m_hashes.resize(fork);
    m_scriptSteps = 0;
    m_loop.reset();
    m_grabDistance.reset();
    m_lastMotion = fork;
}

std::vector<PlayBranch> PlayEngine::branches() const {
    std::vector<PlayBranch> branches;
    for (const TimelineBranch& branch : m_timeline.branches()) {
        branches.push_back({branch.id, m_timeline.forkOf(branch), branch.length,
                            countsOf(m_branchLogs.at(branch.id).course().breaks())});
    }
    return branches;
}

void PlayEngine::fire(const std::string& name, const ShotAction& action) {
    const ShotInput shot{name, action};
    m_loop.reset();
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

void PlayEngine::hammerAlong(double impulse, std::optional<double> radius, const Ray& ray) {
    if (const std::optional<Hammer> blow = rubble::hammerAlong(session(), impulse, ray, radius)) fire("hammer", *blow);
}

void PlayEngine::blastAlong(const Blast& blast, const Ray& ray) {
    if (const std::optional<Blast> aimed = rubble::blastAlong(session(), blast, ray)) fire("blast", *aimed);
}

void PlayEngine::grabAlong(double force, const Ray& ray) {
    const std::optional<CastHit> hit = firstHit(session().world(), ray);
    if (!hit) return report(DiagnosticCode::UnappliedInput, "Nothing was grabbed: there is no body at the pointer.");
    if (session().world().kind(hit->body) != BodyKind::Dynamic) {
        return report(DiagnosticCode::UnappliedInput, "Nothing was grabbed: the body at the pointer is fixed.");
    }
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

void PlayEngine::removeAlong(RemovalExtent removal, const Ray& ray) {
    const World& world = session().world();
    const std::optional<CastHit> hit = firstHit(world, ray);
    const PlayBody* body = hit ? session().body(static_cast<std::uint32_t>(world.tag(hit->body))) : nullptr;
    if (body == nullptr || body->role == PlayRole::Ground)
        return report(DiagnosticCode::UnappliedInput, "Nothing was removed: there is no body at the pointer.");
    InstancePart part{.instance = session().origins()[body->origin].instance};
    std::vector<std::uint32_t> fragments;
    const std::optional<std::uint32_t> hitFragment = fragmentAt(world, *body, hit->point);
    if (removal == RemovalExtent::Fragment && hitFragment) fragments = {*hitFragment};
    if (removal == RemovalExtent::Body && isPartial(*body)) fragments = fragmentsOf(*body);
    for (const std::uint32_t fragment : fragments) part.fragments.push_back(body->asset->bake->fragmentPath(fragment));
    std::ranges::sort(part.fragments);
    const bool isPiece = body->fragment != kNone && fragments.empty();
    if (part.instance == 0 || isPiece) {
        return report(DiagnosticCode::UnappliedInput,
                      "Nothing was removed: only instances and fragments of bonded ones can be.");
    }
    add(RemoveInput{std::move(part)});
}

void PlayEngine::aim(std::optional<ChargedThrow> thrown, const Ray& ray) {
    m_aim.reset();
    if (thrown) m_aim = Aim{*thrown, ray};
}

void PlayEngine::setOverlays(const PlayOverlays& overlays) {
    if (std::exchange(m_hasHulls, overlays.hasHulls) != overlays.hasHulls) m_recorded->clear();  // of other geometry
    m_hasHeat = overlays.hasHeat;
    m_hasCollapse = overlays.hasCollapse;
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

/// The body at the pointer, or the fragment of a bonded one, if it can be removed.
std::optional<BodyPart> PlayEngine::aimedPart() const {
    const World& world = session().world();
    const std::optional<CastHit> hit = m_hasCollapse && m_aim ? firstHit(world, m_aim->ray) : std::nullopt;
    const PlayBody* body = hit ? session().body(static_cast<std::uint32_t>(world.tag(hit->body))) : nullptr;
    if (body == nullptr || body->role == PlayRole::Ground) return std::nullopt;
    BodyPart part{.body = body->number};
    if (const std::optional<std::uint32_t> fragment = fragmentAt(world, *body, hit->point))
        part.fragments = {*fragment};
    return part;
}

/// Asks what would fall without the body or fragment at the pointer, if that or, for a while, the scene has changed.
void PlayEngine::forecastCollapse() {
    std::optional<BodyPart> part = aimedPart();
    if (!part) {
        m_collapse.reset();
        return m_builder.setCollapse(std::nullopt);
    }
    const std::uint64_t step = session().stepsDone();
    const bool isRecent =
        step >= m_collapseStep && step < m_collapseStep + stepOf(kForecastInterval, session().stepLength());
    if (m_collapse && m_collapsePart == *part && isRecent) return;
    const Result<Collapse> collapse = wouldFall(session(), {&*part, 1}, QueryEffort::Quick);
    RUBBLE_ASSERT(collapse.hasValue());
    m_collapsePart = *part;
    m_collapseStep = step;
    BodyCollapse shown{.removed = *part};
    std::size_t count = 0;
    for (const FallingIsland& island : collapse->islands) {
        std::ranges::copy(island.bodies, std::back_inserter(shown.falling));
        std::ranges::copy(island.parts, std::back_inserter(shown.fallingParts));
        count += island.bodies.size();
        for (const BodyPart& fallen : island.parts) count += fallen.fragments.size();
    }
    std::ranges::sort(shown.falling);
    const PlayBody& body = *session().body(part->body);
    const std::string name = part->fragments.empty()
                                 ? session().nameOf(body)
                                 : fragmentName(body, session().origins()[body.origin], part->fragments.front());
    m_collapse = CollapseForecast{name, count, collapse->mass, collapse->first, collapse->last};
    m_builder.setCollapse(std::move(shown));
}

PlayFrame PlayEngine::frame() {
    std::optional<Throw> aimed;
    if (m_aim) aimed = throwOf(m_aim->thrown, m_aim->ray);
    orderForecast(aimed);
    forecastCollapse();
    PlayFrame frame{.played = m_scene,
                    .scene = m_builder.sceneOf(session()),
                    .step = session().stepsDone(),
                    .length = m_timeline.length(),
                    .statistics = statisticsOf(session()),
                    .aimed = aimed,
                    .hasForecast = m_hasForecast,
                    .collapse = m_collapse,
                    .grabbed = grabbedBody(session().world()),
                    .hasDestruction = hasDestruction(),
                    .isAtRest = isAtRest(),
                    .loop = m_loop,
                    .branches = branches()};
    if (aimed) frame.trajectory = trajectoryOf(session(), *aimed, kTrajectorySeconds);
    recordFrame();
    m_recorded->setNewest(frame);
    return frame;
}

PlayUpdate PlayEngine::takeUpdate() {
    PlayFrame newest = frame();  // it may order a forecast
    PlayUpdate update = std::exchange(m_update, {});
    update.frame = std::move(newest);
    return update;
}

}  // namespace rubble
