#include "core/fracture/kinds/PlacedSeeds.h"

#include "core/base/MessageText.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"

#include <cmath>

namespace rubble {

constinit const LayerKind PlacedSeeds::kKind{.name = "placed",
                                             .caption = "Placed seeds",
                                             .hint = "Seeds placed by hand",
                                             .icon = "layer-placed",
                                             .summary = "{elements}",
                                             .role = LayerRole::Places};

std::optional<std::string> PlacedSeeds::fault() const {
    for (std::size_t k = 0; k < seeds.size(); ++k) {
        const Seed& seed = seeds[k];
        const auto name = [&] { return "seed " + std::to_string(seed.index); };
        if (k > 0 && seed.index <= seeds[k - 1].index) {
            return name() + " does not come after seed " + std::to_string(seeds[k - 1].index);
        }
        if (!std::isfinite(seed.position.x) || !std::isfinite(seed.position.y)) {
            return name() + " is at (" + messageText(seed.position.x) + ", " + messageText(seed.position.y) +
                   "), which is not finite";
        }
        if (!std::isfinite(seed.height))
            return name() + " is at a height of " + messageText(seed.height) + ", which is not finite";
    }
    return std::nullopt;
}

Status PlacedSeeds::apply(const LayerContext& context, SeedSet& all) const {
    if (seeds.size() > kMaxSeeds - all.size()) return tooManySeeds(context);
    all.positions.reserve(all.size() + seeds.size());
    all.ids.reserve(all.positions.capacity());
    for (const Seed& seed : seeds) all.add({context.layerId, seed.index}, seed.position, true);
    return success();
}

Status PlacedSeeds::applyInSolid(const SolidLayerContext& context, SeedSet& all) const {
    if (seeds.size() > kMaxSeeds - all.size()) return tooManySeeds(context);
    for (const Seed& seed : seeds) all.add({context.layerId, seed.index}, Vec3(seed.position, seed.height), true);
    return success();
}

double PlacedSeeds::estimatedPiecesIn(const SolidDomain&) const { return static_cast<double>(seeds.size()); }

}  // namespace rubble
