#include "core/fracture/Strokes.h"

#include "core/base/MessageText.h"
#include "core/fracture/CutSet.h"
#include "core/fracture/PatternKind.h"
#include "core/geometry/Predicates.h"

namespace rubble {
namespace {

std::string textOf(Vec2 point) { return "(" + messageText(point.x) + ", " + messageText(point.y) + ")"; }

std::optional<std::string> faultOf(const Strokes::Stroke& stroke) {
    const std::string name = "stroke " + std::to_string(stroke.index);
    if (stroke.points.size() < 2) return name + " has fewer than two points";
    for (std::size_t k = 0; k < stroke.points.size(); ++k) {
        const std::string point = "point " + std::to_string(k) + " of " + name;
        if (const auto fault = coordinateFault(stroke.points[k])) return point + " " + *fault;
        if (k > 0 && stroke.points[k] == stroke.points[k - 1]) {
            return point + " equals the one before, " + textOf(stroke.points[k]);
        }
    }
    return std::nullopt;
}

}  // namespace

constinit const PatternKind Strokes::kKind{.name = "strokes",
                                           .caption = "Strokes",
                                           .hint = "Cracks drawn by hand",
                                           .role = LayerRole::Cuts,
                                           .suitedTo = [](const Box2&) -> LayerParameters { return Strokes{}; }};

std::optional<std::string> Strokes::fault() const {
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        if (k > 0 && strokes[k].index <= strokes[k - 1].index) {
            return "stroke " + std::to_string(strokes[k].index) + " does not come after stroke " +
                   std::to_string(strokes[k - 1].index);
        }
        if (std::optional<std::string> fault = faultOf(strokes[k])) return fault;
    }
    return std::nullopt;
}

Status Strokes::cut(const LayerContext& context, CutSet& cuts) const {
    for (const Stroke& stroke : strokes) {
        if (context.task.isCancelled()) return TaskContext::cancelled();
        if (stroke.points.size() > kMostCuts - cuts.edges.size()) return tooManySeeds(context);
        const std::uint32_t first = cuts.addPoint(stroke.points[0]);
        std::uint32_t before = first;
        for (std::size_t k = 1; k < stroke.points.size(); ++k) {
            const bool isClosing = k + 1 == stroke.points.size() && stroke.points[k] == stroke.points[0];
            const std::uint32_t point = isClosing ? first : cuts.addPoint(stroke.points[k]);
            cuts.edges.push_back({before, point, stroke.index});
            before = point;
        }
    }
    cuts.layers.push_back({context.layer.id, static_cast<std::uint32_t>(cuts.edges.size()), false, nullptr});
    return success();
}

}  // namespace rubble
