#pragma once

#include "core/base/Hash.h"
#include "core/geometry/predicates/Vec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The final state of a body.
struct SimulatedBody {
    std::string name;
    Pose pose;  // of the frame of its input hulls
    bool isAsleep = false;
};

/// A body that broke into its fragments.
struct SimulatedBreak {
    std::uint64_t step = 0;
    std::string body;
    double impact = 0.0;     // N·s
    double threshold = 0.0;  // N·s
    Vec3 point{0.0, 0.0, 0.0};
    std::uint32_t fragments = 0;
    std::optional<double> swapMilliseconds;  // if measured
};

/// A body whose bonds broke in a step.
struct SimulatedSplit {
    std::uint64_t step = 0;
    std::string body;           // as it was called before
    double impulse = 0.0;       // N·s, that the bonds took; 0: they were mortar, or had lost their support
    Vec3 point{0.0, 0.0, 0.0};  // m, in the world
    std::uint32_t bonds = 0;    // that broke
    double area = 0.0;          // m²: of the faces that they open, of both sides
    std::size_t freed = 0;      // bodies that came free
};

/// Mean counts over the last steps.
struct SimulatedCounts {
    double bodies = 0.0;
    double pairs = 0.0;  // with overlapping bounding boxes
    double contactPoints = 0.0;
};

/// The durations of steps in milliseconds.
struct StepMilliseconds {
    double median = 0.0;
    double p99 = 0.0;
    double max = 0.0;
};

/// The result of a simulation.
struct SimulationOutcome {
    std::uint64_t steps = 0;
    std::vector<SimulatedBody> bodies;  // in input order
    SimulatedCounts counts;
    std::vector<SimulatedBreak> breaks;  // in order of time
    std::vector<SimulatedSplit> splits;  // the same
    double largestPenetration = 0.0;     // m, exact, of the final poses
    ContentHash hash;
    std::optional<StepMilliseconds> stepMilliseconds;
};

/// Returns the result of a simulation as JSON, one body per line:
///
///     {"steps":N,"bodies":[{"name":s,"position":[x,y,z],"orientation":[w,x,y,z],"asleep":false},...],
///      "counts":{"bodies":n,"pairs":n,"contactPoints":n},"swaps":n,
///      "breaks":[{"step":k,"body":s,"impact":J,"threshold":J,"point":[x,y,z],"fragments":n},...],
///      "splits":[{"step":k,"body":s,"impulse":J,"point":[x,y,z],"bonds":n,"area":a,"freed":n},...],
///      "largestPenetration":d,"hash":"...","stepMilliseconds":{"median":t,"p99":t,"max":t}}
///
/// `swaps` is the number of breaks. `stepMilliseconds`, and `swapMilliseconds` of a break, are omitted if not measured.
std::string simulationJson(const SimulationOutcome& outcome);

}  // namespace rubble
