#pragma once

#include "core/io/play/SimulationJson.h"
#include "core/physics/world/World.h"
#include "core/play/session/Replay.h"
#include "core/play/session/SessionTracks.h"
#include "core/sound/mix/SoundTrack.h"

#include <string>

namespace rubble {

/// The options of a simulation.
struct SimulationPlan {
    int steps = 1;
    double stepLength = 1.0 / 60.0;  // s
    WorldSettings world;
    bool isTraced = false;  // a row of the trace is recorded for each step
    bool isTimed = false;   // durations of steps are recorded
};

/// The result of a simulation.
struct SimulationRun {
    SimulationOutcome outcome;
    std::string trace;   // CSV with a header
    std::string events;  // the text of a file of them
    std::optional<Replay> replay;
    std::optional<StereoTrack> sound;
    std::optional<SessionTracks> tracks;
    std::vector<std::string> notes;  // for the user, a sentence each
};

/// Records counts, durations and the trace of a simulation.
class StepRecord {
public:
    explicit StepRecord(const SimulationPlan& plan);

    /// Records a step, counted from 1. `heldPotential`: potential energy of what is not dynamic yet, J.
    void add(int step, const World& world, double milliseconds, double heldPotential = 0.0);

    /// The mean counts of the last 120 steps.
    SimulatedCounts means() const;
    /// The durations of steps, if they are recorded.
    std::optional<StepMilliseconds> milliseconds() const;
    /// The trace as CSV with a header; empty if it is not recorded.
    std::string trace() && { return std::move(m_trace); }

private:
    void addRow(int step, const World& world, double heldPotential);

    const SimulationPlan& m_plan;
    SimulatedCounts m_sums;
    std::vector<double> m_milliseconds;
    std::string m_trace;
};

}  // namespace rubble
