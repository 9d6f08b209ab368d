#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// Cracks drawn by hand: lines from point to point. They cut where they enclose a piece together with the outline and
/// other cuts; dangling ends are reported and removed. Their indices are kept when others are deleted.
struct CrackLines {
    struct CrackLine {
        std::uint32_t index = 0;
        std::vector<Vec2> points;  // two at least; closed where the last is the first
        bool operator==(const CrackLine&) const = default;
    };
    std::vector<CrackLine> lines;  // ascending index

    bool operator==(const CrackLines&) const = default;
    Status cut(const LayerContext& context, CutSet& cuts) const;
    std::optional<std::string> fault() const;
    double estimatedPieces(double) const { return static_cast<double>(lines.size()); }
    static const LayerKind kKind;
    std::size_t elementCount() const { return lines.size(); }
};

}  // namespace rubble
