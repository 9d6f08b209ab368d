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
    double layerHeight = 0.0;  // m, in a closed mesh: of layers along z; 0: columns through the whole mesh

    bool operator==(const HexagonalLattice&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    double estimatedPieces(double area) const;
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    static HexagonalLattice defaultsFor(const Box3& bounds);
};

}  // namespace rubble
