#pragma once

#include "core/asset/Surface.h"
#include "core/fracture/Prism.h"

#include <memory>
#include <optional>
#include <span>

namespace rubble {

/// How well one cap's texture coordinates are a map.
struct CapFit {
    std::size_t triangles = 0;        // of the mesh on this cap
    std::size_t materials = 0;        // that they have; the one with the most area is taken
    std::optional<double> deviation;  // UV units, the farthest that a corner lies from the best map
};

/// The look of a mesh on the prism that was found in it.
struct FittedSurface {
    std::shared_ptr<const Surface> surface;  // null where the prism's own look is all there is: no UVs, one material
    CapFit front;
    CapFit back;
};

/// Takes the look of a mesh's triangles, which are in the prism's frame, on to its prism. Each cap takes a map where
/// its corners lie on one within single precision, else the nearest triangle. Without UVs, caps take the outline in
/// metres and sides its length and z. Materials that no triangle names are left out. `tolerance` as for the prism, m.
FittedSurface fittedSurface(std::span<const SurfaceTriangle> triangles, bool hasUvs,
                            const std::vector<std::string>& materials, const Prism& prism, double tolerance);

}  // namespace rubble
