#include "core/fracture/PatternKind.h"
#include "core/fracture/ScatterArea.h"

namespace rubble {

std::optional<std::string> parameterFault(const UniformScatter&) { return std::nullopt; }

Status applyLayer(const UniformScatter& scatter, const LayerContext& context, SeedSet& seeds) {
    if (scatter.count > kMostSeeds - seeds.size()) return tooManySeeds(context);
    const Result<ScatterArea> area = ScatterArea::of(ScatterArea::domain(context.outline, scatter.domain));
    if (!area) return area.error();
    Random random = context.random();
    for (std::uint32_t index = 0; index < scatter.count; ++index) {
        if (context.isCancelledAt(index)) return TaskContext::cancelled();
        seeds.add({context.layer.id, index}, area->point(random), false);
    }
    return success();
}

}  // namespace rubble
