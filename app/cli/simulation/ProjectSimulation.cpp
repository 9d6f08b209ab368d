#include "app/cli/simulation/ProjectSimulation.h"

#include "core/base/QuantityText.h"
#include "core/base/Version.h"
#include "core/io/play/EventStreamFile.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/physics/queries/Penetration.h"
#include "core/play/session/SessionRemap.h"
#include "core/sound/session/SoundRecorder.h"

#include <algorithm>
#include <chrono>
#include <iterator>

namespace rubble {
namespace {

SimulatedBreak toResult(const PlayBreak& broken, const Session& session, bool isTimed) {
    SimulatedBreak result{broken.step,  session.nameOf(broken.body), broken.impact, broken.threshold,
                          broken.point, broken.fragmentCount};
    if (isTimed) result.swapMilliseconds = broken.milliseconds;
    return result;
}

SimulatedSplit toResult(const PlaySplit& split, const Session& session) {
    return {split.step, session.nameOf(split.body), split.impulse, split.point, split.bonds,
            split.area, split.freed.size()};
}

void addBodies(const Session& session, SimulationOutcome& outcome) {
    std::vector<std::vector<Polytope>> hulls;
    std::vector<PosedHulls> placed;
    for (const PlayBody& body : session.bodies()) {
        const BodyState state = session.world().state(body.body);
        hulls.push_back(hullsOf(body));
        placed.push_back({.pose = state.pose, .isDynamic = session.world().kind(body.body) == BodyKind::Dynamic});
        if (body.role != PlayRole::Ground) outcome.bodies.push_back({session.nameOf(body), state.pose, state.asleep});
    }
    for (std::size_t k = 0; k < placed.size(); ++k) placed[k].hulls = hulls[k];
    outcome.largestPenetration = penetrationOf(placed).largest;
}

/// The session to simulate: at its start, or at the moment of a state, from which the times of its shots count.
Result<Session> sessionOf(const PreparedProject& project, const PlayPlan& plan) {
    const int threads = plan.simulation.world.threads;
    if (plan.state.empty()) return createSession(project, plan.play, threads);
    Result<Session> session = loadState(plan.state, project.scene, {.threads = threads});
    if (!session) return session.error();
    for (const Shot& shot : project.shots) {
        if (const Status added = session->add(shot); !added) return added.error();
    }
    return session;
}

/// A session with the damage of a state of an earlier version of the project. What got lost is added to `notes`.
Result<Session> damagedSession(const PreparedProject& project, const PlayPlan& plan, const TaskContext& task,
                               std::vector<std::string>& notes) {
    const Result<Project> before = loadProject(plan.remapped);
    if (!before) return before.error();
    const Result<std::shared_ptr<const PlayScene>> scene =
        playScene(*before, {.cancel = task.cancel, .threads = task.threads});
    if (!scene) return scene.error();
    const Result<Session> saved = loadState(plan.state, *scene);
    if (!saved) return saved.error();
    const Result<RemappedSession> mapped = remappedSession(*saved, *project.scene);
    if (!mapped) return mapped.error();
    Result<Session> session = createSession(project, plan.play, plan.simulation.world.threads);
    if (!session) return session.error();
    if (const Status applied = session->apply(mapped->damage); !applied) return applied.error();
    notes = mapped->losses;
    return session;
}

/// What a small state does not hold of a session, a sentence each.
std::vector<std::string> lossesOf(const Session& session) {
    std::vector<std::string> losses;
    const auto isMoving = [&](const PlayBody& body) {
        const BodyState state = session.world().state(body.body);
        return !state.asleep && (state.velocity != Vec3(0.0) || state.angularVelocity != Vec3(0.0));
    };
    if (const auto moving = std::ranges::count_if(session.bodies(), isMoving); moving > 0) {
        losses.push_back(countText(static_cast<std::size_t>(moving), "body was", "bodies were") +
                         " still moving; the small state holds where they were, at rest.");
    }
    if (const std::size_t pending = session.snapshot()->state.pending.size(); pending > 0) {
        losses.push_back(countText(pending, "shot is", "shots are") +
                         " still to come; the small state does not hold them.");
    }
    return losses;
}

Status saveResult(const PlayPlan& plan, const Session& session, SimulationRun& run) {
    if (plan.savedState.empty()) return success();
    if (plan.savedKind == StateKind::Small) std::ranges::copy(lossesOf(session), std::back_inserter(run.notes));
    return saveState(plan.savedState, session, plan.savedKind);
}

/// What is recorded of a session, step by step.
class SessionRecord {
public:
    SessionRecord(const PlayPlan& plan, const Session& session)
        : m_plan(plan),
          m_steps(plan.simulation),
          m_listener(frontListener(session)),
          m_tracks(recorderFor(plan.animation, session)) {
        if (plan.isRecorded) m_replay.emplace(session, programVersion(), projectHash(session.scene().project));
        if (plan.events == EventsFormat::Stream) {
            m_stream.emplace(session);
        } else if (plan.events) {
            m_reported.emplace(*plan.events);
        }
    }

