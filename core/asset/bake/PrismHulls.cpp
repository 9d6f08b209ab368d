#include "core/asset/bake/PrismHulls.h"

#include "core/asset/bake/MeshHullCache.h"
#include "core/geometry/polygon/ConvexParts.h"

namespace rubble {

Result<std::vector<Polytope>> prismHulls(const Prism& prism, Vec2 origin) {
    const Result<IndexLoops> parts = convexParts(prism.outline);
    if (!parts) return parts.error();
    const std::vector<Vec2> corners = cornersOf(prism.outline);
    std::vector<Polytope> hulls;
    for (const std::vector<std::uint32_t>& part : *parts) {
        Ring ring;
        for (const std::uint32_t corner : part) ring.push_back(corners[corner] - origin);
        hulls.push_back(extruded(ring, -prism.depth / 2.0, prism.depth / 2.0));
    }
    return hulls;
}

Result<std::vector<Polytope>> meshHulls(const ClosedMesh& mesh, Vec3 origin, const TaskContext& task) {
    static MeshHullCache cache;
    const Result<MeshHullCache::Hulls> whole = cache.hullsOf(mesh, task);
    if (!whole) return whole.error();
    std::vector<Polytope> hulls = **whole;
    for (Polytope& hull : hulls) hull = translated(std::move(hull), -origin);
    return hulls;
}

AssetHulls assetHulls(const Project& project) {
    AssetHulls all;
    for (const Asset& asset : project.assets) {
        if (const ClosedMesh* mesh = asset.mesh()) {
            if (Result<std::vector<Polytope>> hulls = meshHulls(*mesh)) all[asset.id] = std::move(*hulls);
            continue;
        }
        const Result<Prism> prism = validated(asset.prism());
        if (!prism) continue;
        if (Result<std::vector<Polytope>> hulls = prismHulls(*prism)) all[asset.id] = std::move(*hulls);
    }
    return all;
}

}  // namespace rubble
