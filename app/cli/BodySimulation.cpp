#include "app/cli/BodySimulation.h"

#include "core/base/Percentile.h"
#include "core/io/NumberText.h"
#include "core/physics/Penetration.h"

#include <algorithm>
#include <chrono>
#include <initializer_list>

namespace rubble {
namespace {

constexpr int kCountedSteps = 120;  // at the end: the counts told are means over these

constexpr const char* kTitles = "step,time,awake,pairs,contacts,points,kinetic,potential";
constexpr const char* kTimeTitles =
    ",pairsMilliseconds,collideMilliseconds,prepareMilliseconds,solveMilliseconds,finishMilliseconds";

void appendRow(std::string& csv, std::initializer_list<double> values) {
    bool isFirst = true;
    for (const double value : values) {
        if (!isFirst) csv += ',';
        isFirst = false;
        appendNumber(csv, value);
    }
}

/// What a simulation keeps of its steps.
class StepRecord {
public:
    explicit StepRecord(const SimulationPlan& plan) : m_plan(plan) {
        if (plan.isTraced) m_trace = std::string(kTitles) + (plan.isTimed ? kTimeTitles : "") + "\n";
    }

    void add(int step, const World& world, double milliseconds) {
        if (m_plan.isTimed) m_milliseconds.push_back(milliseconds);
        if (step > m_plan.steps - kCountedSteps) {
            m_sums.bodies += world.counts().bodies;
            m_sums.pairs += world.counts().candidatePairs;
            m_sums.contactPoints += world.counts().contactPoints;
        }
        if (m_plan.isTraced) trace(step, world);
    }

    SimulatedCounts means() const {
        const double steps = std::min(m_plan.steps, kCountedSteps);
        return {m_sums.bodies / steps, m_sums.pairs / steps, m_sums.contactPoints / steps};
    }
    std::optional<StepMilliseconds> milliseconds() const {
        if (m_milliseconds.empty()) return std::nullopt;
        return StepMilliseconds{percentile(m_milliseconds, 0.5), percentile(m_milliseconds, 0.99),
                                percentile(m_milliseconds, 1.0)};
    }
    std::string takenTrace() && { return std::move(m_trace); }

private:
    void trace(int step, const World& world) {
        const StepCounts& counts = world.counts();
        const Momenta momenta = world.momenta();
        appendRow(m_trace, {static_cast<double>(step), step * m_plan.stepLength, static_cast<double>(counts.awake),
                            static_cast<double>(counts.candidatePairs), static_cast<double>(counts.contacts),
                            static_cast<double>(counts.contactPoints), momenta.kinetic, momenta.potential});
        if (m_plan.isTimed) {
            const StepTimes& times = world.times();
            m_trace += ',';
            appendRow(m_trace, {times.pairs, times.collide, times.prepare, times.solve, times.finish});
        }
        m_trace += '\n';
    }

    const SimulationPlan& m_plan;
    SimulatedCounts m_sums;
    std::vector<double> m_milliseconds;
    std::string m_trace;
};

double timedStep(World& world, double dt) {
    const auto start = std::chrono::steady_clock::now();
    world.step(dt);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void tellBodies(const BodyScene& scene, const SceneWorld& moved, SimulationOutcome& outcome) {
    std::vector<Pose> poses;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        const BodyState state = moved.world.state(moved.bodies[k]);
        poses.push_back(state.pose);
        outcome.bodies.push_back({scene.bodies[k].name, state.pose, state.asleep});
    }
    outcome.largestPenetration = penetrationOf(scene, poses).largest;
}

}  // namespace

Result<BodySimulation> simulated(const BodyScene& scene, const SimulationPlan& plan, const TaskContext& task) {
    Result<SceneWorld> moved = makeWorld(scene, plan.world);
    if (!moved) return moved.error();
    StepRecord record(plan);
    for (int step = 1; step <= plan.steps; ++step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const double milliseconds = timedStep(moved->world, plan.stepLength);
        record.add(step, moved->world, milliseconds);
        task.report(static_cast<double>(step) / plan.steps);
    }
    BodySimulation result;
    result.outcome.steps = static_cast<std::uint64_t>(plan.steps);
    tellBodies(scene, *moved, result.outcome);
    result.outcome.counts = record.means();
    result.outcome.hash = moved->world.hash();
    result.outcome.stepMilliseconds = record.milliseconds();
    result.trace = std::move(record).takenTrace();
    return result;
}

}  // namespace rubble
