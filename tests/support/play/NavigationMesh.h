#pragma once

#include "core/play/session/Session.h"

#include <recastnavigation/DetourAlloc.h>
#include <recastnavigation/DetourNavMeshBuilder.h>
#include <recastnavigation/Recast.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rubble::test {

/// The triangles of the bodies of a session, each with the body's box.
struct SceneTriangles {
    struct Body {
        Box3 box;
        std::vector<float> corners;  // nine a triangle
    };
    std::vector<Body> bodies;  // by number
};

inline SceneTriangles trianglesOf(const Session& session) {
    SceneTriangles scene;
    for (const PlayBody& body : session.bodies()) {
        SceneTriangles::Body& made = scene.bodies.emplace_back();
        const Pose pose = session.world().state(body.body).pose;
        for (const Polytope& hull : hullsOf(body)) {
            std::vector<Vec3> points;
            for (const Vec3& vertex : hull.vertices) points.push_back(pose.position + pose.orientation * vertex);
            for (const Vec3& point : points) made.box.include(point);
            for (const std::vector<std::uint32_t>& face : hull.faces) {
                for (std::size_t k = 2; k < face.size(); ++k) {
                    for (const std::uint32_t corner : {face[0], face[k - 1], face[k]}) {
                        for (int axis = 0; axis < 3; ++axis) {
                            made.corners.push_back(static_cast<float>(points[corner][axis]));
                        }
                    }
                }
            }
        }
    }
    return scene;
}

/// A square navigation mesh of square tiles, built by Recast.
class NavigationMesh {
public:
    NavigationMesh(double halfSide, int tilesAlong)
        : m_halfSide(halfSide), m_along(tilesAlong), m_tiles(static_cast<std::size_t>(tilesAlong * tilesAlong)) {}

    /// The tiles that depend on what is in a box: those that it meets, with the border of each.
    std::vector<std::size_t> tilesAt(const Box3& box) const {
        std::vector<std::size_t> tiles;
        for (std::size_t tile = 0; tile < m_tiles.size(); ++tile) {
            const Box3 around = boundsOf(tile);
            if (box.min.x <= around.max.x && around.min.x <= box.max.x && box.min.z <= around.max.z &&
                around.min.z <= box.max.z) {
                tiles.push_back(tile);
            }
        }
        return tiles;
    }

    void build(const SceneTriangles& scene, std::size_t tile) { m_tiles[tile] = built(scene, tile); }
    void buildAll(const SceneTriangles& scene) {
        for (std::size_t tile = 0; tile < m_tiles.size(); ++tile) build(scene, tile);
    }
    const std::vector<std::string>& tiles() const { return m_tiles; }

private:
    static constexpr double kCell = 0.1;                // m
    static constexpr double kCellHeight = 0.05;         // m
    static constexpr int kRadius = 2;                   // cells, of who walks
    static constexpr int kBorder = kRadius + 3;         // cells
    static constexpr double kLow = -0.5, kHigh = 12.0;  // m

    /// The bounds of a tile with its border.
    Box3 boundsOf(std::size_t tile) const {
        const double side = 2.0 * m_halfSide / m_along, border = kBorder * kCell;
        const double x = -m_halfSide + side * static_cast<double>(tile % static_cast<std::size_t>(m_along));
        const double z = -m_halfSide + side * static_cast<double>(tile / static_cast<std::size_t>(m_along));
        return {{x - border, kLow, z - border}, {x + side + border, kHigh, z + side + border}};
    }

    std::string built(const SceneTriangles& scene, std::size_t tile) const;

    double m_halfSide = 0.0;  // m
    int m_along = 0;
    std::vector<std::string> m_tiles;  // Detour's bytes of each
};

/// Memory of Recast, freed by its own functions.
template <class Value, Value* (*allocate)(), void (*release)(Value*)>
struct RecastValue {
    RecastValue() = default;
    RecastValue(const RecastValue&) = delete;
    RecastValue& operator=(const RecastValue&) = delete;
    ~RecastValue() { release(value); }
    Value& operator*() const { return *value; }
    Value* operator->() const { return value; }
    Value* value = allocate();
};
using RecastHeights = RecastValue<rcHeightfield, rcAllocHeightfield, rcFreeHeightField>;
using RecastSpans = RecastValue<rcCompactHeightfield, rcAllocCompactHeightfield, rcFreeCompactHeightfield>;
using RecastContours = RecastValue<rcContourSet, rcAllocContourSet, rcFreeContourSet>;
using RecastMesh = RecastValue<rcPolyMesh, rcAllocPolyMesh, rcFreePolyMesh>;
using RecastDetail = RecastValue<rcPolyMeshDetail, rcAllocPolyMeshDetail, rcFreePolyMeshDetail>;

