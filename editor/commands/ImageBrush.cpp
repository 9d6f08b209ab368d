#include "editor/commands/ImageBrush.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kDabSpacing = 0.25;  // of the radius

/// The opacity of a dab by the distance from its centre over the radius: 1 in the inner half, then a smooth falloff.
double falloffAt(double distance) {
    const double fall = std::clamp(2.0 * (1.0 - distance), 0.0, 1.0);
    return fall * fall * (3.0 - 2.0 * fall);
}

class Painter {
public:
    Painter(GreyImage& picture, const Box2& box)
        : m_picture(picture), m_box(box), m_pixel(box.size() / Vec2(picture.width, picture.height)) {}

    void dab(Vec2 centre, const Brush& brush) {
        const auto columnOf = [&](double x) { return std::floor((x - m_box.min.x) / m_pixel.x); };
        const auto rowOf = [&](double y) { return std::floor((m_box.max.y - y) / m_pixel.y); };
        const double right = std::min(columnOf(centre.x + brush.radius), m_picture.width - 1.0);
        const double bottom = std::min(rowOf(centre.y - brush.radius), m_picture.height - 1.0);
        for (double row = std::max(rowOf(centre.y + brush.radius), 0.0); row <= bottom; ++row) {
            for (double column = std::max(columnOf(centre.x - brush.radius), 0.0); column <= right; ++column) {
                const Vec2 point(m_box.min.x + (column + 0.5) * m_pixel.x, m_box.max.y - (row + 0.5) * m_pixel.y);
                const double opacity = brush.strength * falloffAt(glm::distance(point, centre) / brush.radius);
                if (opacity > 0.0)
                    mix(static_cast<std::size_t>(row) * m_picture.width + static_cast<std::size_t>(column), brush.value,
                        opacity);
            }
        }
    }

private:
    void mix(std::size_t pixel, double value, double opacity) {
        const double white = m_picture.white();
        const auto mixed = [&](std::uint16_t before, double after) {
            // At least one grey level, so that a faint brush reaches its value.
            const double exact = before + (after - before) * opacity;
            return static_cast<std::uint16_t>(after > before ? std::ceil(exact) : std::floor(exact));
        };
        m_picture.grey[pixel] = mixed(m_picture.grey[pixel], value * white);
        if (!m_picture.opacity.empty()) m_picture.opacity[pixel] = mixed(m_picture.opacity[pixel], white);
    }

    GreyImage& m_picture;
    const Box2 m_box;
    const Vec2 m_pixel;  // m
};

}  // namespace

GreyImage uniformImage(const Box2& box, double value, std::uint32_t longer) {
    const Vec2 size = box.size();
    const double side = std::max(size.x, size.y) / longer;
    const auto along = [&](double length) {
        return static_cast<std::uint32_t>(std::clamp(std::round(length / side), 1.0, static_cast<double>(longer)));
    };
    GreyImage picture{.width = along(size.x), .height = along(size.y), .bits = 8};
    picture.grey.assign(std::size_t{picture.width} * picture.height,
                        static_cast<std::uint16_t>(std::lround(value * picture.white())));
    return picture;
}

GreyImage painted(GreyImage picture, const Box2& box, Vec2 from, Vec2 to, const Brush& brush) {
    Painter painter(picture, box);
    const double dabs = std::max(1.0, std::ceil(glm::distance(from, to) / (kDabSpacing * brush.radius)));
    for (double k = 1.0; k <= dabs; ++k) painter.dab(from + (to - from) * (k / dabs), brush);
    return picture;
}

}  // namespace rubble
