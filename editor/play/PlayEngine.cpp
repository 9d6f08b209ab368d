#include "editor/play/PlayEngine.h"

#include "core/play/Forecast.h"

#include <algorithm>
#include <ranges>

namespace rubble {
namespace {

constexpr double kSecondsOfFlight = 4.0;

StepCost costOf(const Session& session) {
    const StepTimes& times = session.world().times();
    return {.step = session.stepsDone(),
            .pairs = times.pairs,
            .collide = times.collide,
            .swaps = session.swapMilliseconds(),
            .solve = times.prepare + times.solve,
            .finish = times.finish};
}

PlayFigures figuresOf(const Session& session) {
    const StepCounts counts = session.world().counts();
    const Momenta momenta = session.world().momenta();
    PlayFigures figures{.cost = costOf(session),
                        .candidatePairs = counts.candidatePairs,
                        .contactPoints = counts.contactPoints,
                        .energy = momenta.kinetic + momenta.potential};
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground) continue;
        ++figures.bodies;
        if (session.world().state(body.body).asleep) ++figures.asleep;
    }
    return figures;
}

ToldBreak told(const Session& session, const PlayBreak& broken) {
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

Result<std::unique_ptr<PlayEngine>> PlayEngine::started(const std::shared_ptr<const PlayScene>& scene,
                                                        PlayScript script, const TaskContext& task) {
    Result<Session> session = Session::start(scene, script.settings);
    if (!session) return session.error();
    Timeline timeline(std::move(*session), std::move(script.inputs), script.steps);
    std::unique_ptr<PlayEngine> engine(new PlayEngine(scene, std::move(timeline), std::move(script.hashes)));
    engine->m_beganWithDestruction = script.settings.hasDestruction;
    const Status begun = engine->m_timeline.seek(script.begin, task, [&engine] { engine->tell(); });
    if (!begun) return begun.error();
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
    return m_beganWithDestruction;
}

void PlayEngine::step() {
    if (const Status played = m_timeline.step(); !played) m_news.notices.push_back(played.error().message);
    tell();
}

void PlayEngine::seek(std::uint64_t step, const TaskContext& task) {
    const Status gone = m_timeline.seek(step, task, [this] { tell(); });
    if (!gone && gone.error().code != ErrorCode::Cancelled) m_news.notices.push_back(gone.error().message);
}

/// Of a step that was never played before.
void PlayEngine::tell() {
    const std::uint64_t step = session().stepsDone();
    if (step <= m_told) return;
    m_told = step;
    const PlayEvents& events = session().events();
    for (const PlayBreak& broken : events.breaks) m_news.breaks.push_back(told(session(), broken));
    m_news.notices.insert(m_news.notices.end(), events.notices.begin(), events.notices.end());
    m_news.costs.push_back(costOf(session()));
    if (step > m_hashes.size() || m_hashes[step - 1] == session().hash().low) return;
    m_news.notices.push_back("At step " + std::to_string(step) + " this goes another way than it was recorded.");
    m_hashes.clear();
}

void PlayEngine::add(const PlayInput& input) {
    const std::uint64_t now = session().stepsDone();
    if (const Status added = m_timeline.add(input); !added) {
        m_news.notices.push_back(added.error().message);
        return;
    }
    if (m_told > now) {  // it goes another way from here
        m_told = now;
        m_news.forgetBeyond = now;
        std::erase_if(m_news.breaks, [now](const ToldBreak& one) { return one.step > now; });
        std::erase_if(m_news.costs, [now](const StepCost& one) { return one.step > now; });
    }
    if (m_hashes.size() > now) m_hashes.resize(now);
}

void PlayEngine::fire(const std::string& name, const ShotAction& action) {
    const ShotInput shot{name, action};
    add(shot);
    m_news.shot = shot;
}

void PlayEngine::throwAlong(const Throw& thrown, const Ray& ray) {
    fire("throw", rubble::thrownAlong(session(), thrown, ray));
}

void PlayEngine::strikeAlong(double impulse, const Ray& ray) {
    if (const std::optional<Hammer> blow = blowAlong(session(), impulse, ray)) fire("hammer", *blow);
}

void PlayEngine::blastAlong(const Explosion& explosion, const Ray& ray) {
    if (const std::optional<Explosion> blast = rubble::blastAlong(session(), explosion, ray)) fire("blast", *blast);
}

void PlayEngine::grabAlong(double force, const Ray& ray) {
    const std::optional<CastHit> hit = metBy(session().world(), ray);
    if (!hit || session().world().kind(hit->body) != BodyKind::Dynamic) return;
    m_held = glm::dot(hit->point - ray.from, ray.direction);
    add(GrabInput{static_cast<std::uint32_t>(session().world().tag(hit->body)), hit->point, force});
}

void PlayEngine::dragAlong(const Ray& ray) {
    if (m_held) add(DragInput{ray.at(*m_held)});
}

void PlayEngine::letGo() {
    if (m_held) add(LetGoInput{});
    m_held.reset();
}

void PlayEngine::aim(std::optional<Throw> thrown, const Ray& ray) {
    m_aim.reset();
    if (thrown) m_aim = Aim{*thrown, ray};
}

void PlayEngine::setOverlays(const PlayOverlays& overlays) {
    m_isForecast = overlays.hasHeat;
    m_builder.setOverlays(overlays);
}

/// Of what is aimed, wherever on a body it would hit.
void PlayEngine::forecast() {
    std::optional<std::vector<BodyForecast>> bodies;
    if (m_isForecast && m_aim) {
        const Throw thrown = rubble::thrownAlong(session(), m_aim->thrown, m_aim->ray);
        if (Result<std::vector<BodyForecast>> forecast = breakForecast(session(), thrown))
            bodies = std::move(*forecast);
    }
    m_builder.setForecast(std::move(bodies));
}

PlayFrame PlayEngine::frame() {
    forecast();
    PlayFrame frame{.played = m_scene,
                    .scene = m_builder.momentOf(session()),
                    .step = session().stepsDone(),
                    .length = m_timeline.length(),
                    .figures = figuresOf(session()),
                    .isHolding = m_held.has_value(),
                    .hasDestruction = hasDestruction()};
    if (m_aim) frame.flight = flightOf(session(), thrownAlong(session(), m_aim->thrown, m_aim->ray), kSecondsOfFlight);
    return frame;
}

PlayNews PlayEngine::takeNews() {
    PlayNews news = std::exchange(m_news, {});
    news.frame = frame();
    return news;
}

}  // namespace rubble
