#include "app/cli/simulation/BodySimulation.h"

#include "core/physics/queries/Penetration.h"

#include <chrono>

namespace rubble {
namespace {

double timedStep(World& world, double dt) {
    const auto start = std::chrono::steady_clock::now();
    world.step(dt);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void addBodies(const BodyScene& scene, const SceneWorld& moved, SimulationOutcome& outcome) {
    std::vector<Pose> poses;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        const BodyState state = moved.world.state(moved.bodies[k]);
        poses.push_back(state.pose);
        outcome.bodies.push_back({scene.bodies[k].name, state.pose, state.asleep});
    }
    outcome.largestPenetration = penetrationOf(scene, poses).largest;
}

}  // namespace

Result<SimulationRun> runBodies(const BodyScene& scene, const SimulationPlan& plan, const TaskContext& task) {
    Result<SceneWorld> moved = makeWorld(scene, plan.world);
    if (!moved) return moved.error();
    StepRecord record(plan);
    for (int step = 1; step <= plan.steps; ++step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const double milliseconds = timedStep(moved->world, plan.stepLength);
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