/// The bytes of a tile as Detour loads it; empty where there is nothing to walk on.
inline std::string detourBytes(rcPolyMesh& mesh, const rcPolyMeshDetail& detail, std::size_t tile) {
    if (mesh.npolys == 0) return {};
    std::fill_n(mesh.flags, mesh.npolys, static_cast<unsigned short>(1));
    dtNavMeshCreateParams params{};
    params.verts = mesh.verts;
    params.vertCount = mesh.nverts;
    params.polys = mesh.polys;
    params.polyAreas = mesh.areas;
    params.polyFlags = mesh.flags;
    params.polyCount = mesh.npolys;
    params.nvp = mesh.nvp;
    params.detailMeshes = detail.meshes;
    params.detailVerts = detail.verts;
    params.detailVertsCount = detail.nverts;
    params.detailTris = detail.tris;
    params.detailTriCount = detail.ntris;
    params.tileX = static_cast<int>(tile);
    std::copy_n(mesh.bmin, 3, params.bmin);
    std::copy_n(mesh.bmax, 3, params.bmax);
    params.walkableHeight = 1.8f;
    params.walkableRadius = 0.2f;
    params.walkableClimb = 0.3f;
    params.cs = mesh.cs;
    params.ch = mesh.ch;
    params.buildBvTree = true;
    unsigned char* data = nullptr;
    int size = 0;
    if (!dtCreateNavMeshData(&params, &data, &size)) qFatal("Detour refuses a tile");
    std::string bytes(data, data + size);
    dtFree(data);
    return bytes;
}

inline std::string NavigationMesh::built(const SceneTriangles& scene, std::size_t tile) const {
    rcContext context(false);
    const Box3 bounds = boundsOf(tile);
    const std::array<float, 3> low{static_cast<float>(bounds.min.x), static_cast<float>(bounds.min.y),
                                   static_cast<float>(bounds.min.z)};
    const std::array<float, 3> high{static_cast<float>(bounds.max.x), static_cast<float>(bounds.max.y),
                                    static_cast<float>(bounds.max.z)};
    const auto cells = static_cast<int>(std::lround((bounds.max.x - bounds.min.x) / kCell));
    RecastHeights heights;
    rcCreateHeightfield(&context, *heights, cells, cells, low.data(), high.data(), static_cast<float>(kCell),
                        static_cast<float>(kCellHeight));
    for (const SceneTriangles::Body& body : scene.bodies) {
        if (body.box.max.x < bounds.min.x || bounds.max.x < body.box.min.x || body.box.max.z < bounds.min.z ||
            bounds.max.z < body.box.min.z) {
            continue;
        }
        std::vector<int> corners(body.corners.size() / 3);
        for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = static_cast<int>(k);
        std::vector<unsigned char> areas(corners.size() / 3, 0);
        const auto count = static_cast<int>(corners.size());
        rcMarkWalkableTriangles(&context, 45.0f, body.corners.data(), count, corners.data(), count / 3, areas.data());
        rcRasterizeTriangles(&context, body.corners.data(), count, corners.data(), areas.data(), count / 3, *heights);
    }
    constexpr int kHeight = 36, kClimb = 6;  // cells: 1.8 m and 0.3 m
    rcFilterLowHangingWalkableObstacles(&context, kClimb, *heights);
    rcFilterLedgeSpans(&context, kHeight, kClimb, *heights);
    rcFilterWalkableLowHeightSpans(&context, kHeight, *heights);
    RecastSpans spans;
    rcBuildCompactHeightfield(&context, kHeight, kClimb, *heights, *spans);
    rcErodeWalkableArea(&context, kRadius, *spans);
    rcBuildDistanceField(&context, *spans);
    rcBuildRegions(&context, *spans, kBorder, 8, 20);
    RecastContours contours;
    rcBuildContours(&context, *spans, 1.3f, 12, *contours);
    RecastMesh mesh;
    rcBuildPolyMesh(&context, *contours, 6, *mesh);
    RecastDetail detail;
    rcBuildPolyMeshDetail(&context, *mesh, *spans, 0.6f, 0.1f, *detail);
    return detourBytes(*mesh, *detail, tile);
}

}  // namespace rubble::test
