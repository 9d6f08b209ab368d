#include "core/asset/texture/ChartOwners.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

constexpr std::uint32_t kNoOwner = std::numeric_limits<std::uint32_t>::max();

/// Whether a place is in a convex polygon or on its outline.
bool isIn(const std::vector<Vec2>& shape, Vec2 place) {
    for (std::size_t k = 0; k < shape.size(); ++k) {
        const Vec2 edge = shape[(k + 1) % shape.size()] - shape[k], to = place - shape[k];
        if (edge.x * to.y - edge.y * to.x < 0.0) return false;
    }
    return true;
}

class OwnerGrid {
public:
    explicit OwnerGrid(TexelSize size)
        : m_width(size.width),
          m_height(size.height),
          m_owners(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), kNoOwner) {}

    /// `shape`: in texels.
    void add(const std::vector<Vec2>& shape, std::uint32_t face) {
        Vec2 low = shape[0], high = shape[0];
        for (const Vec2 corner : shape) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
        const int left = std::max(0, static_cast<int>(std::floor(low.x))),
                  bottom = std::max(0, static_cast<int>(low.y));
        const int right = std::min(m_width - 1, static_cast<int>(high.x)),
                  top = std::min(m_height - 1, static_cast<int>(high.y));
        for (int row = bottom; row <= top; ++row) {
            for (int column = left; column <= right; ++column) {
                const std::size_t at = indexOf(column, row);
                if (m_owners[at] == kNoOwner && isIn(shape, Vec2(column, row) + 0.5)) own(at, face);
            }
        }
    }

    /// Spreads faces to the texels that have none.
    std::vector<std::uint32_t> filled() && {
        if (m_order.empty()) own(0, 0);
        for (std::size_t k = 0; k < m_order.size(); ++k) {
            const std::size_t at = m_order[k];
            const int column = static_cast<int>(at % static_cast<std::size_t>(m_width)),
                      row = static_cast<int>(at / static_cast<std::size_t>(m_width));
            const auto spread = [&](int x, int y) {
                if (x < 0 || y < 0 || x >= m_width || y >= m_height || m_owners[indexOf(x, y)] != kNoOwner) return;
                own(indexOf(x, y), m_owners[at]);
            };
            spread(column - 1, row);
            spread(column + 1, row);
            spread(column, row - 1);
            spread(column, row + 1);
        }
        return std::move(m_owners);
    }

private:
    std::size_t indexOf(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(column);
    }
    void own(std::size_t at, std::uint32_t face) {
        m_owners[at] = face;
        m_order.push_back(at);
    }

    int m_width, m_height;
    std::vector<std::uint32_t> m_owners;
    std::vector<std::size_t> m_order;  // of the texels that have a face
};

}  // namespace

std::vector<std::uint32_t> chartOwners(const PlacedChart& placed, double density) {
    OwnerGrid grid(placed.size);
    const SurfaceChart& chart = placed.chart;
    for (std::uint32_t f = 0; f < chart.faces.size(); ++f) {
        std::vector<Vec2> shape;
        for (const Vec2 corner : chart.faces[f].shape)
            shape.push_back((corner - chart.low) * density + static_cast<double>(TextureAtlas::kGutter));
        if (!shape.empty()) grid.add(shape, f);
    }
    return std::move(grid).filled();
}

}  // namespace rubble
