#include "core/fracture/kinds/CrackLines.h"

#include "core/base/MessageText.h"
#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/geometry/predicates/Predicates.h"

namespace rubble {
namespace {

std::string textOf(Vec2 point) { return "(" + messageText(point.x) + ", " + messageText(point.y) + ")"; }

std::optional<std::string> faultOf(const CrackLines::CrackLine& line) {
    const std::string name = "crack line " + std::to_string(line.index);
    if (line.points.size() < 2) return name + " has fewer than two points";
    for (std::size_t k = 0; k < line.points.size(); ++k) {
        const std::string point = "point " + std::to_string(k) + " of " + name;
        if (const auto fault = coordinateFault(line.points[k])) return point + " " + *fault;
        if (k > 0 && line.points[k] == line.points[k - 1]) {
            return point + " equals the one before, " + textOf(line.points[k]);
        }
    }
    return std::nullopt;
}

}  // namespace

constinit const LayerKind CrackLines::kKind{.name = "strokes",
                                            .caption = "Crack lines",
                                            .hint = "Cracks drawn by hand",
                                            .icon = "layer-crack-lines",
                                            .summary = "{elements|1 line|%1 lines}",
                                            .role = LayerRole::Cuts};

std::optional<std::string> CrackLines::fault() const {
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (k > 0 && lines[k].index <= lines[k - 1].index) {
            return "crack line " + std::to_string(lines[k].index) + " does not come after crack line " +
                   std::to_string(lines[k - 1].index);
        }
        if (std::optional<std::string> fault = faultOf(lines[k])) return fault;
    }
    return std::nullopt;
}

Status CrackLines::cut(const LayerContext& context, CutSet& cuts) const {
    for (const CrackLine& line : lines) {
        if (context.task.isCancelled()) return TaskContext::cancelled();
        if (line.points.size() > kMaxCuts - cuts.edges.size()) return tooManySeeds(context);
        const std::uint32_t first = cuts.addPoint(line.points[0]);
        std::uint32_t before = first;
        for (std::size_t k = 1; k < line.points.size(); ++k) {
            const bool isClosing = k + 1 == line.points.size() && line.points[k] == line.points[0];
            const std::uint32_t point = isClosing ? first : cuts.addPoint(line.points[k]);
            cuts.edges.push_back({before, point, line.index});
            before = point;
        }
    }
    cuts.layers.push_back({context.layerId, static_cast<std::uint32_t>(cuts.edges.size()), false, nullptr});
    return success();
}

}  // namespace rubble
