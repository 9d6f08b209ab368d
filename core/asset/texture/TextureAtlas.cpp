#include "core/asset/texture/TextureAtlas.h"

#include "core/base/Assert.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

constexpr double kPlaneSteps = 1e5;  // a unit: how exactly planes must agree to be one

/// Turns a chart by a quarter so that it is wider than high: rows of a texture are filled better.
void layDown(SurfaceChart& chart) {
    const Vec2 size = chart.high - chart.low;
    if (size.y <= size.x) return;
    const Vec3 across = chart.across;
    chart.across = chart.upwards;
    chart.upwards = -across;
    const auto turned = [](Vec2 place) { return Vec2(place.y, -place.x); };
    const Vec2 low = chart.low, high = chart.high;
    chart.low = turned({high.x, low.y});
    chart.high = turned({low.x, high.y});
    for (ChartFace& face : chart.faces) {
        for (Vec2& corner : face.shape) corner = turned(corner);
    }
}

std::vector<TexelSize> sizesOf(const std::vector<PlacedChart>& charts, double density) {
    std::vector<TexelSize> sizes;
    sizes.reserve(charts.size());
    const auto texels = [&](double length) {
        return std::max(1, static_cast<int>(std::ceil(length * density))) + 2 * TextureAtlas::kGutter;
    };
    for (const PlacedChart& placed : charts) {
        const Vec2 extent = placed.chart.high - placed.chart.low;
        sizes.push_back({texels(extent.x), texels(extent.y)});
    }
    return sizes;
}

/// A density at which charts do not fit or only just: that of their area, or of the longest of them.
double maxDensity(const std::vector<PlacedChart>& charts, int side) {
    double area = 0.0, longest = 1e-3;
    for (const PlacedChart& placed : charts) {
        const Vec2 extent = placed.chart.high - placed.chart.low;
        area += extent.x * extent.y;
        longest = std::max(longest, extent.x);
    }
    return std::min(side / std::sqrt(std::max(area, 1e-6)), (side - 2 * TextureAtlas::kGutter) / longest);
}

}  // namespace

Vec2 TextureAtlas::texelAt(const PlacedChart& placed, Vec3 point) const {
    const Vec2 corner(placed.place.x + kGutter, placed.place.y + kGutter);
    return corner + (placed.chart.coordinatesOf(point) - placed.chart.low) * m_density;
}

Vec3 TextureAtlas::pointAt(const PlacedChart& placed, Vec2 texel, const ChartFace& face) const {
    const Vec2 corner(placed.place.x + kGutter, placed.place.y + kGutter);
    return placed.chart.pointAt(placed.chart.low + (texel - corner) / m_density, face);
}

Mesh TextureAtlas::textured(std::size_t part, const Mesh& mesh) const {
    Mesh result = mesh;
    result.uvs.clear();
    result.tangents.reserve(mesh.faces.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;  // by chart and position, or uv without
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const MeshFace& face = mesh.faces[f];
        const Vec3 normal = mesh.normals[face.normal];
        const std::uint32_t number = chartOf(part, f);
        const PlacedChart* placed = number == MeshCharts::kNoChart ? nullptr : &m_charts[number];
        for (std::uint32_t k = face.firstCorner; k < face.firstCorner + face.cornerCount; ++k) {
            const MeshCorner corner = mesh.corners[k];
            const auto next = static_cast<std::uint32_t>(result.uvs.size());
            const auto [at, isNew] = known.try_emplace({number, placed ? corner.position : corner.uv}, next);
            result.corners[k].uv = at->second;
            if (!isNew) continue;
            const Vec3 point = mesh.positions[corner.position] + m_offsets[part];
            result.uvs.push_back(placed ? texelAt(*placed, point) / static_cast<double>(m_side) : mesh.uvs[corner.uv]);
        }
        const Vec3 size = glm::abs(normal);
        const Vec3 other = size.x <= size.y && size.x <= size.z ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 0.0, 1.0);
        const Vec3 along =
            placed ? placed->chart.tangentOf(normal) : glm::normalize(other - normal * glm::dot(other, normal));
        result.tangents.emplace_back(along, 1.0);
    }
    return result;
}

void TextureAtlasBuilder::add(const Mesh& mesh, Vec3 offset) {
    MeshCharts charts = chartsOf(mesh, offset, m_sides);
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t k = 0; k < charts.charts.size(); ++k)
        numbers.push_back(chartNumber(std::move(charts.charts[k]), mesh, offset, charts.groups[k]));
    m_atlas.m_firstFaces.push_back(m_atlas.m_ofFaces.size());
    m_atlas.m_offsets.push_back(offset);
    for (const std::uint32_t chart : charts.ofFaces)
        m_atlas.m_ofFaces.push_back(chart == MeshCharts::kNoChart ? chart : numbers[chart]);
}

/// The number of a chart of a mesh in the atlas: a new one, or that of its plane.
std::uint32_t TextureAtlasBuilder::chartNumber(SurfaceChart chart, const Mesh& mesh, Vec3 offset,
                                               std::span<const std::uint32_t> faces) {
    const auto next = static_cast<std::uint32_t>(m_atlas.m_charts.size());
    if (chart.side == FinishSide::Outside && chart.isPlanar()) {
        const auto steps = [](double value) { return std::llround(value * kPlaneSteps); };
        const PlaneKey key{steps(chart.normal.x), steps(chart.normal.y), steps(chart.normal.z),
                           steps(chart.faces[0].distance)};
        const auto [plane, isNew] = m_planes.try_emplace(key, next);
        if (!isNew) {
            SurfaceChart& shared = m_atlas.m_charts[plane->second].chart;
            for (const std::uint32_t f : faces) {
                for (const MeshCorner corner : mesh.cornersOf(mesh.faces[f])) {
                    const Vec2 place = shared.coordinatesOf(mesh.positions[corner.position] + offset);
                    shared.low = glm::min(shared.low, place);
                    shared.high = glm::max(shared.high, place);
                }
            }
            return plane->second;
        }
    }
    m_atlas.m_charts.push_back({std::move(chart), {}, {}});
    return next;
}

Result<TextureAtlas> TextureAtlasBuilder::atlas(int side) && {
    std::vector<PlacedChart>& charts = m_atlas.m_charts;
    for (PlacedChart& placed : charts) layDown(placed.chart);
    const auto placesAt = [&](double density) { return packedInShelves(sizesOf(charts, density), side); };
    std::optional<std::vector<TexelPlace>> places = placesAt(0.0);
    if (!places) {
        return Error{ErrorCode::Limit, std::to_string(charts.size()) + " faces do not fit into a texture of " +
                                           std::to_string(side) + " × " + std::to_string(side) + " texels."};
    }
    double fitting = 0.0, tooDense = maxDensity(charts, side) * (1.0 + 1e-9);
    for (int step = 0; step < 24; ++step) {
        const double density = step == 0 ? tooDense : 0.5 * (fitting + tooDense);
        std::optional<std::vector<TexelPlace>> denser = placesAt(density);
        if (!denser) {
            tooDense = density;
            continue;
        }
        fitting = density;
        places = std::move(denser);
        if (step == 0) break;
    }
    const std::vector<TexelSize> sizes = sizesOf(charts, fitting);
    for (std::size_t k = 0; k < charts.size(); ++k) {
        charts[k].place = (*places)[k];
        charts[k].size = sizes[k];
    }
    m_atlas.m_side = side;
    m_atlas.m_density = std::max(fitting, 1e-9);
    return std::move(m_atlas);
}

}  // namespace rubble
