// Prints when which sound starts, and how loud: a cue sheet of events, from their file alone.
// c++ -std=c++17 cue_sheet_example.cpp -o cue_sheet_example
#include "rubble_pack.hpp"

#include <cstdio>

namespace {

constexpr double kSilent = -60.0;  // dB below the loudest: no cue

bool isHeard(const rubble_pack::Event& event) {
    return event.energy > 0.0 && event.kind != rubble_pack::EventKind::Settled &&
           event.kind != rubble_pack::EventKind::Removed;
}

const char* soundOf(rubble_pack::EventKind kind) { return kind == rubble_pack::EventKind::Impact ? "hit" : "crack"; }

/// The names of both materials; of what has none, its number.
std::string materialsOf(const rubble_pack::EventLog& log, const rubble_pack::Event& event) {
    std::array<std::string, 2> names;
    for (std::size_t k = 0; k < names.size(); ++k) {
        names[k] = rubble_pack::materialName(log, event.materials[k]);
        if (names[k].empty()) names[k] = std::to_string(event.materials[k]);
    }
    return names[0] + " + " + names[1];
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: cue_sheet_example events.jsonl\n");
        return 2;
    }
    rubble_pack::EventLog log;
    std::string fault;
    if (!rubble_pack::loadEvents(arguments[1], log, fault)) {
        std::fprintf(stderr, "%s\n", fault.c_str());
        return 1;
    }
    const double dt = log.dt > 0.0 ? log.dt : 1.0 / 60.0;  // version 1 does not have it
    double loudest = 0.0;
    for (const rubble_pack::Event& event : log.events) {
        if (isHeard(event)) loudest = std::max(loudest, event.energy);
    }
    std::printf("%10s  %-5s  %8s  %12s  %-20s  %s\n", "time", "sound", "gain", "energy", "place", "materials");
    for (const rubble_pack::Event& event : log.events) {
        if (!isHeard(event)) continue;
        const double gain = 10.0 * std::log10(event.energy / loudest);
        if (gain < kSilent) continue;
        std::printf("%8.3f s  %-5s  %5.1f dB  %10.4g J  %6.2f %6.2f %6.2f  %s\n", static_cast<double>(event.step) * dt,
                    soundOf(event.kind), gain, event.energy, event.point.x, event.point.y, event.point.z,
                    materialsOf(log, event).c_str());
    }
    return 0;
}
