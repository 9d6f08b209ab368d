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

}  // namespace

Result<SimulationRun> runProject(const PreparedProject& project, const PlayPlan& plan, const TaskContext& task,
                                 std::vector<Diagnostic>& diagnostics) {
    SimulationRun run;
    Result<Session> session =
        plan.remapped.empty() ? sessionOf(project, plan) : damagedSession(project, plan, task, run.notes);
    if (!session) return session.error();
    StepRecord record(plan.simulation);
    std::optional<ReplayRecorder> recorder;
    if (plan.isRecorded) recorder.emplace(*session, programVersion(), projectHash(session->scene().project));
    ReplaySize recorded;
    SoundRecorder heard;
    const Listener listener = frontListener(*session);
    std::optional<EventsText> told;
    std::optional<EventStreamText> stream;
    if (plan.events == EventsFormat::Stream) {
        stream.emplace(*session);
    } else if (plan.events) {
        told.emplace(*plan.events);
    }
    std::optional<TrackRecorder> tracks = recorderFor(plan.animation, *session);
    for (int step = 1; step <= plan.simulation.steps; ++step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const auto start = std::chrono::steady_clock::now();
        session->step();
        const auto end = std::chrono::steady_clock::now();
        record.add(step, session->world(), std::chrono::duration<double, std::milli>(end - start).count(),
                   plan.simulation.isTraced ? session->heldPotential() : 0.0);
        if (recorder) {
            recorder->add(*session);
            if (const Status fits = recorded.add(recorder->replay()); !fits) return fits.error();
        }
        if (told) told->add(session->stepsDone(), session->events().told);
        if (stream) stream->add(*session);
        if (plan.isHeard) heard.add(*session);
        if (tracks) {
            if (const Status fits = tracks->add(*session); !fits) return fits.error();
        }
        for (const PlayBreak& broken : session->events().breaks) {
            run.outcome.breaks.push_back(toResult(broken, *session, plan.simulation.isTimed));
        }
        for (const PlaySplit& split : session->events().splits) {
            if (split.bonds > 0 || !split.freed.empty()) run.outcome.splits.push_back(toResult(split, *session));
        }
        const std::vector<Diagnostic>& reported = session->events().diagnostics;
        diagnostics.insert(diagnostics.end(), reported.begin(), reported.end());
        task.report(static_cast<double>(step) / plan.simulation.steps);
    }
    run.outcome.steps = static_cast<std::uint64_t>(plan.simulation.steps);
    addBodies(*session, run.outcome);
    run.outcome.counts = record.means();
    run.outcome.hash = session->hash();
    run.outcome.stepMilliseconds = record.milliseconds();
    run.trace = std::move(record).trace();
    if (recorder) run.replay = recorder->replay();
    if (told) run.events = std::move(*told).finished();
    if (stream) run.events = stream->take();
    if (tracks) run.tracks = std::move(*tracks).tracks();
    if (const Status saved = saveResult(plan, *session, run); !saved) return saved.error();
    if (!plan.isHeard) return run;
    Result<StereoTrack> sound = heard.track(listener);
    if (!sound) return sound.error();
    run.sound = std::move(*sound);
    return run;
}

}  // namespace rubble
