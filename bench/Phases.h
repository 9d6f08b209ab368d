#pragma once

#include "bench/Timing.h"
#include "core/physics/world/BodyScene.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace rubble::bench {

/// Consecutive steps of 1/60 s of a scene that begins in motion.
struct Phase {
    const char* name;
    std::size_t begin, end;
};
inline constexpr std::array<Phase, 4> kPhases{
    {{"burst", 0, 5}, {"flight", 5, 30}, {"landing", 30, 60}, {"settling", 60, 120}}};

/// The steps of a scene: of each, the fastest of all rounds counts.
struct PhaseTimes {
    std::vector<double> steps;  // ms, of one thread, in time of the processor

    double mean(const Phase& phase) const {
        return std::accumulate(at(phase.begin), at(phase.end), 0.0) / static_cast<double>(phase.end - phase.begin);
    }
    double worst(const Phase& phase) const { return *std::max_element(at(phase.begin), at(phase.end)); }

private:
    std::vector<double>::const_iterator at(std::size_t step) const {
        return steps.begin() + static_cast<std::ptrdiff_t>(step);
    }
};

/// What is left after the last step.
struct PhaseResult {
    PhaseTimes times;
    Penetration overlap;
    double lowest = 1e30;  // m: the lowest origin of a body
};

/// Plays a scene. `Bodies` has a constructor for a scene, step(dt) and poses().
template <class Bodies>
void playPhases(const BodyScene& scene, PhaseResult& result) {
    constexpr double kStep = 1.0 / 60.0;  // s
    Bodies bodies(scene);
    result.times.steps.resize(kPhases.back().end, 1e30);
    for (double& time : result.times.steps) time = std::min(time, processorMillisecondsOf([&] { bodies.step(kStep); }));
    const std::vector<Pose> poses = bodies.poses();
    result.overlap = penetrationOf(scene, poses);
    for (std::size_t k = 0; k < poses.size(); ++k) {
        if (scene.bodies[k].kind == BodyKind::Dynamic) result.lowest = std::min(result.lowest, poses[k].position.y);
    }
}

/// One row for each phase: ours, then mean and worst of each peer and their ratio to ours.
inline void printPhases(const std::string& scene, std::size_t bodies,
                        const std::vector<std::pair<std::string, PhaseResult>>& all) {
    const PhaseResult& ours = all.front().second;
    for (const Phase& phase : kPhases) {
        std::printf("| %s | %zu | %s |", scene.c_str(), bodies, phase.name);
        for (const auto& [name, result] : all) {
            const double mean = result.times.mean(phase), worst = result.times.worst(phase);
            std::printf(" %.2f / %.2f |", mean, worst);
            if (&result != &ours)
                std::printf(" %.2f / %.2f |", mean / ours.times.mean(phase), worst / ours.times.worst(phase));
        }
        std::printf("\n");
    }
    for (const auto& [name, result] : all)
        std::printf("  %s: overlap %.1f mm at most, %.2f mean; lowest at %.2f m\n", name.c_str(),
                    1e3 * result.overlap.largest, 1e3 * result.overlap.mean, result.lowest);
    std::fflush(stdout);
}

}  // namespace rubble::bench
