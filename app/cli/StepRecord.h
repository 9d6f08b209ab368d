#pragma once

#include "core/io/SimulationJson.h"
#include "core/physics/World.h"
#include "core/play/Replay.h"

#include <string>

namespace rubble {

/// How long, how finely and on what something is simulated.
struct SimulationPlan {
    int steps = 1;
    double stepLength = 1.0 / 60.0;  // s
    WorldSettings world;
    bool isTraced = false;  // a row a step is kept
    bool isTimed = false;   // the outcome and each row tell how long steps took
};

/// What came of it.
struct SimulationRun {
    SimulationOutcome outcome;
    std::string trace;  // CSV with a line of titles
    std::optional<Replay> replay;
};

/// What a simulation keeps of its steps.
class StepRecord {
public:
    explicit StepRecord(const SimulationPlan& plan);

    /// After each step, counted from 1; it took so many milliseconds.
    void add(int step, const World& world, double milliseconds);

    /// Over the last 120 steps.
    SimulatedCounts means() const;
    /// Nothing where the plan is not timed.
    std::optional<StepMilliseconds> milliseconds() const;
    /// CSV with a line of titles; empty where the plan is not traced.
    std::string takenTrace() && { return std::move(m_trace); }

private:
    void trace(int step, const World& world);

    const SimulationPlan& m_plan;
    SimulatedCounts m_sums;
    std::vector<double> m_milliseconds;
    std::string m_trace;
};

}  // namespace rubble
