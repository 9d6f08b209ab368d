#include "editor/play/PlayController.h"

#include "core/asset/placement/InstancePlacement.h"
#include "core/asset/project/Ranges.h"
#include "core/base/Parallel.h"
#include "core/play/scene/LiveInputs.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rubble {

PlayController::PlayController(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    connect(&document, &Document::changed, this, &PlayController::applyEdits);
    connect(&bakes, &Bakes::changed, this, &PlayController::startIfBaked);
    connect(&m_thread, &PlayThread::updateReady, this, &PlayController::applyUpdate);
    connect(&m_thread, &PlayThread::failed, this, &PlayController::finish);
}

void PlayController::setState(PlayState state) {
    if (m_state == state) return;
    m_state = state;
    m_thread.setPlaying(state == PlayState::Playing);
    emit stateChanged();
}

void PlayController::play() {
    if (m_state == PlayState::Stopped) {
        m_startsPlaying = true;
        return restart();
    }
    m_startsPlaying = true;
    m_soughtStep.reset();
    if (m_state == PlayState::Paused) setState(PlayState::Playing);
}

void PlayController::pause() {
    m_startsPlaying = false;
    if (m_state == PlayState::Playing) setState(PlayState::Paused);
}

void PlayController::stop() {
    m_thread.stop();
    m_isWaitingForBakes = false;
    m_queuedTasks.clear();
    m_scene.reset();
    m_frame.reset();
    clearResults();
    setState(PlayState::Stopped);
    emit eventsChanged();
}

void PlayController::clearResults() {
    m_events = {};
    m_shownEvents.clear();
    m_costs.clear();
    m_lastShot.reset();
}

/// The signal is queued: meanwhile the simulation may have been started again.
void PlayController::finish(const QString& sentence) {
    if (m_isWaitingForBakes || m_thread.isStarted()) return;
    stop();
    emit statusMessage(sentence);
}

/// Where nothing but throws and the like was added to the session, it starts over itself and keeps its timelines.
void PlayController::reset() {
    if (!isInPlay()) return;
    const bool isScripted = m_script.steps > 0 || !m_script.inputs.empty() || m_script.state;
    const bool isAsStarted = !isScripted && m_script.settings == nextSettings() &&
                             m_followedProject == m_startProject && m_document.project() == m_startProject;
    if (m_isWaitingForBakes || m_state == PlayState::Preparing || !isAsStarted) return restart();
    forgetAim();
    post([](PlayEngine& engine) { engine.startOver(); });
    m_thread.seek(0);  // which shows it
}

void PlayController::replay(PlayScript script) {
    m_startsPlaying = script.begin == 0;
    prepare(std::move(script));
}

void PlayController::load(std::shared_ptr<const SavedSession> state) {
    m_startsPlaying = false;
    prepare({.settings = nextSettings(), .state = std::move(state)});
}

/// Posts a task to the session, or queues it for the one that will start.
void PlayController::post(PlayThread::Task task) {
    if (m_isWaitingForBakes) return m_queuedTasks.push_back(std::move(task));
    m_thread.post(std::move(task));
}

void PlayController::stepOnce() {
    if (!isInPlay()) return;
    if (m_soughtStep) return seekBy(1);
    pause();
    post([](PlayEngine& engine) { engine.step(); });
}

void PlayController::seek(std::uint64_t step) {
    if (!hasSession()) return;
    pause();
    m_soughtStep = std::min(step, m_frame->length);
    m_thread.seek(*m_soughtStep);
}

void PlayController::seekBy(std::int64_t steps) {
    if (!hasSession()) return;
    const auto from = static_cast<std::int64_t>(m_soughtStep.value_or(m_frame->step));
    seek(static_cast<std::uint64_t>(std::max<std::int64_t>(from + steps, 0)));
}

void PlayController::previousEvent() {
    if (!hasSession()) return;
    const std::uint64_t now = m_soughtStep.value_or(m_frame->step);
    const auto after = std::ranges::lower_bound(shownEvents(), now, {}, stepOfEvent);
    if (after != shownEvents().begin()) seek((*std::prev(after))->record.step);
}

