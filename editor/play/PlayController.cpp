#include "editor/play/PlayController.h"

#include "core/play/LiveInputs.h"

#include <QThread>

#include <algorithm>
#include <future>
#include <utility>

namespace rubble {

PlayController::PlayController(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    connect(&document, &Document::changed, this, &PlayController::follow);
    connect(&bakes, &Bakes::changed, this, &PlayController::tryToStart);
    connect(&m_thread, &PlayThread::hasNews, this, &PlayController::takeNews);
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
        m_isGoingOn = true;
        return prepareAnew();
    }
    m_isGoingOn = true;
    if (m_state == PlayState::Paused) setState(PlayState::Playing);
}

void PlayController::pause() {
    m_isGoingOn = false;
    if (m_state == PlayState::Playing) setState(PlayState::Paused);
}

void PlayController::stop() {
    m_thread.stop();
    m_isWaitingForBakes = false;
    m_waiting.clear();
    m_scene.reset();
    m_frame.reset();
    m_breaks.clear();
    m_costs.clear();
    m_lastShot.reset();
    setState(PlayState::Stopped);
    emit breaksChanged();
}

void PlayController::finish(const QString& sentence) {
    stop();
    emit said(sentence);
}

void PlayController::reset() {
    if (isOn()) prepareAnew();
}

void PlayController::replay(PlayScript script) {
    m_isGoingOn = script.begin == 0;
    prepare(std::move(script));
}

/// Has something done in the play, or in the one that will begin.
void PlayController::post(PlayThread::Task task) {
    if (m_isWaitingForBakes) return m_waiting.push_back(std::move(task));
    m_thread.post(std::move(task));
}

void PlayController::stepOnce() {
    if (!isOn()) return;
    pause();
    post([](PlayEngine& engine) { engine.step(); });
}

void PlayController::seek(std::uint64_t step) {
    if (!isUnderWay()) return;
    pause();
    m_thread.seek(step);
}

void PlayController::setTimeScale(double scale) {
    if (m_timeScale == scale) return;
    m_timeScale = scale;
    m_thread.setTimeScale(scale);
    emit rulesChanged();
}

void PlayController::setDestruction(bool isOn) {
    if (m_hasDestruction == isOn) return;
    m_hasDestruction = isOn;
    if (this->isOn()) m_askedDestruction = isOn;
    post([isOn](PlayEngine& engine) { engine.add(DestructionInput{isOn}); });
    emit rulesChanged();
}

void PlayController::setOverlays(const PlayOverlays& overlays) {
    if (m_overlays == overlays) return;
    m_overlays = overlays;
    post([overlays](PlayEngine& engine) { engine.setOverlays(overlays); });
    emit rulesChanged();
}

void PlayController::setTools(const PlayTools& tools) {
    if (m_tools == tools) return;
    m_tools = tools;
    emit toolsChanged();
}

namespace {

Throw charged(Throw thrown, double charge) {
    thrown.speed *= charge;
    return thrown;
}

}  // namespace

void PlayController::aim(const std::optional<Ray>& ray, double charge) {
    std::optional<Throw> thrown;
    if (ray) thrown = charged(m_tools.thrown, charge);
    post([thrown, ray](PlayEngine& engine) { engine.aim(thrown, ray.value_or(Ray{})); });
}

void PlayController::throwAlong(const Ray& ray, double charge) {
    post([thrown = charged(m_tools.thrown, charge), ray](PlayEngine& engine) { engine.throwAlong(thrown, ray); });
}

void PlayController::strikeAlong(const Ray& ray) {
    post([blow = m_tools.blow, ray](PlayEngine& engine) { engine.strikeAlong(blow, ray); });
}

void PlayController::blastAlong(const Ray& ray) {
    post([blast = m_tools.blast, ray](PlayEngine& engine) { engine.blastAlong(blast, ray); });
}

void PlayController::grabAlong(const Ray& ray) {
    post([grip = m_tools.grip, ray](PlayEngine& engine) { engine.grabAlong(grip, ray); });
}

void PlayController::dragAlong(const Ray& ray) {
    post([ray](PlayEngine& engine) { engine.dragAlong(ray); });
}

void PlayController::letGo() {
    post([](PlayEngine& engine) { engine.letGo(); });
}

