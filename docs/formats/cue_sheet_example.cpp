// Prints when which sound starts, and how loud: a cue sheet of events.
// c++ -std=c++17 cue_sheet_example.cpp -o cue_sheet_example
#include "rubble_pack.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

constexpr double kSilent = -60.0;  // dB below the loudest: no cue

bool isHeard(const rubble_pack::Event& event) {
    return event.energy > 0.0 && event.kind != rubble_pack::EventKind::Settled &&
           event.kind != rubble_pack::EventKind::Removed;
}

const char* soundOf(rubble_pack::EventKind kind) { return kind == rubble_pack::EventKind::Impact ? "hit" : "crack"; }

}  // namespace

int main(int count, char** arguments) {
    const double dt = count > 2 ? std::atof(arguments[2]) : 1.0 / 60.0;
    if (count < 2 || count > 3 || !(dt > 0.0)) {
        std::fprintf(stderr, "usage: cue_sheet_example events.jsonl [seconds per step]\n");
        return 2;
    }
    rubble_pack::EventLog log;
    std::string fault;
    if (!rubble_pack::loadEvents(arguments[1], log, fault)) {
        std::fprintf(stderr, "%s\n", fault.c_str());
        return 1;
    }
    double loudest = 0.0;
    for (const rubble_pack::Event& event : log.events) {
        if (isHeard(event)) loudest = std::max(loudest, event.energy);
    }
    std::printf("%10s  %-5s  %-9s  %8s  %12s  %s\n", "time", "sound", "materials", "gain", "energy", "place");
    for (const rubble_pack::Event& event : log.events) {
        if (!isHeard(event)) continue;
        const double gain = 10.0 * std::log10(event.energy / loudest);
        if (gain < kSilent) continue;
        const std::string materials = std::to_string(event.materials[0]) + " + " + std::to_string(event.materials[1]);
        std::printf("%8.3f s  %-5s  %-9s  %5.1f dB  %10.4g J  %.2f %.2f %.2f\n", static_cast<double>(event.step) * dt,
                    soundOf(event.kind), materials.c_str(), gain, event.energy, event.point.x, event.point.y,
                    event.point.z);
    }
    return 0;
}
