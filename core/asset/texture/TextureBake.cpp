#include "core/asset/texture/TextureBake.h"

#include "core/asset/texture/ChartOwners.h"
#include "core/base/Parallel.h"
#include "core/base/math/Power.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace rubble {
namespace {

constexpr int kBandRows = 32;  // of a chart, that one thread computes

/// From linear light to a byte of sRGB.
/// Source: IEC 61966-2-1.
class SrgbTable {
public:
    SrgbTable() {
        for (std::size_t k = 0; k < m_bounds.size(); ++k) {
            const double value = (static_cast<double>(k) + 0.5) / 255.0;
            m_bounds[k] = value <= 0.04045 ? value / 12.92 : power((value + 0.055) / 1.055, 2.4);
        }
    }
    std::uint8_t byteOf(double linear) const {
        return static_cast<std::uint8_t>(std::ranges::upper_bound(m_bounds, linear) - m_bounds.begin());
    }

private:
    std::array<double, 255> m_bounds;  // between each two bytes
};

std::uint8_t unitByte(double value) {
    return static_cast<std::uint8_t>(std::floor(255.0 * std::clamp(value, 0.0, 1.0) + 0.5));
}
std::uint8_t signedByte(double value) {
    return static_cast<std::uint8_t>(std::clamp(std::floor(127.5 * value + 128.0), 0.0, 255.0));
}

/// Some rows of a chart.
struct Band {
    std::size_t chart = 0;
    int first = 0, end = 0;
};

std::vector<Band> bandsOf(const TextureAtlas& atlas) {
    std::vector<Band> bands;
    for (std::size_t k = 0; k < atlas.charts().size(); ++k) {
        const int height = atlas.charts()[k].size.height;
        for (int row = 0; row < height; row += kBandRows) bands.push_back({k, row, std::min(height, row + kBandRows)});
    }
    return bands;
}

class MapBaker {
public:
    MapBaker(const TextureAtlas& atlas, const SurfaceFinish& outside, const SurfaceFinish& inside)
        : m_atlas(atlas), m_outside(outside), m_inside(inside) {
        const auto texels = static_cast<std::size_t>(atlas.side()) * static_cast<std::size_t>(atlas.side());
        m_maps.side = atlas.side();
        m_owners.resize(atlas.charts().size());
        m_maps.colour.assign(3 * texels, 0);
        m_maps.normal.assign(3 * texels, 128);
        m_maps.surface.assign(3 * texels, 255);
        for (std::size_t k = 0; k < texels; ++k) {
            m_maps.normal[3 * k + 2] = 255;
            m_maps.surface[3 * k + 2] = 0;
        }
    }

    /// To be called for each chart before its bands are filled.
    void prepare(std::size_t chart) {
        const PlacedChart& placed = m_atlas.charts()[chart];
        if (!placed.chart.isPlanar()) m_owners[chart] = chartOwners(placed, m_atlas.density());
    }
    void fill(const Band& band) {
        const PlacedChart& placed = m_atlas.charts()[band.chart];
        placed.chart.isPlanar() ? fillPlanar(placed, band) : fillCurved(placed, band);
    }
    BakedMaps maps() && { return std::move(m_maps); }

private:
    const SurfaceFinish& finishOf(const PlacedChart& placed) const {
        return placed.chart.side == FinishSide::Outside ? m_outside : m_inside;
    }
    static Vec2 centreOf(const PlacedChart& placed, int column, int row) {
        return Vec2(placed.place.x + column, placed.place.y + row) + 0.5;
    }

