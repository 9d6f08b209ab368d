#include "app/cli/simulation/BodySimulation.h"

#include "core/base/MessageText.h"
#include "core/physics/queries/Penetration.h"

#include <chrono>

namespace rubble {
namespace {

double timedStep(World& world, double dt) {
    const auto start = std::chrono::steady_clock::now();
    world.step(dt);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Removes the bodies that cannot be simulated on.
void removeLost(const BodyScene& scene, int step, SceneWorld& moved, std::vector<Diagnostic>& diagnostics) {
    for (std::size_t k = 0; k < moved.bodies.size(); ++k) {
        const BodyId body = moved.bodies[k];
        if (!moved.world.contains(body) || moved.world.isWithinBounds(body)) continue;
        moved.world.removeBody(body);
        diagnostics.push_back(diagnostic(DiagnosticCode::LeftWorld, {},
                                         quotedName(scene.bodies[k].name) + " was removed at step " +
                                             std::to_string(step) + ": it is farther than " +
                                             messageText(kMaxCoordinate) + " m from the origin."));
    }
}

void addBodies(const BodyScene& scene, const SceneWorld& moved, SimulationOutcome& outcome) {
    std::vector<PosedHulls> placed;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        if (!moved.world.contains(moved.bodies[k])) continue;
        const SceneBody& body = scene.bodies[k];
        const BodyState state = moved.world.state(moved.bodies[k]);
        placed.push_back({scene.shapes[body.shape], state.pose, body.kind == BodyKind::Dynamic});
        outcome.bodies.push_back({body.name, state.pose, state.asleep});
    }
    outcome.largestPenetration = penetrationOf(placed).largest;
}

}  // namespace

Result<SimulationRun> runBodies(const BodyScene& scene, const SimulationPlan& plan, const TaskContext& task,
                                std::vector<Diagnostic>& diagnostics) {
    Result<SceneWorld> moved = makeWorld(scene, plan.world);
    if (!moved) return moved.error();
    StepRecord record(plan);
    for (int step = 1; step <= plan.steps; ++step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const double milliseconds = timedStep(moved->world, plan.stepLength);
        removeLost(scene, step, *moved, diagnostics);
        record.add(step, moved->world, milliseconds);
        task.report(static_cast<double>(step) / plan.steps);
    }
    SimulationRun result;
    result.outcome.steps = static_cast<std::uint64_t>(plan.steps);
    addBodies(scene, *moved, result.outcome);
    result.outcome.counts = record.means();
    result.outcome.hash = moved->world.hash();
    result.outcome.stepMilliseconds = record.milliseconds();
    result.trace = std::move(record).trace();
    return result;
}

}  // namespace rubble
