#pragma once

#include "core/asset/project/Surface.h"
#include "core/fracture/pieces/Prism.h"

#include <memory>
#include <optional>
#include <span>

namespace rubble {

/// The quality of an affine map fitted to a cap's UVs.
struct CapFit {
    std::size_t triangles = 0;        // of the mesh on this cap
    std::size_t materials = 0;        // of these; the one with the largest area is used
    std::optional<double> deviation;  // UV units: largest distance of a corner from the best affine map
};

/// The surface of a mesh, transferred to the prism fitted to it.
struct FittedSurface {
    std::shared_ptr<const Surface> surface;  // null if the prism's own is enough: no UVs, one material
    CapFit front;
    CapFit back;
};

/// Transfers the surface of a mesh to its prism; `triangles` are in the prism's frame. A cap whose corners lie on an
/// affine map within single precision gets that map, any other the nearest triangles. Without UVs, caps use the outline
/// in metres, and sides its length and z. Unused materials are left out. `tolerance`, m: that of the prism.
FittedSurface fittedSurface(std::span<const SurfaceTriangle> triangles, bool hasUvs,
                            const std::vector<std::string>& materials, const Prism& prism, double tolerance);

}  // namespace rubble
