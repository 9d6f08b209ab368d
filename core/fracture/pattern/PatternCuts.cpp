#include "core/fracture/pattern/PatternCuts.h"

#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/pattern/PatternKind.h"

#include <algorithm>

namespace rubble {
namespace {

bool isCutting(const PatternLayer& layer) { return layer.isOn && kindOf(layer.parameters).role == LayerRole::Cuts; }

}  // namespace

bool hasCuts(const Pattern& pattern) { return std::ranges::any_of(pattern.layers, isCutting); }

Result<CutSet> cutsOf(const Pattern& pattern, const Polygon& outline, const TaskContext& task) {
    if (std::optional<std::string> fault = verifyPattern(pattern)) return Error{ErrorCode::BadInput, *fault};
    CutSet cuts;
    for (const PatternLayer& layer : pattern.layers) {
        if (!isCutting(layer)) continue;
        if (task.isCancelled()) return TaskContext::cancelled();
        const LayerContext context{{layer.id, layer.randomSeed, layer.overrides, task}, outline};
        const Status cut = std::visit(
            [&](const auto& parameters) -> Status {
                if constexpr (requires { parameters.cut(context, cuts); }) return parameters.cut(context, cuts);
                return success();
            },
            layer.parameters);
        if (!cut) return cut.error();
    }
    return cuts;
}

double jointWidthOf(const Pattern& pattern) {
    double width = 0.0;
    for (const PatternLayer& layer : pattern.layers) {
        const auto* bond = std::get_if<BrickBond>(&layer.parameters);
        if (bond && layer.isOn) width = std::max(width, bond->mortar);
    }
    return width;
}

}  // namespace rubble
