#include "core/asset/mesh/ExtrudedMesh.h"

#include "core/geometry/polygon/ConvexParts.h"

#include <algorithm>
#include <numeric>

namespace rubble {

namespace {

class MeshBuilder {
public:
    MeshBuilder(const ExtrudedSolid& solid, const Asset& asset, const SurfaceIndex* index)
        : m_solid(solid),
          m_index(index),
          m_surface(index ? asset.surface.get() : nullptr),
          m_insideUvScale(asset.insideUvScale) {}

    Mesh build() {
        addPositions();
        const IndexLoops loops = capLoops();
        addCap(loops, true);
        addCap(loops, false);
        for (const ExtrudedSide& side : m_solid.sides) {
            if (side.side == FaceSide::Outside) addOutsideSide(side);
        }
        sortByMaterial();
        m_insideUvs = static_cast<std::uint32_t>(m_mesh.uvs.size());
        for (const ExtrudedSide& side : m_solid.sides) {
            if (side.side == FaceSide::Inside) addInsideSide(side);
        }
        return std::move(m_mesh);
    }

private:
    double top() const { return m_solid.depth / 2.0; }
    std::uint32_t cornerCount() const { return static_cast<std::uint32_t>(m_solid.sides.size()); }
    Vec3 inPrism(std::uint32_t position) const { return m_mesh.positions[position] + m_solid.offset; }

    void addPositions() {
        const std::size_t count = m_solid.sides.size();
        m_mesh.positions.reserve(2 * count);
        m_mesh.uvs.reserve(5 * count);
        m_mesh.normals.reserve(count + 2);
        m_mesh.corners.reserve(6 * count);
        m_mesh.faces.reserve(count + 2);
        for (const double z : {top(), -top()}) {
            for (const Vec2 corner : m_solid.outline.outer) m_mesh.positions.push_back({corner.x, corner.y, z});
            for (const Ring& hole : m_solid.outline.holes) {
                for (const Vec2 corner : hole) m_mesh.positions.push_back({corner.x, corner.y, z});
            }
        }
    }

    /// The front's faces as corners of the outline, counter-clockwise.
    IndexLoops capLoops() const {
        IndexLoops whole(1, std::vector<std::uint32_t>(m_solid.outline.outer.size()));
        std::iota(whole[0].begin(), whole[0].end(), 0u);
        if (m_solid.isConvex && m_solid.outline.holes.empty()) return whole;
        Result<IndexLoops> parts = convexParts(m_solid.outline);
        if (parts) return std::move(*parts);
        // Rounding to its own frame made a sliver touch itself. Its rings still close the mesh and enclose the right
        // volume, since holes have negative areas.
        for (const Ring& hole : m_solid.outline.holes) {
            const std::uint32_t first = whole.back().back() + 1;
            std::iota(whole.emplace_back(hole.size()).begin(), whole.back().end(), first);
        }
        return whole;
    }

    void addCap(const IndexLoops& loops, bool isFront) {
        const Vec3 normal{0.0, 0.0, isFront ? 1.0 : -1.0};
        const std::uint32_t firstPosition = isFront ? 0 : cornerCount();
        const std::uint32_t firstUv = addCapUvs(firstPosition, normal);
        m_mesh.normals.push_back(normal);
        for (const std::vector<std::uint32_t>& loop : loops) {
            addFace(FaceSide::Outside, capMaterial(isFront));
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const std::uint32_t corner = loop[isFront ? k : loop.size() - 1 - k];
                addCorner(firstPosition + corner, firstUv + corner);
            }
        }
    }

    std::uint32_t capMaterial(bool isFront) const {
        if (!m_surface) return 0;
        return isFront ? m_surface->front.material : m_surface->back.material;
    }

    /// One UV per corner. Both caps share them if they are the outline itself.
    std::uint32_t addCapUvs(std::uint32_t firstPosition, Vec3 normal) {
        if (!m_surface && firstPosition != 0) return 0;
        const auto first = static_cast<std::uint32_t>(m_mesh.uvs.size());
        const Vec3 centre = m_solid.offset + normal * top();
        for (std::uint32_t i = 0; i < cornerCount(); ++i) {
            const Vec3 point = inPrism(firstPosition + i);
            m_mesh.uvs.push_back(m_surface ? capUv(point, centre, normal) : Vec2(point.x, point.y));
        }
        return first;
    }

