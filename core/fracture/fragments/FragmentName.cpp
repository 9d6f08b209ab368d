#include "core/fracture/fragments/FragmentName.h"

#include "core/fracture/pattern/PatternPartition.h"

namespace rubble {

SeedId cellId(const Fragment& fragment, std::span<const SeedId> seeds) {
    if (const ExtrudedPieces* pieces = fragment.all().extruded())
        return cellId(pieces->partition, fragment.extruded()->piece(), seeds);
    return fragment.seed() == kNone ? SeedId{} : seeds[fragment.seed()];
}

std::string fragmentName(const Fragment& fragment, std::span<const SeedId> seeds) {
    if (const ExtrudedPieces* pieces = fragment.all().extruded())
        return pieceName(pieces->partition, fragment.extruded()->piece(), seeds);
    const std::string name = cellId(fragment, seeds).text();
    const std::uint32_t part = fragment.partOfCell();
    return part == kNone ? name : name + "." + std::to_string(part);
}

}  // namespace rubble
