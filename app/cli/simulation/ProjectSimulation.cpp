#include "app/cli/simulation/ProjectSimulation.h"

#include "core/base/Version.h"
#include "core/io/play/EventsJson.h"
#include "core/io/play/ReplayFile.h"
#include "core/physics/queries/Penetration.h"
#include "core/sound/session/SoundRecorder.h"

#include <chrono>

namespace rubble {
namespace {

SimulatedBreak toResult(const PlayBreak& broken, const Session& session, bool isTimed) {
    SimulatedBreak result{broken.step,  session.nameOf(broken.body), broken.impact, broken.threshold,
                          broken.point, broken.fragmentCount};
    if (isTimed) result.swapMilliseconds = broken.milliseconds;
    return result;
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

}  // namespace

Result<SimulationRun> runProject(const PreparedProject& project, const PlayPlan& plan, const TaskContext& task,
                                 std::vector<Diagnostic>& diagnostics) {
    Result<Session> session = createSession(project, plan.play, plan.simulation.world.threads);
    if (!session) return session.error();
    StepRecord record(plan.simulation);
    ReplayRecorder recorder(*session, programVersion(), projectHash(session->scene().project));
    ReplaySize recorded;
    SoundRecorder heard(*session);
    SimulationRun run;
    for (int step = 1; step <= plan.simulation.steps; ++step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const auto start = std::chrono::steady_clock::now();
        session->step();
        const auto end = std::chrono::steady_clock::now();
        record.add(step, session->world(), std::chrono::duration<double, std::milli>(end - start).count());
        if (plan.isRecorded) {
            recorder.add(*session);
            if (const Status fits = recorded.add(recorder.replay()); !fits) return fits.error();
        }
        if (plan.hasEvents) run.events += eventLines(session->stepsDone(), session->events().told);
        if (plan.isHeard) heard.add(*session);
        for (const PlayBreak& broken : session->events().breaks) {
            run.outcome.breaks.push_back(toResult(broken, *session, plan.simulation.isTimed));
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
    if (plan.isRecorded) run.replay = recorder.replay();
    if (!plan.isHeard) return run;
    Result<StereoTrack> sound = heard.track();
    if (!sound) return sound.error();
    run.sound = std::move(*sound);
    return run;
}

}  // namespace rubble
