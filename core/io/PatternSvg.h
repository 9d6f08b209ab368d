#pragma once

#include "core/fracture/Partition.h"
#include "core/fracture/Prism.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// One pattern on a sheet: an outline, what it is cut by and what it is cut into.
struct PatternPanel {
    std::string title;
    Prism prism;
    std::vector<Vec2> seeds;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // of seeds; see triangleList()
    Partition partition;                                  // of the prism's outline
};

/// What is drawn of every pattern, beside its outline.
struct PatternShown {
    bool cells = true;
    bool triangles = true;
    bool seeds = true;
};

/// Draws patterns as one SVG picture, up to three in a row (one alone twice as large), y up, each as large as its column
/// allows and with a scale bar of its own, above a legend. Neighbouring cells differ in colour; seeds that have no cell are rings; what lies
/// outside a panel is clipped. Coordinates have two decimals of a pixel. Same panels, same bytes.
std::string patternSvg(std::span<const PatternPanel> panels, const PatternShown& shown = {});

}  // namespace rubble
