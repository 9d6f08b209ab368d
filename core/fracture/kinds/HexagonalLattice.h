#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/sampling/ScatterDomain.h"

namespace rubble {

/// Seeds on a hexagonal lattice around the centre of the domain's bounding box: their cells are regular hexagons. A
/// seed keeps its index when the spacing changes or the outline grows.
struct HexagonalLattice {
    double spacing = 0.2;                           // m, between neighbouring seeds
    double rotation = 0.0;                          // rad, counter-clockwise; 0: rows along the x axis
    ScatterDomain domain = ScatterDomain::Outline;  // seeds outside are omitted

    bool operator==(const HexagonalLattice&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    double estimatedPieces(double area) const;
    static const LayerKind kKind;
    static HexagonalLattice defaultsFor(const Box2& bounds);
};

}  // namespace rubble
