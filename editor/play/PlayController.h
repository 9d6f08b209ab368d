#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/play/PlayThread.h"
#include "editor/play/PlayToolSettings.h"
#include "editor/play/ShownEvents.h"

#include <functional>

namespace rubble {

enum class PlayState {
    Stopped,    // the document is shown
    Preparing,  // waiting for bakes and for the session to start
    Paused,
    Playing
};

/// Plays a window's document: drives a play thread as the user commands and the document requires, and holds its
/// results. It never changes the document.
///
/// Input that arrives while it waits for bakes is queued. Edits of the document are applied to the running session
/// where liveInputs() supports them; all others restart it.
class PlayController : public QObject {
    Q_OBJECT
public:
    PlayController(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    PlayState state() const { return m_state; }
    bool isInPlay() const { return m_state != PlayState::Stopped; }
    bool isPlaying() const { return m_state == PlayState::Playing; }
    /// Whether it is playing or paused.
    bool hasSession() const { return m_state == PlayState::Playing || m_state == PlayState::Paused; }
    /// Starts, or resumes.
    void play();
    void pause();
    void stop();
    /// Restarts from the document's state.
    void reset();
    /// Pauses and plays one step.
    void stepOnce();
    /// Pauses at the step before.
    void stepBack() { seekBy(-1); }
    /// Pauses at a step of the timeline.
    void seek(std::uint64_t step);
    /// Pauses that many steps later, within the timeline; counts from a seek that is under way.
    void seekBy(std::int64_t steps);
    /// Pauses at the nearest step before, or after, with an event that the filter selects; stays if there is none.
    void previousEvent();
    void nextEvent();
    /// Plays from half a second before a step until a second after it, again and again.
    void loopAround(std::uint64_t step);
    void endLoop();
    /// Ends the loop, or loops around the break that is nearest to the displayed step.
    void toggleLoop();
    /// Pauses, returns to a branch of the timeline, and keeps the current course as another one.
    void switchTo(std::uint32_t branch);
    /// Pauses at the moment of a saved session of the current document.
    void load(std::shared_ptr<const SavedSession> state);
    /// Plays a script on the current document; paused if its `begin` is not 0.
    void replay(PlayScript script);

    double timeScale() const { return m_timeScale; }
    void setTimeScale(double scale);
    /// The simulated duration of a step, s, of simulations that are not replays. A change restarts the simulation; one
    /// out of range (ProjectNumber::StepLength) is ignored.
    double timeStep() const { return m_timeStep; }
    void setTimeStep(double seconds);
    /// Whether bodies can break, at the displayed step: replays and seeking may switch it.
    bool hasDestruction() const { return m_hasDestruction; }
    /// The settings of the next session.
    SessionSettings nextSettings() const;
    void setDestruction(bool isOn);
    const PlayOverlays& overlays() const { return m_overlays; }
    void setOverlays(const PlayOverlays& overlays);
    /// Whether they are shown at all; initially they are.
    void setOverlaysShown(bool isOn);
    /// Those that are shown now.
    PlayOverlays shownOverlays() const;
    const PlayToolSettings& toolSettings() const { return m_toolSettings; }
    void setToolSettings(const PlayToolSettings& tools);
    /// Whether they are those that the size of the scene suggested when the simulation started.
    bool hasDefaultTools() const { return m_toolSettings == m_defaultTools; }

    /// User input along rays from the eye. `charge` in [0, 1]: 0 is a tapped throw, 1 one of kFullCharge times its
    /// speed.
    void aim(const std::optional<Ray>& ray, double charge = 0.0);
    void throwAlong(const Ray& ray, double charge = 0.0);
    void hammerAlong(const Ray& ray);
    void blastAlong(const Ray& ray);
    void removeAlong(RemovalExtent removal, const Ray& ray);
    void grabAlong(const Ray& ray);
    void dragAlong(const Ray& ray);
    void release();
    /// Fires a shot of the project now.
    void fire(const Shot& shot);
    /// Starts, or restarts from the document's state, and fires a shot before the first step.
    void playShot(const Shot& shot);

    /// The newest frame; nothing before the first.
    const std::optional<PlayFrame>& frame() const { return m_frame; }
    /// The current position between the previous frame and the newest one, in [0, 1].
    double stepFraction() const;
    /// The events of the current course.
    const EventCourse& events() const { return m_events; }
    /// Those that are listed and marked in the timeline: the filter selects them.
    const std::vector<EventRef>& shownEvents() const { return m_shownEvents.events(); }
    const EventFilter& eventFilter() const { return m_shownEvents.filter(); }
    void setEventFilter(const EventFilter& filter);
    /// The costs of the last kShownCosts steps.
    const std::vector<StepCost>& costs() const { return m_costs; }
    const std::optional<ShotInput>& lastShot() const { return m_lastShot; }
    /// The scene being played; null if there is none.
    std::shared_ptr<const PlayScene> scene() const { return m_scene; }
    /// Calls back with the recording so far, once the steps and seeks under way are done; not at all without a session,
    /// or if it ends before.
    void requestScript(std::function<void(PlayScript)> receive);
    /// Whether the session has been simulated from its start, so that it can be replayed.
    bool isFromStart() const { return !m_script.state; }
    /// Calls back with the state of the displayed moment, as requestScript() does.
    void requestState(std::function<void(std::shared_ptr<const SavedSession>)> receive);
    /// The project when play started.
    const Project& startProject() const { return m_startProject; }

    PlayThread& thread() { return m_thread; }
    /// Applies the update of the play thread; called automatically while the event loop runs.
    void applyUpdate();

    static constexpr std::size_t kShownCosts = 300;

signals:
    void stateChanged();
    /// A new frame is available.
    void frameChanged();
    /// The events of the course, or the filter.
    void eventsChanged();
    void toolSettingsChanged();
    /// Time scale, time step, destruction or overlays changed.
    void settingsChanged();
    void statusMessage(const QString& sentence);

private:
    void prepare(PlayScript script);
    void restart();
    void suggestTools();
    void forgetAim();
    void startIfBaked();
    void applyEdits();
    void setState(PlayState state);
    void post(PlayThread::Task task);
    void postOverlays();
    ChargedThrow charged(double charge) const;
    void clearResults();
    bool applyEvents(const PlayUpdate& update);
    void applyDestruction(const PlayFrame& frame);
    void finish(const QString& sentence);

    const Document& m_document;
    const Bakes& m_bakes;
    PlayThread m_thread;
    PlayState m_state = PlayState::Stopped;
    bool m_startsPlaying = true;  // else paused, once it is prepared
    bool m_isWaitingForBakes = false;
    std::vector<PlayThread::Task> m_queuedTasks;  // until the assets are baked
    double m_timeScale = 1.0;
    double m_timeStep = SessionSettings().dt;
    bool m_hasDestruction = true;
    std::optional<bool> m_requestedDestruction;  // not in a frame yet
    std::optional<std::uint64_t> m_soughtStep;   // not in a frame yet
    PlayOverlays m_overlays;
    bool m_areOverlaysShown = true;
    PlayToolSettings m_toolSettings;
    PlayToolSettings m_defaultTools;
    Project m_followedProject;  // whose edits are applied so far
    Project m_startProject;
    PlayScript m_script;  // of the start
    std::shared_ptr<const PlayScene> m_scene;
    std::optional<PlayFrame> m_frame;
    EventCourse m_events;
    ShownEvents m_shownEvents;  // of them
    std::vector<StepCost> m_costs;
    std::optional<ShotInput> m_lastShot;
};

}  // namespace rubble