void PlayController::nextEvent() {
    if (!hasSession()) return;
    const std::uint64_t now = m_soughtStep.value_or(m_frame->step);
    const auto next = std::ranges::upper_bound(shownEvents(), now, {}, stepOfEvent);
    if (next != shownEvents().end()) seek((*next)->record.step);
}

/// Seeks first: unlike the jumps of the loop, a seek can be cancelled.
void PlayController::loopAround(std::uint64_t step) {
    if (!hasSession()) return;
    const PlayLoop loop = rubble::loopAround(step, m_thread.stepLength());
    m_thread.post([loop](PlayEngine& engine) { engine.setLoop(loop); });
    seek(loop.first);
    play();
}

void PlayController::endLoop() {
    post([](PlayEngine& engine) { engine.setLoop(std::nullopt); });
}

void PlayController::toggleLoop() {
    if (!hasSession()) return;
    if (m_frame->loop) return endLoop();
    const std::span<const EventRef> breaks = m_events.breaks();
    const auto distance = [this](const EventRef& broken) {
        return std::max(broken->record.step, m_frame->step) - std::min(broken->record.step, m_frame->step);
    };
    const auto nearest = std::ranges::min_element(breaks, {}, distance);
    if (nearest != breaks.end()) return loopAround((*nearest)->record.step);
    emit statusMessage(tr("Nothing has broken yet that could be played again."));
    emit frameChanged();  // for the switch, which shows a loop
}

void PlayController::switchTo(std::uint32_t branch) {
    if (!hasSession()) return;
    pause();
    m_soughtStep.reset();
    m_thread.post([branch](PlayEngine& engine) { engine.switchTo(branch); });
}

void PlayController::setTimeScale(double scale) {
    if (m_timeScale == scale) return;
    m_timeScale = scale;
    m_thread.setTimeScale(scale);
    emit settingsChanged();
}

void PlayController::setTimeStep(double seconds) {
    const NumberRange& range = rangeOf(ProjectNumber::StepLength);
    if (m_timeStep == seconds || !range.contains(seconds)) return;
    m_timeStep = seconds;
    emit settingsChanged();
    if (!isInPlay()) return;
    emit statusMessage(tr("The simulation restarts with the new time step."));
    restart();
}

void PlayController::setDestruction(bool isOn) {
    if (m_hasDestruction == isOn) return;
    m_hasDestruction = isOn;
    if (isInPlay()) m_requestedDestruction = isOn;
    post([isOn](PlayEngine& engine) { engine.add(DestructionInput{isOn}); });
    emit settingsChanged();
}

void PlayController::setOverlays(const PlayOverlays& overlays) {
    if (m_overlays == overlays) return;
    m_overlays = overlays;
    postOverlays();
    emit settingsChanged();
}

void PlayController::setOverlaysShown(bool isOn) {
    if (std::exchange(m_areOverlaysShown, isOn) != isOn) postOverlays();
}

/// Hulls, which have a geometry of their own, stay; the view draws them with the other overlays only.
PlayOverlays PlayController::shownOverlays() const {
    return m_areOverlaysShown ? m_overlays : PlayOverlays{.hasHulls = m_overlays.hasHulls};
}

void PlayController::postOverlays() {
    post([overlays = shownOverlays()](PlayEngine& engine) { engine.setOverlays(overlays); });
}

void PlayController::setToolSettings(const PlayToolSettings& tools) {
    if (m_toolSettings == tools) return;
    m_toolSettings = tools;
    emit toolSettingsChanged();
}

ChargedThrow PlayController::charged(double charge) const {
    return {m_toolSettings.projectile, m_toolSettings.isSpeedAutomatic, charge};
}

void PlayController::aim(const std::optional<Ray>& ray, double charge) {
    std::optional<ChargedThrow> thrown;
    if (ray) thrown = charged(charge);
    post([thrown, ray](PlayEngine& engine) { engine.aim(thrown, ray.value_or(Ray{})); });
}

