#pragma once

#include "core/fracture/partition/Partition.h"
#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// A pattern of a drawing: an outline, its seeds and its partition; that of a prism, or of a section of a mesh.
struct PatternPanel {
    std::string title;
    std::vector<Polygon> outlines;  // one or more
    double depth = 0.0;             // m, of a prism
    std::string section;            // where a mesh is cut: "z = 0.3 m"; empty: of a prism
    std::vector<Vec2> seeds;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // of seeds; see triangleList()
    Partition partition;                                  // of the outlines
};

/// The parts of a pattern that are drawn beside its outline.
struct PatternSvgOptions {
    bool cells = true;
    bool triangles = true;
    bool seeds = true;
};

/// Draws patterns as an SVG picture, y up, up to three in a row (a single one twice as large), each with a scale bar,
/// above a legend. Neighbouring cells differ in colour; seeds without a cell are rings; panels are clipped. Coordinates
/// have two decimals of a pixel. Equal panels give equal bytes.
std::string patternSvg(std::span<const PatternPanel> panels, const PatternSvgOptions& options = {});

}  // namespace rubble
