#pragma once

#include "core/asset/bake/Bake.h"
#include "core/asset/mesh/OutlineInterval.h"
#include "core/asset/mesh/SurfaceUv.h"
#include "core/geometry/mesh/Mesh.h"

#include <optional>
#include <vector>

namespace rubble {

/// Points inserted into the edges of a fragment, in its frame: one list per edge, in the order of
/// ExtrudedFragment::edgeNeighbours(). Empty: every edge stays straight.
using EdgeCorners = std::vector<std::vector<Vec2>>;

/// Builds the render meshes of an asset; its outline and its imported surface are indexed once. Borrows the asset. May
/// be used by several threads at once.
class FragmentMesher {
public:
    explicit FragmentMesher(const Asset& asset);

    /// The mesh of a fragment in its own frame, with the points of RoughCuts in its cut edges. O(corners · log corners
    /// of the asset's outline), and of the triangles of its surface.
    Mesh fragmentMesh(const BakedFragment& fragment, const EdgeCorners& rough = {}) const;
    /// The mesh of the whole about its centre of mass. The same complexity.
    Mesh wholeMesh(const Bake& bake) const;

private:
    const Asset& m_asset;
    std::optional<OutlineIndex> m_outline;  // of a prism
    double m_outlineTolerance = 0.0;        // m
    std::optional<SurfaceIndex> m_surface;  // none without an imported surface
};

/// A single mesh. Several meshes of an asset are built faster by one FragmentMesher.
Mesh fragmentMesh(const BakedFragment& fragment, const Asset& asset, const EdgeCorners& rough = {});
Mesh wholeMesh(const Bake& bake, const Asset& asset);

}  // namespace rubble
