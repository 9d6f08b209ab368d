#pragma once

#include "core/asset/texture/ShelfPacking.h"
#include "core/asset/texture/SurfaceChart.h"
#include "core/base/Result.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace rubble {

/// A chart and its rectangle in a texture, with a gutter on all sides. Texels, from the lower left corner.
struct PlacedChart {
    SurfaceChart chart;
    TexelPlace place;
    TexelSize size;
};

/// The places of the surfaces of an asset in a square texture. Surfaces in metres all have the same density of texels.
class TextureAtlas {
public:
    static constexpr int kGutter = 2;  // texels, which continue a chart beyond its faces

    int side() const { return m_side; }
    double density() const { return m_density; }  // texels/m
    const std::vector<PlacedChart>& charts() const { return m_charts; }
    /// The index of the chart of a face; MeshCharts::kNoChart if it has none.
    std::uint32_t chartOf(std::size_t part, std::size_t face) const { return m_ofFaces[m_firstFaces[part] + face]; }

    /// The place of a point of the asset in the texture, in texels.
    Vec2 texelAt(const PlacedChart& placed, Vec3 point) const;
    /// The point of a face that is at a place in the texture.
    Vec3 pointAt(const PlacedChart& placed, Vec2 texel, const ChartFace& face) const;

    /// The mesh of a part with its texture coordinates in the atlas, where it has charts, and with tangents.
    Mesh textured(std::size_t part, const Mesh& mesh) const;

private:
    friend class TextureAtlasBuilder;
    int m_side = 0;
    double m_density = 0.0;
    std::vector<PlacedChart> m_charts;
    std::vector<std::uint32_t> m_ofFaces;   // of all parts
    std::vector<std::size_t> m_firstFaces;  // of each part
    std::vector<Vec3> m_offsets;
};

/// Collects the surfaces of an asset. Outside faces that lie in one plane, of whatever part, share a chart: a whole and
/// its fragments of all levels show the same texels.
class TextureAtlasBuilder {
public:
    explicit TextureAtlasBuilder(TexturedSides sides) : m_sides(sides) {}

    /// Adds the next part: a mesh whose frame is at `offset` in that of the asset.
    void add(const Mesh& mesh, Vec3 offset);
    std::size_t chartCount() const { return m_atlas.m_charts.size(); }

    /// The atlas with the most texels a metre that fits into a square of `side` texels.
    ///
    /// Errors: Limit if it has more charts than fit at any density.
    Result<TextureAtlas> atlas(int side) &&;

private:
    using PlaneKey = std::array<long long, 4>;
    std::uint32_t chartNumber(SurfaceChart chart, const Mesh& mesh, Vec3 offset, std::span<const std::uint32_t> faces);

    TexturedSides m_sides;
    TextureAtlas m_atlas;
    std::map<PlaneKey, std::uint32_t> m_planes;  // charts of the outside
};

}  // namespace rubble
