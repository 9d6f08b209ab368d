#include "viewport/render/light/ReflectionMap.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble {
namespace {

/// The widths of the maps that a level is computed from and for: a lobe is wider than a texel of the former.
struct LevelWidths {
    int source;
    int made;
};
constexpr std::array<LevelWidths, ReflectionMap::kLevels> kLevelWidths{
    {{64, 64}, {64, 32}, {64, 32}, {32, 16}, {32, 16}, {32, 16}}};

double signOf(double number) { return number < 0.0 ? -1.0 : 1.0; }

/// The point of the octahedron |x| + |y| + |z| = 1 at a point of the square [-1, 1]²; a little beyond is folded over.
Vec3 onOctahedron(Vec2 p) {
    if (std::abs(p.x) > 1.0) p = {signOf(p.x) * 2.0 - p.x, -p.y};
    if (std::abs(p.y) > 1.0) p = {-p.x, signOf(p.y) * 2.0 - p.y};
    const double up = 1.0 - std::abs(p.x) - std::abs(p.y);
    if (up < 0.0) p = {(1.0 - std::abs(p.y)) * signOf(p.x), (1.0 - std::abs(p.x)) * signOf(p.y)};
    return {p.x, up, p.y};
}

/// The point of the square for a direction.
Vec2 inSquare(Vec3 direction) {
    const Vec3 p = direction / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
    if (p.y >= 0.0) return {p.x, p.z};
    return {(1.0 - std::abs(p.z)) * signOf(p.x), (1.0 - std::abs(p.x)) * signOf(p.z)};
}

/// A map without a border.
struct PlainMap {
    int width = 0;
    std::vector<Vec3> texels;

    Vec2 centre(int x, int y) const { return {2.0 * (x + 0.5) / width - 1.0, 2.0 * (y + 0.5) / width - 1.0}; }
    /// The texel at integer coordinates from -1 to `width`.
    Vec3 texel(int x, int y) const {
        const Vec2 folded = inSquare(onOctahedron(centre(x, y)));
        const auto at = [this](double p) {
            return std::clamp(static_cast<int>(std::floor(0.5 * (p + 1.0) * width)), 0, width - 1);
        };
        return texels[static_cast<std::size_t>(at(folded.y) * width + at(folded.x))];
    }
    Vec3 bilinear(Vec2 p) const {
        const Vec2 at = 0.5 * width * (p + 1.0) - 0.5, first = glm::floor(at), part = at - first;
        const int x = static_cast<int>(first.x), y = static_cast<int>(first.y);
        return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), part.x),
                        glm::mix(texel(x, y + 1), texel(x + 1, y + 1), part.x), part.y);
    }
};

PlainMap sampled(const std::function<Vec3(Vec3)>& radiance, int width) {
    PlainMap map{width, {}};
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) map.texels.push_back(radiance(glm::normalize(onOctahedron(map.centre(x, y)))));
    }
    return map;
}

PlainMap halved(const PlainMap& map) {
    PlainMap half{map.width / 2, {}};
    for (int y = 0; y < map.width; y += 2) {
        for (int x = 0; x < map.width; x += 2)
            half.texels.push_back(
                0.25 * (map.texel(x, y) + map.texel(x + 1, y) + map.texel(x, y + 1) + map.texel(x + 1, y + 1)));
    }
    return half;
}

/// The directions of a map's texels, their solid angles, and their radiance times these.
struct Directions {
    std::vector<float> x, y, z, red, green, blue, solidAngle;
};
Directions directionsOf(const PlainMap& map) {
    Directions directions;
    for (int y = 0; y < map.width; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const Vec3 p = onOctahedron(map.centre(x, y));
            const double length = glm::length(p), angle = 1.0 / (length * length * length);
            const Vec3 arriving = angle * map.texel(x, y);
            directions.x.push_back(static_cast<float>(p.x / length));
            directions.y.push_back(static_cast<float>(p.y / length));
            directions.z.push_back(static_cast<float>(p.z / length));
            directions.red.push_back(static_cast<float>(arriving.x));
            directions.green.push_back(static_cast<float>(arriving.y));
            directions.blue.push_back(static_cast<float>(arriving.z));
            directions.solidAngle.push_back(static_cast<float>(angle));
        }
    }
    return directions;
}

