#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/geometry/predicates/Vec.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// Seeds placed by hand. Their indices are kept when others are deleted.
struct PlacedSeeds {
    struct Seed {
        std::uint32_t index = 0;
        Vec2 position{0.0, 0.0};
        double height = 0.0;  // z, m, in a closed mesh
        bool operator==(const Seed&) const = default;
    };
    std::vector<Seed> seeds;  // ascending index

    bool operator==(const PlacedSeeds&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    std::optional<std::string> fault() const;
    double estimatedPieces(double) const { return static_cast<double>(seeds.size()); }
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    std::size_t elementCount() const { return seeds.size(); }
};

}  // namespace rubble
