#pragma once

#include "core/play/session/Session.h"
#include "tests/support/asset/TwoStoreyHouse.h"

#include <string>
#include <utility>
#include <vector>

namespace rubble::bench {

/// Two-storey houses in a row, and what happens to them.
struct HouseRow {
    Project project;
    std::vector<TimedInput> inputs;
};

inline constexpr double kHousesApart = 14.0;  // m

/// The middle one is at x = 0.
inline HouseRow rowOfHouses(int count, double apart = kHousesApart) {
    HouseRow row{.project = test::twoStoreyHouse()};
    const std::vector<Instance> one = row.project.instances;
    row.project.instances.clear();
    row.project.shots.clear();
    row.project.playTests.clear();
    for (int k = 0; k < count; ++k) {
        for (Instance instance : one) {
            instance.id = row.project.nextId++;
            instance.name += " " + std::to_string(k);
            instance.pose.position.x += apart * (k - count / 2);
            row.project.instances.push_back(std::move(instance));
        }
    }
    return row;
}

/// A blast in the porch of the house at x.
inline void blowUp(HouseRow& row, std::uint64_t step, double x = 0.0) {
    TimedInput blast;
    blast.step = step;
    blast.input = ShotInput{"blast", Blast{.at = {x + 1.0, 1.2, 1.5}, .impulse = 8000.0, .radius = 4.0}};
    row.inputs.push_back(std::move(blast));
}

/// Houses apart, and a blast in each of them.
inline HouseRow blownUpHouses(int count, std::uint64_t step) {
    HouseRow row = rowOfHouses(count);
    for (int k = 0; k < count; ++k) blowUp(row, step, kHousesApart * (k - count / 2));
    return row;
}

}  // namespace rubble::bench