    Vec2 capUv(Vec3 point, Vec3 centre, Vec3 normal) const {
        const CapUv& cap = normal.z > 0.0 ? m_surface->front : m_surface->back;
        if (cap.isAffine) return mapped(cap.map, {point.x, point.y});
        return m_index->sample(point, centre, normal).uv;
    }

    void addOutsideSide(const ExtrudedSide& side) {
        const auto uv = static_cast<std::uint32_t>(m_mesh.uvs.size());
        const Vec3 normal = addSideNormal(side);
        if (!m_surface) {
            addFace(FaceSide::Outside, 0);
            for (const double u : {side.outline.from, side.outline.to}) {
                m_mesh.uvs.push_back({u, top()});
                m_mesh.uvs.push_back({u, -top()});
            }
        } else {
            const std::uint32_t count = cornerCount();
            const Vec3 centre = 0.5 * (inPrism(side.from) + inPrism(side.to + count));
            addFace(FaceSide::Outside, m_index->sample(centre, centre, normal).material);
            for (const std::uint32_t position : {side.from, side.from + count, side.to, side.to + count}) {
                m_mesh.uvs.push_back(m_index->sample(inPrism(position), centre, normal).uv);
            }
        }
        addSideCorners(side, uv, uv + 2);
    }

    /// UVs start at each cut's first corner, so that the sides that start there share the first pair.
    void addInsideSide(const ExtrudedSide& side) {
        addSideNormal(side);
        addFace(FaceSide::Inside, 0);
        const double v = top() * m_insideUvScale;
        const auto addPair = [&](double u) {
            m_mesh.uvs.push_back({u, v});
            m_mesh.uvs.push_back({u, -v});
        };
        if (m_mesh.uvs.size() == m_insideUvs) addPair(0.0);
        const double length = glm::distance(m_mesh.positions[side.from], m_mesh.positions[side.to]);
        auto uv = static_cast<std::uint32_t>(m_mesh.uvs.size());
        const bool isFirst = side.start == 0.0;
        if (!isFirst) {
            addPair(side.start * m_insideUvScale);
            uv += 2;
        }
        addPair((side.start + length) * m_insideUvScale);
        addSideCorners(side, isFirst ? m_insideUvs : uv - 2, uv);
    }

    Vec3 addSideNormal(const ExtrudedSide& side) {
        const Vec3 along = m_mesh.positions[side.to] - m_mesh.positions[side.from];
        const double length = glm::length(along);
        m_mesh.normals.push_back({along.y / length, -along.x / length, 0.0});
        return m_mesh.normals.back();
    }

    /// Front and back of a side's first corner, then of its second; their UVs come in pairs.
    void addSideCorners(const ExtrudedSide& side, std::uint32_t fromUv, std::uint32_t toUv) {
        addCorner(side.from, fromUv);
        addCorner(side.from + cornerCount(), fromUv + 1);
        addCorner(side.to + cornerCount(), toUv + 1);
        addCorner(side.to, toUv);
    }

    /// Starts a face with the last added normal.
    void addFace(FaceSide side, std::uint32_t material) {
        const auto firstCorner = static_cast<std::uint32_t>(m_mesh.corners.size());
        const auto normal = static_cast<std::uint32_t>(m_mesh.normals.size() - 1);
        m_mesh.faces.push_back({firstCorner, 0, normal, material, side});
    }
    void addCorner(std::uint32_t position, std::uint32_t uv) {
        m_mesh.corners.push_back({position, uv});
        ++m_mesh.faces.back().cornerCount;
    }

    void sortByMaterial() {
        if (!m_surface) return;
        std::stable_sort(m_mesh.faces.begin(), m_mesh.faces.end(),
                         [](const MeshFace& a, const MeshFace& b) { return a.material < b.material; });
    }

    const ExtrudedSolid& m_solid;
    const SurfaceIndex* m_index;
    const Surface* m_surface;  // null if the index is
    double m_insideUvScale;
    std::uint32_t m_insideUvs = 0;
    Mesh m_mesh;
};

}  // namespace

Mesh extrudedMesh(const ExtrudedSolid& solid, const Asset& asset, const SurfaceIndex* surface) {
    return MeshBuilder(solid, asset, surface).build();
}

}  // namespace rubble
