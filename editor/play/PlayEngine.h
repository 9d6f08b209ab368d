#pragma once

#include "core/play/session/Replay.h"
#include "core/play/session/SavedSession.h"
#include "editor/play/EventLog.h"
#include "editor/play/PlayFrame.h"
#include "editor/play/PlayToolSettings.h"
#include "editor/play/RecordedFrames.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <map>

namespace rubble {

/// The inputs of a session: none, or recorded ones.
struct PlayScript {
    SessionSettings settings;
    std::vector<TimedInput> inputs;  // ascending step
    std::uint64_t steps = 0;
    std::uint64_t begin = 0;                    // the step that is displayed first
    std::vector<std::uint64_t> hashes;          // recorded state hashes of the steps; empty: unknown
    std::shared_ptr<const SavedSession> state;  // that it starts from; null: from the start
};
PlayScript scriptOf(const Replay& replay);
/// The session that a script starts with. The pending inputs of a state become inputs of the script, before its own of
/// the same step.
///
/// Errors: those of Session::start() and resumedSession().
Result<Session> startOf(const std::shared_ptr<const PlayScene>& scene, PlayScript& script);
/// The shots of a play-test for its duration, displayed from step `begin` on. `state`: what it starts from.
PlayScript scriptOf(const Project& project, const PlayTest& test, std::uint64_t begin,
                    std::shared_ptr<const SavedSession> state = nullptr);

/// From half a second before a step until a second after it; `dt` is the length of a step, s.
PlayLoop loopAround(std::uint64_t step, double dt);

/// An interactive session: applies user input and collects updates for display. It counts steps, independently of
/// wall-clock time. Not thread-safe.
class PlayEngine {
public:
    /// Errors: those of Session::start(), resumedSession() and Timeline::seek().
    static Result<std::unique_ptr<PlayEngine>> create(const std::shared_ptr<const PlayScene>& scene, PlayScript script,
                                                      const TaskContext& task = {});

    const Timeline& timeline() const { return m_timeline; }
    const Session& session() const { return m_timeline.session(); }
    /// Whether bodies can break from this step on.
    bool hasDestruction() const;

    void step();
    /// Plays the next step, or jumps from the end of the loop to its start. Returns whether it was a step.
    bool advance();
    /// Sets or ends the loop, which a shot ends, too. It ends with the script at the latest.
    void setLoop(std::optional<PlayLoop> loop);
    /// Goes back to the first step without inputs; a course that had some becomes a branch.
    void startOver();
    /// Exchanges the current course with a branch and goes to their fork.
    void switchTo(std::uint32_t branch);
    void seek(std::uint64_t step, const TaskContext& task);
    /// An invalid input becomes a diagnostic.
    void add(const PlayInput& input);
    void fire(const std::string& name, const ShotAction& action);
    /// Each acts on the first hit of a ray from the eye.
    void throwAlong(const ChargedThrow& thrown, const Ray& ray);
    void hammerAlong(double impulse, std::optional<double> radius, const Ray& ray);
    void blastAlong(const Blast& blast, const Ray& ray);
    /// Grabs the body hit by the ray and drags it along with later rays, at the same distance.
    void grabAlong(double force, const Ray& ray);
    void dragAlong(const Ray& ray);
    void release();
    /// Takes the instance that the ray hits away: what holds together there or, of a bonded one, the fragment.
    void removeAlong(RemovalExtent removal, const Ray& ray);
    /// Sets the throw whose trajectory and forecast are shown; nullopt shows none.
    void aim(std::optional<ChargedThrow> thrown, const Ray& ray);

    /// Sets the overlays. Heat shows the break forecast of the aimed throw; without one, the recent impacts. Updates
    /// order the forecasts, see setForecast().
    void setOverlays(const PlayOverlays& overlays);
    /// Shows a forecast, unless another throw is aimed by now.
    void setForecast(const Throw& thrown, const std::vector<BodyForecast>& bodies);

    /// Whether the last step of the script has just been played.
    bool isAtScriptEnd() const { return !m_loop && m_scriptSteps > 0 && session().stepsDone() == m_scriptSteps; }

    /// Whether no further step would change what is shown, until the next input: the session is at rest at the end of
    /// its timeline, for long enough that dust and what overlays show of impacts are gone.
    bool isAtRest() const;

    /// Returns and clears the pending update, with the current frame.
    PlayUpdate takeUpdate();
    /// The steps of the current course that were played, for any thread.
    std::shared_ptr<const RecordedFrames> recordedFrames() const { return m_recorded; }

private:
    PlayEngine(const std::shared_ptr<const PlayScene>& scene, Timeline timeline, std::vector<std::uint64_t> hashes);
    void recordStep();
    void recordFrame();
    void report(DiagnosticCode code, std::string message);
    PlayFrame frame();
    Throw throwOf(const ChargedThrow& charged, const Ray& ray) const;
    void discardRecordsAfter(std::uint64_t step);
    void keepLog(std::uint32_t course);
    std::vector<PlayBranch> branches() const;
    void orderForecast(const std::optional<Throw>& thrown);
    std::optional<BodyPart> aimedPart() const;
    void forecastCollapse();

    struct Aim {
        ChargedThrow thrown;
        Ray ray;
    };

    std::shared_ptr<const PlayScene> m_scene;
    Timeline m_timeline;
    SessionSceneBuilder m_builder;
    std::shared_ptr<RecordedFrames> m_recorded;
    std::vector<std::uint64_t> m_hashes;  // of the script
    bool m_startsWithDestruction = true;
    EventLog m_log;                                  // of the current course
    std::map<std::uint32_t, EventLog> m_branchLogs;  // by branch
    std::optional<PlayLoop> m_loop;
    std::optional<Aim> m_aim;
    bool m_hasCollapse = false;  // the collapse overlay is on
    std::optional<CollapseForecast> m_collapse;
    BodyPart m_collapsePart;               // without which it is
    std::uint64_t m_collapseStep = 0;      // of which it is
    bool m_hasHulls = false;               // the overlay is on
    bool m_hasHeat = false;                // the heat overlay is on: it shows what the aimed throw will do
    std::optional<Throw> m_forecastThrow;  // of the newest order
    std::uint64_t m_forecastStep = 0;      // of the newest order
    bool m_hasForecast = false;            // the result of that throw is known
    std::uint64_t m_lastMotion = 0;        // the last step at which the session was not at rest, or was sought
    std::uint64_t m_scriptSteps = 0;       // 0: there is no script, or the user has acted on it
    std::optional<double> m_grabDistance;  // from the eye, m; nothing: no body is grabbed
    PlayUpdate m_update;
};

}  // namespace rubble