void PlayController::throwAlong(const Ray& ray, double charge) {
    post([thrown = charged(charge), ray](PlayEngine& engine) { engine.throwAlong(thrown, ray); });
}

void PlayController::hammerAlong(const Ray& ray) {
    const PlayToolSettings& tools = m_toolSettings;
    const auto radius = tools.isHammerRadiusAutomatic ? std::nullopt : std::optional(tools.hammerRadius);
    post(
        [impulse = tools.hammerImpulse, radius, ray](PlayEngine& engine) { engine.hammerAlong(impulse, radius, ray); });
}

void PlayController::blastAlong(const Ray& ray) {
    post([blast = m_toolSettings.blast, ray](PlayEngine& engine) { engine.blastAlong(blast, ray); });
}

void PlayController::removeAlong(RemovalExtent removal, const Ray& ray) {
    post([removal, ray](PlayEngine& engine) { engine.removeAlong(removal, ray); });
}

void PlayController::grabAlong(const Ray& ray) {
    post([force = m_toolSettings.grabForce, ray](PlayEngine& engine) { engine.grabAlong(force, ray); });
}

void PlayController::dragAlong(const Ray& ray) {
    post([ray](PlayEngine& engine) { engine.dragAlong(ray); });
}

void PlayController::release() {
    post([](PlayEngine& engine) { engine.release(); });
}

void PlayController::setEventFilter(const EventFilter& filter) {
    if (filter == eventFilter()) return;
    m_shownEvents.setFilter(filter, m_events);
    emit eventsChanged();
}

void PlayController::fire(const Shot& shot) {
    post([shot](PlayEngine& engine) { engine.fire(shot.name, shot.action); });
}

void PlayController::playShot(const Shot& shot) {
    m_startsPlaying = true;
    restart();
    fire(shot);
}

void PlayController::requestScript(std::function<void(PlayScript)> receive) {
    if (!hasSession()) return;
    m_thread.post(
        [this, receive = std::move(receive), scene = m_scene, settings = m_script.settings](PlayEngine& engine) {
            PlayScript script{
                .settings = settings, .inputs = engine.timeline().inputs(), .steps = engine.timeline().length()};
            const auto deliver = [this, receive, scene, script = std::move(script)] {
                if (hasSession() && m_scene == scene) receive(script);
            };
            QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
        });
}

void PlayController::requestState(std::function<void(std::shared_ptr<const SavedSession>)> receive) {
    if (!hasSession()) return;
    m_thread.post([this, receive = std::move(receive), scene = m_scene](PlayEngine& engine) {
        const auto saved = std::make_shared<const SavedSession>(savedSession(engine.session(), StateKind::Whole));
        const auto deliver = [this, receive, scene, saved] {
            if (hasSession() && m_scene == scene) receive(saved);
        };
        QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    });
}

SessionSettings PlayController::nextSettings() const {
    return {.dt = m_timeStep, .hasDestruction = m_hasDestruction, .threads = availableProcessors()};
}

void PlayController::restart() { prepare({.settings = nextSettings()}); }

void PlayController::prepare(PlayScript script) {
    m_script = std::move(script);
    m_queuedTasks.clear();
    m_requestedDestruction.reset();
    forgetAim();
    setState(PlayState::Preparing);
    m_isWaitingForBakes = true;
    startIfBaked();
}

/// Nothing is sought or aimed any more.
void PlayController::forgetAim() {
    m_soughtStep.reset();
    if (!m_frame) return;
    m_frame->aimed.reset();
    m_frame->trajectory.reset();
}

/// Starts once all assets are baked in their current state.
void PlayController::startIfBaked() {
    if (!m_isWaitingForBakes || !m_bakes.areCurrent(m_document.project())) return;
    m_isWaitingForBakes = false;
    m_followedProject = m_startProject = m_document.project();
    suggestTools();
    m_thread.start([project = m_followedProject, bakes = m_bakes.assetBakes(), script = m_script,
                    overlays = shownOverlays()](const TaskContext& task) -> Result<std::unique_ptr<PlayEngine>> {
        const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, bakes, task);
        if (!scene) return scene.error();
        Result<std::unique_ptr<PlayEngine>> engine = PlayEngine::create(*scene, script, task);
        if (engine) (*engine)->setOverlays(overlays);
        return engine;
    });
    for (PlayThread::Task& task : m_queuedTasks) m_thread.post(std::move(task));
    m_queuedTasks.clear();
}