    /// The heights of its neighbours are those of the slope of a texel.
    void fillPlanar(const PlacedChart& placed, const Band& band) {
        const ChartFace& face = placed.chart.faces[0];
        const SurfaceFinish& finish = finishOf(placed);
        const int width = placed.size.width, stride = width + 2;
        std::vector<FinishedSurface> surfaces;
        surfaces.reserve(static_cast<std::size_t>(stride) * static_cast<std::size_t>(band.end - band.first + 2));
        for (int row = band.first - 1; row <= band.end; ++row) {
            for (int column = -1; column <= width; ++column)
                surfaces.push_back(
                    finish.at(m_atlas.pointAt(placed, centreOf(placed, column, row), face), face.normal));
        }
        const double across = 0.5 * m_atlas.density();
        for (int row = band.first; row < band.end; ++row) {
            for (int column = 0; column < width; ++column) {
                const auto at = static_cast<std::size_t>((row - band.first + 1) * stride + column + 1);
                const auto up = static_cast<std::size_t>(stride);
                const Vec2 slope{(surfaces[at + 1].height - surfaces[at - 1].height) * across,
                                 (surfaces[at + up].height - surfaces[at - up].height) * across};
                write(placed, column, row, surfaces[at], slope);
            }
        }
    }

    /// Each texel has a face of its own, in whose plane its slope is found.
    void fillCurved(const PlacedChart& placed, const Band& band) {
        const SurfaceFinish& finish = finishOf(placed);
        const std::vector<std::uint32_t>& owners = m_owners[band.chart];
        const double step = 1.0 / m_atlas.density();
        for (int row = band.first; row < band.end; ++row) {
            for (int column = 0; column < placed.size.width; ++column) {
                const auto at = static_cast<std::size_t>(row * placed.size.width + column);
                const ChartFace& face = placed.chart.faces[owners[at]];
                const Vec3 point = m_atlas.pointAt(placed, centreOf(placed, column, row), face);
                const Vec3 along = placed.chart.tangentOf(face.normal), up = glm::cross(face.normal, along);
                const auto slope = [&](Vec3 direction) {
                    const double above = finish.at(point + step * direction, face.normal).height;
                    return (above - finish.at(point - step * direction, face.normal).height) / (2.0 * step);
                };
                write(placed, column, row, finish.at(point, face.normal), {slope(along), slope(up)});
            }
        }
    }

    void write(const PlacedChart& placed, int column, int row, const FinishedSurface& surface, Vec2 slope) {
        const auto side = static_cast<std::size_t>(m_maps.side);
        const std::size_t x = static_cast<std::size_t>(placed.place.x + column),
                          y = side - 1 - static_cast<std::size_t>(placed.place.y + row), at = 3 * (y * side + x);
        const Vec3 normal = glm::normalize(Vec3(-slope, 1.0));
        for (int k = 0; k < 3; ++k) {
            m_maps.colour[at + static_cast<std::size_t>(k)] = m_srgb.byteOf(surface.albedo[k]);
            m_maps.normal[at + static_cast<std::size_t>(k)] = signedByte(normal[k]);
        }
        m_maps.surface[at + 1] = unitByte(surface.roughness);
        m_maps.surface[at + 2] = unitByte(surface.metalness);
    }

    const TextureAtlas& m_atlas;
    const SurfaceFinish& m_outside;
    const SurfaceFinish& m_inside;
    SrgbTable m_srgb;
    std::vector<std::vector<std::uint32_t>> m_owners;  // of charts that are not planar
    BakedMaps m_maps;
};

}  // namespace

Result<BakedMaps> bakedMaps(const TextureAtlas& atlas, const SurfaceFinish& outside, const SurfaceFinish& inside,
                            const TaskContext& task) {
    const std::vector<Band> bands = bandsOf(atlas);
    MapBaker baker(atlas, outside, inside);
    std::atomic<std::size_t> done = 0;
    forEachIndex(atlas.charts().size(), task.threads, [&](std::size_t k) { baker.prepare(k); });
    forEachIndex(bands.size(), task.threads, [&](std::size_t k) {
        if (task.isCancelled()) return;
        baker.fill(bands[k]);
        ++done;
    });
    if (done < bands.size()) return TaskContext::cancelled();
    return std::move(baker).maps();
}

}  // namespace rubble