    /// Adds a step that was played in some milliseconds.
    ///
    /// Errors: Limit where a recording is too large.
    Status add(int step, const Session& session, double milliseconds) {
        m_steps.add(step, session.world(), milliseconds, m_plan.simulation.isTraced ? session.heldPotential() : 0.0);
        if (m_reported) m_reported->add(session.stepsDone(), session.events().report);
        if (m_stream) m_stream->add(session);
        if (m_plan.isHeard) m_heard.add(session);
        if (m_replay) {
            m_replay->add(session);
            if (const Status fits = m_replaySize.add(m_replay->replay()); !fits) return fits;
        }
        return m_tracks ? m_tracks->add(session) : success();
    }
    /// Errors: those of SoundRecorder::track().
    Status finish(SimulationRun& run) && {
        run.outcome.counts = m_steps.means();
        run.outcome.stepMilliseconds = m_steps.milliseconds();
        run.trace = std::move(m_steps).trace();
        if (m_replay) run.replay = m_replay->replay();
        if (m_reported) run.events = std::move(*m_reported).finished();
        if (m_stream) run.events = m_stream->take();
        if (m_tracks) run.tracks = std::move(*m_tracks).tracks();
        if (!m_plan.isHeard) return success();
        Result<StereoTrack> sound = m_heard.track(m_listener);
        if (!sound) return sound.error();
        run.sound = std::move(*sound);
        return success();
    }

private:
    const PlayPlan& m_plan;
    StepRecord m_steps;
    Listener m_listener;
    std::optional<TrackRecorder> m_tracks;
    SoundRecorder m_heard;
    std::optional<ReplayRecorder> m_replay;
    ReplaySize m_replaySize;
    std::optional<EventsText> m_reported;  // of version 1
    std::optional<EventStreamText> m_stream;
};

/// Adds what broke in the last step of a session to a result, and what it reports to `diagnostics`.
void addBreaks(const Session& session, const PlayPlan& plan, SimulationOutcome& outcome,
               std::vector<Diagnostic>& diagnostics) {
    for (const PlayBreak& broken : session.events().breaks)
        outcome.breaks.push_back(toResult(broken, session, plan.simulation.isTimed));
    for (const PlaySplit& split : session.events().splits)
        if (split.bonds > 0 || !split.freed.empty()) outcome.splits.push_back(toResult(split, session));
    const std::vector<Diagnostic>& reported = session.events().diagnostics;
    diagnostics.insert(diagnostics.end(), reported.begin(), reported.end());
}

}  // namespace

Result<SimulationRun> runProject(const PreparedProject& project, const PlayPlan& plan, const TaskContext& task,
                                 std::vector<Diagnostic>& diagnostics) {
    SimulationRun run;
    Result<Session> session =
        plan.remapped.empty() ? sessionOf(project, plan) : damagedSession(project, plan, task, run.notes);
    if (!session) return session.error();
    SessionRecord record(plan, *session);
    for (int step = 1; step <= plan.simulation.steps; ++step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const auto start = std::chrono::steady_clock::now();
        session->step();
        const auto end = std::chrono::steady_clock::now();
        const double milliseconds = std::chrono::duration<double, std::milli>(end - start).count();
        if (const Status added = record.add(step, *session, milliseconds); !added) return added.error();
        addBreaks(*session, plan, run.outcome, diagnostics);
        task.report(static_cast<double>(step) / plan.simulation.steps);
    }
    run.outcome.steps = static_cast<std::uint64_t>(plan.simulation.steps);
    addBodies(*session, run.outcome);
    run.outcome.hash = session->hash();
    if (const Status finished = std::move(record).finish(run); !finished) return finished.error();
    if (const Status saved = saveResult(plan, *session, run); !saved) return saved.error();
    return run;
}

}  // namespace rubble