/// Fits the tools to the size of the scene, unless they were set.
void PlayController::suggestTools() {
    std::vector<Id> instances;
    for (const Instance& instance : m_startProject.instances) instances.push_back(instance.id);
    const Box3 bounds = boundsOf(m_startProject, instances);
    const bool areDefault = hasDefaultTools();
    m_defaultTools = defaultPlayTools(bounds.isEmpty() ? 0.0 : bounds.diagonal());
    if (areDefault) setToolSettings(m_defaultTools);
}

void PlayController::applyEdits() {
    if (!isInPlay()) return;
    if (m_isWaitingForBakes) return startIfBaked();
    const std::optional<std::vector<PlayInput>> inputs = liveInputs(m_followedProject, m_document.project());
    if (!inputs) {
        emit statusMessage(tr("The simulation restarts with the change."));
        return restart();
    }
    m_followedProject = m_document.project();
    for (const PlayInput& input : *inputs) post([input](PlayEngine& engine) { engine.add(input); });
}

double PlayController::stepFraction() const {
    if (!m_frame || m_frame->shownFor <= 0.0) return 1.0;
    return std::clamp((m_thread.now() - m_frame->shownFrom) / m_frame->shownFor, 0.0, 1.0);
}

/// Returns whether there were any.
bool PlayController::applyEvents(const PlayUpdate& update) {
    if (update.discardAfter) {
        m_events.discardAfter(*update.discardAfter);
        m_shownEvents.discardAfter(*update.discardAfter);
    }
    for (const std::shared_ptr<const LoggedStep>& step : update.events) {
        m_events.append(step);
        m_shownEvents.append(step);
    }
    return !update.events.empty() || update.discardAfter;
}

/// Ignores frames from before the user's last switch.
void PlayController::applyDestruction(const PlayFrame& frame) {
    if (m_isWaitingForBakes || (m_requestedDestruction && *m_requestedDestruction != frame.hasDestruction)) return;
    m_requestedDestruction.reset();
    if (std::exchange(m_hasDestruction, frame.hasDestruction) != frame.hasDestruction) emit settingsChanged();
}

void PlayController::applyUpdate() {
    PlayUpdate update = m_thread.takeUpdate();
    if (!isInPlay() || !update.frame) return;
    if (m_state == PlayState::Preparing && !m_isWaitingForBakes) {
        m_scene = update.frame->played;
        clearResults();
        emit eventsChanged();
        setState(m_startsPlaying ? PlayState::Playing : PlayState::Paused);
    }
    const bool haveEventsChanged = applyEvents(update);
    if (update.discardAfter) {
        std::erase_if(m_costs, [&](const StepCost& cost) { return cost.step > *update.discardAfter; });
    }
    m_costs.insert(m_costs.end(), update.costs.begin(), update.costs.end());
    if (m_costs.size() > kShownCosts) m_costs.erase(m_costs.begin(), m_costs.end() - kShownCosts);
    if (update.shot) m_lastShot = update.shot;
    m_frame = std::move(update.frame);
    if (!m_frame->isRecorded && m_soughtStep == m_frame->step) m_soughtStep.reset();
    applyDestruction(*m_frame);
    for (const Diagnostic& diagnostic : update.diagnostics)
        emit statusMessage(QString::fromStdString(diagnostic.message));
    if (update.isBranchKept)
        emit statusMessage(tr("The earlier timeline is kept: see Play ▸ Timeline ▸ Earlier Timelines."));
    if (haveEventsChanged) emit eventsChanged();
    emit frameChanged();
    if (update.isReplayOver && m_state == PlayState::Playing) {
        pause();
        emit statusMessage(tr("The replay has ended. Resume to simulate on from here."));
    }
}

}  // namespace rubble

#include "moc_PlayController.cpp"
