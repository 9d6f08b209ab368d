#pragma once

#include "tests/support/asset/Projects.h"

namespace rubble::test {

/// A comb with teeth 1 m wide and 1 m apart; each needs its own hull.
inline Polygon comb(int teeth) {
    Polygon outline;
    outline.outer = {{0.0, 0.0}, {2.0 * teeth - 1.0, 0.0}};
    for (int k = teeth - 1; k >= 0; --k) {
        const double left = 2.0 * k, right = left + 1.0;
        if (k < teeth - 1) outline.outer.push_back({right, 1.0});
        outline.outer.push_back({right, 3.0});
        outline.outer.push_back({left, 3.0});
        if (k > 0) outline.outer.push_back({left, 1.0});
    }
    return outline;
}

/// A project with a comb of 20 teeth, in one piece, as asset 2.
inline Project combProject() {
    Project project = boxProject(PlacedSeeds{{{0, {0.5, 0.5}}}});
    project.assets[0].prism().outline = comb(20);
    return project;
}

}  // namespace rubble::test
