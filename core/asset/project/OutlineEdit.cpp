#include "core/asset/project/OutlineEdit.h"

#include "core/fracture/pattern/PatternKind.h"

#include <utility>

namespace rubble {

Asset withOutline(Asset asset, Polygon outline) {
    outline = withCanonicalWinding(std::move(outline));
    const Polygon before = std::exchange(asset.prism().outline, std::move(outline));
    for (PatternLayer& layer : asset.pattern.layers) {
        if (!kindOf(layer.parameters).fillsOutline) continue;
        if (!layer.scatteredIn) layer.scatteredIn = before;
        if (layer.scatteredIn == asset.prism().outline) layer.scatteredIn.reset();
    }
    return asset;
}

}  // namespace rubble