/// The mean over the lobe of a surface seen along its normal `n`: D(h) n.l, where n.h² = (1 + n.l) / 2.
Vec3 meanOverLobe(const Directions& from, Vec3 n, double roughness) {
    const auto nx = static_cast<float>(n.x), ny = static_cast<float>(n.y), nz = static_cast<float>(n.z);
    const float alpha = static_cast<float>(roughness * roughness), change = alpha * alpha - 1.0f;
    float red = 0.0f, green = 0.0f, blue = 0.0f, weights = 0.0f;
    for (std::size_t k = 0; k < from.x.size(); ++k) {
        const float facing = std::max(nx * from.x[k] + ny * from.y[k] + nz * from.z[k], 0.0f);
        const float width = 1.0f + 0.5f * (1.0f + facing) * change;
        const float weight = facing / (width * width);
        red += weight * from.red[k];
        green += weight * from.green[k];
        blue += weight * from.blue[k];
        weights += weight * from.solidAngle[k];
    }
    return Vec3(red, green, blue) / static_cast<double>(weights);
}

PlainMap filtered(const PlainMap& source, int width, double roughness) {
    const Directions directions = directionsOf(source);
    return sampled([&](Vec3 n) { return meanOverLobe(directions, n, roughness); }, width);
}

}  // namespace

ReflectionMap reflectionMap(const std::function<Vec3(Vec3)>& radiance) {
    PlainMap source = sampled(radiance, ReflectionMap::kWidth);
    ReflectionMap map;
    map.texels.reserve(std::size_t{ReflectionMap::kLevels} * ReflectionMap::kStored * ReflectionMap::kStored);
    for (int level = 0; level < ReflectionMap::kLevels; ++level) {
        const LevelWidths widths = kLevelWidths[static_cast<std::size_t>(level)];
        while (source.width > widths.source) source = halved(source);
        const double roughness = static_cast<double>(level) / (ReflectionMap::kLevels - 1);
        const PlainMap made = level == 0 ? source : filtered(source, widths.made, roughness);
        for (int y = 0; y < ReflectionMap::kStored; ++y) {
            for (int x = 0; x < ReflectionMap::kStored; ++x) {
                const Vec2 at = (2.0 * Vec2(x, y) - 1.0) / static_cast<double>(ReflectionMap::kWidth) - 1.0;
                map.texels.emplace_back(made.bilinear(inSquare(onOctahedron(at))));
            }
        }
    }
    return map;
}

Vec2 placeInReflections(Vec3 direction) {
    const Vec2 within = 0.5 * (inSquare(direction) + 1.0) * static_cast<double>(ReflectionMap::kWidth);
    return (within + 1.0) / static_cast<double>(ReflectionMap::kStored);
}

Vec3 directionInReflections(Vec2 place) {
    const Vec2 within = place * static_cast<double>(ReflectionMap::kStored) - 1.0;
    return glm::normalize(onOctahedron(2.0 * within / static_cast<double>(ReflectionMap::kWidth) - 1.0));
}

Vec3 reflected(const ReflectionMap& map, Vec3 direction, double roughness) {
    constexpr int kStored = ReflectionMap::kStored;
    const Vec2 at = placeInReflections(direction) * static_cast<double>(kStored) - 0.5;
    const double level = roughness * (ReflectionMap::kLevels - 1);
    const auto mixed = [&](int layer) {
        const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
        const auto texel = [&](int dx, int dy) {
            return Vec3(map.texels[static_cast<std::size_t>((layer * kStored + y + dy) * kStored + x + dx)]);
        };
        const Vec2 part = at - Vec2(x, y);
        return glm::mix(glm::mix(texel(0, 0), texel(1, 0), part.x), glm::mix(texel(0, 1), texel(1, 1), part.x), part.y);
    };
    const int lower = std::min(static_cast<int>(level), ReflectionMap::kLevels - 2);
    return glm::mix(mixed(lower), mixed(lower + 1), level - lower);
}

}  // namespace rubble
