#include "core/base/MessageText.h"
#include "core/fracture/PatternKind.h"

#include <cmath>

namespace rubble {

std::optional<std::string> parameterFault(const PlacedSeeds& placed) {
    for (std::size_t k = 0; k < placed.seeds.size(); ++k) {
        const PlacedSeeds::Seed& seed = placed.seeds[k];
        const auto name = [&] { return "seed " + std::to_string(seed.index); };
        if (k > 0 && seed.index <= placed.seeds[k - 1].index) {
            return name() + " does not come after seed " + std::to_string(placed.seeds[k - 1].index);
        }
        if (!std::isfinite(seed.position.x) || !std::isfinite(seed.position.y)) {
            return name() + " stands at (" + messageText(seed.position.x) + ", " + messageText(seed.position.y) +
                   "), which is not finite";
        }
    }
    return std::nullopt;
}

Status applyLayer(const PlacedSeeds& placed, const LayerContext& context, SeedSet& seeds) {
    if (placed.seeds.size() > kMostSeeds - seeds.size()) return tooManySeeds(context);
    seeds.positions.reserve(seeds.size() + placed.seeds.size());
    seeds.ids.reserve(seeds.positions.capacity());
    for (const PlacedSeeds::Seed& seed : placed.seeds) seeds.add({context.layer.id, seed.index}, seed.position, true);
    return success();
}

}  // namespace rubble
