#pragma once

#include "tests/support/Projects.h"

namespace rubble::test {

/// A bar with teeth 1 m wide and 1 m apart, which a hull each takes.
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

/// One of 20 teeth as asset 2, in one piece.
inline Project combProject() {
    Project project = boxProject(PlacedSeeds{{{0, {0.5, 0.5}}}});
    project.assets[0].prism.outline = comb(20);
    return project;
}

}  // namespace rubble::test
