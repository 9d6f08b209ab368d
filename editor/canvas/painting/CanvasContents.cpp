#include "editor/canvas/painting/CanvasContents.h"

#include "core/asset/project/FragmentColours.h"
#include "core/structure/clusters/ClusterColours.h"
#include "editor/widgets/ColourConversion.h"

namespace rubble {

QColor CanvasContents::colour(const DrawablePattern& from, std::uint32_t piece) const {
    if (overlays.colouring == CellColouring::Cluster) {
        const bool isKnown = bondMarks && &from == pattern.get() && piece < bondMarks->clusterColours.size();
        return toQColor(isKnown ? bondMarks->clusterColours[piece] : kUnclusteredColour);
    }
    if (overlays.colouring != CellColouring::Level) return from.colour(piece, overlays.colouring, range);
    const auto depth = depths.find(from.fragmentId(piece));
    const double fraction = range.most > 0.0 && depth != depths.end() ? depth->second / range.most : 0.0;
    return toQColor(rampColour(fraction));
}

double CanvasContents::area(std::uint32_t piece) const {
    return shrunk && !moved ? pieceArea(*shrunk, piece) : pattern->area(piece);
}

const Asset* CanvasContents::asset() const {
    if (!pattern) return nullptr;
    return (moved ? moved->pattern : pattern)->baked().asset.get();
}

std::pair<const DrawablePattern*, std::uint32_t> CanvasContents::find(SeedId seed) const {
    if (moved) {
        const std::uint32_t index = moved->pattern->find(seed);
        if (index != kNone && moved->isShown[index]) return {moved->pattern.get(), index};
    }
    return {pattern.get(), pattern->find(seed)};
}

}  // namespace rubble