void PlayController::fire(const Shot& shot) {
    post([shot](PlayEngine& engine) { engine.fire(shot.name, shot.action); });
}

PlayScript PlayController::script() {
    if (!isUnderWay()) return {};  // then nobody would answer
    std::promise<PlayScript> told;
    m_thread.post([&told, settings = m_script.settings](PlayEngine& engine) {
        told.set_value(
            {.settings = settings, .inputs = engine.timeline().inputs(), .steps = engine.timeline().length()});
    });
    return told.get_future().get();
}

void PlayController::prepareAnew() {
    prepare({.settings = {.hasDestruction = m_hasDestruction, .threads = QThread::idealThreadCount()}});
}

void PlayController::prepare(PlayScript script) {
    m_script = std::move(script);
    m_waiting.clear();
    m_askedDestruction.reset();
    setState(PlayState::Preparing);
    m_isWaitingForBakes = true;
    tryToStart();
}

/// Begins as soon as all assets are baked as they are now.
void PlayController::tryToStart() {
    if (!m_isWaitingForBakes || !m_bakes.areCurrent(m_document.project())) return;
    m_isWaitingForBakes = false;
    m_played = m_begunWith = m_document.project();
    m_thread.start([project = m_played, bakes = m_bakes.assetBakes(), script = m_script,
                    overlays = m_overlays](const TaskContext& task) -> Result<std::unique_ptr<PlayEngine>> {
        const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, bakes, task);
        if (!scene) return scene.error();
        Result<std::unique_ptr<PlayEngine>> engine = PlayEngine::started(*scene, script, task);
        if (engine) (*engine)->setOverlays(overlays);
        return engine;
    });
    for (PlayThread::Task& task : m_waiting) m_thread.post(std::move(task));
    m_waiting.clear();
}

void PlayController::follow() {
    if (!isOn()) return;
    if (m_isWaitingForBakes) return tryToStart();
    const std::optional<std::vector<PlayInput>> inputs = liveInputs(m_played, m_document.project());
    if (!inputs) return prepareAnew();
    m_played = m_document.project();
    for (const PlayInput& input : *inputs) post([input](PlayEngine& engine) { engine.add(input); });
}

double PlayController::share() const {
    if (!m_frame || m_frame->shownFor <= 0.0) return 1.0;
    return std::clamp((m_thread.now() - m_frame->shownFrom) / m_frame->shownFor, 0.0, 1.0);
}

/// What the user has asked for is so, though older moments that are still to come do not know of it.
void PlayController::takeDestruction(const PlayFrame& frame) {
    if (m_isWaitingForBakes || (m_askedDestruction && *m_askedDestruction != frame.hasDestruction)) return;
    m_askedDestruction.reset();
    if (std::exchange(m_hasDestruction, frame.hasDestruction) != frame.hasDestruction) emit rulesChanged();
}

void PlayController::takeNews() {
    PlayNews news = m_thread.takeNews();
    if (!isOn() || !news.frame) return;
    if (m_state == PlayState::Preparing && !m_isWaitingForBakes) {
        m_scene = news.frame->played;
        m_breaks.clear();
        m_costs.clear();
        m_lastShot.reset();
        emit breaksChanged();
        setState(m_isGoingOn ? PlayState::Playing : PlayState::Paused);
    }
    const bool areBreaksOther = !news.breaks.empty() || news.forgetBeyond;
    if (news.forgetBeyond) {
        std::erase_if(m_breaks, [&](const ToldBreak& one) { return one.step > *news.forgetBeyond; });
        std::erase_if(m_costs, [&](const StepCost& one) { return one.step > *news.forgetBeyond; });
    }
    m_breaks.insert(m_breaks.end(), news.breaks.begin(), news.breaks.end());
    m_costs.insert(m_costs.end(), news.costs.begin(), news.costs.end());
    if (m_costs.size() > kShownCosts) m_costs.erase(m_costs.begin(), m_costs.end() - kShownCosts);
    if (news.shot) m_lastShot = news.shot;
    m_frame = std::move(news.frame);
    takeDestruction(*m_frame);
    for (const std::string& notice : news.notices) emit said(QString::fromStdString(notice));
    if (areBreaksOther) emit breaksChanged();
    emit framed();
}

}  // namespace rubble
