#include "viewport/render/light/SkyImage.h"

#include "core/base/math/Trigonometry.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMinEdge = 0.1;                                // of the brightest pixel, for those of the same lamp
constexpr double kMinContrast = 4.0;                            // of a lamp with the mean of the sky
constexpr double kMinShare = 0.15;                              // of the light, that a key light gives
constexpr double kMinKeyRadius = 0.0047, kMaxKeyRadius = 0.15;  // the sun; shadows of a larger lamp cannot be seen
constexpr double kMaxKeyExtent = 0.35;                          // of its pixels from the brightest one, rad

Vec3 colourOf(const std::array<float, 3>& pixel) { return {pixel[0], pixel[1], pixel[2]}; }

Vec3 directionOfPixel(const RadianceImage& image, std::size_t index) {
    const double x = static_cast<double>(index % image.width), y = static_cast<double>(index / image.width);
    return directionInSky({(x + 0.5) / image.width, (y + 0.5) / image.height});
}

/// Calls `visit` with the indices of the pixels around one, above the horizon.
template <class Visit>
void forEachNeighbour(const RadianceImage& image, std::size_t index, Visit visit) {
    const auto width = static_cast<std::int64_t>(image.width), rows = std::int64_t{rowsAboveHorizon(image)};
    const std::int64_t x = static_cast<std::int64_t>(index) % width, y = static_cast<std::int64_t>(index) / width;
    for (std::int64_t row = std::max<std::int64_t>(y - 1, 0); row <= std::min(y + 1, rows - 1); ++row) {
        for (std::int64_t column = x - 1; column <= x + 1; ++column) {
            const std::int64_t at = row * width + (column + width) % width;
            if (at != static_cast<std::int64_t>(index)) visit(static_cast<std::size_t>(at));
        }
    }
}

/// Pixels that belong together.
struct Region {
    std::vector<std::size_t> pixels;
    std::vector<bool> isMember;  // for each pixel above the horizon

    explicit Region(const RadianceImage& image) : isMember(std::size_t{rowsAboveHorizon(image)} * image.width) {}
    void add(std::size_t index) {
        if (isMember[index]) return;
        isMember[index] = true;
        pixels.push_back(index);
    }
};

/// The pixels around a region.
std::vector<std::size_t> ringAround(const RadianceImage& image, const Region& region) {
    Region ring(image);
    for (const std::size_t index : region.pixels) {
        forEachNeighbour(image, index, [&](std::size_t at) {
            if (!region.isMember[at]) ring.add(at);
        });
    }
    return ring.pixels;
}

/// Adds the pixels within a pixel and a half of those of a region; near the zenith columns are narrow.
void widen(const RadianceImage& image, Region& region) {
    const double nearest = cosine(1.5 * kFullTurn / image.width);
    const std::size_t count = region.pixels.size();
    std::vector<std::size_t> reached;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 centre = directionOfPixel(image, region.pixels[k]);
        reached = {region.pixels[k]};
        while (!reached.empty()) {
            const std::size_t last = reached.back();
            reached.pop_back();
            forEachNeighbour(image, last, [&](std::size_t at) {
                if (region.isMember[at] || glm::dot(directionOfPixel(image, at), centre) < nearest) return;
                region.add(at);
                reached.push_back(at);
            });
        }
    }
}

/// The connected pixels around one that are brighter than `least`, and those beside them, over which a lamp's edge is
/// blurred. None: they are too far apart.
std::optional<Region> lampAround(const RadianceImage& image, std::size_t brightest, double least) {
    Region lamp(image);
    lamp.add(brightest);
    const Vec3 centre = directionOfPixel(image, brightest);
    const double nearest = cosine(kMaxKeyExtent);
    bool isSmall = true;
    for (std::size_t k = 0; k < lamp.pixels.size() && isSmall; ++k) {
        isSmall = glm::dot(directionOfPixel(image, lamp.pixels[k]), centre) >= nearest;
        forEachNeighbour(image, lamp.pixels[k], [&](std::size_t at) {
            if (luminance(colourOf(image.pixels[at])) > least) lamp.add(at);
        });
    }
    if (!isSmall) return std::nullopt;
    widen(image, lamp);
    return lamp;
}

Vec3 meanOf(const RadianceImage& image, const std::vector<std::size_t>& pixels) {
    Vec3 sum(0.0);
    double angles = 0.0;
    for (const std::size_t index : pixels) {
        const double angle = solidAngle(image, static_cast<std::uint32_t>(index / image.width));
        sum += angle * colourOf(image.pixels[index]);
        angles += angle;
    }
    return angles > 0.0 ? sum / angles : sum;
}

/// What is brighter in a region than around it, as one lamp. The radius is that of a disc of the same moment of
/// inertia.
DirectionalLight lightOf(const RadianceImage& image, const Region& region, const Vec3& around) {
    Vec3 light(0.0), centre(0.0);
    double weights = 0.0;
    const auto forEachExcess = [&](auto visit) {
        for (const std::size_t index : region.pixels) {
            const double angle = solidAngle(image, static_cast<std::uint32_t>(index / image.width));
            const Vec3 excess = angle * glm::max(colourOf(image.pixels[index]) - around, 0.0);
            visit(directionOfPixel(image, index), excess);
        }
    };
    forEachExcess([&](const Vec3& direction, const Vec3& excess) {
        light += excess;
        weights += luminance(excess);
        centre += luminance(excess) * direction;
    });
    if (weights == 0.0) return {{0.0, 1.0, 0.0}, Vec3(0.0), kMinKeyRadius};
    centre = glm::normalize(centre);
    double spread = 0.0;
    forEachExcess([&](const Vec3& direction, const Vec3& excess) {
        spread += luminance(excess) * glm::dot(direction - centre, direction - centre);
    });
    const double pixel = 0.5 * kFullTurn / image.height;
    const double radius = std::sqrt(2.0 * (spread / weights + pixel * pixel / 6.0));  // a pixel has a spread of its own
    return {centre, light / (0.5 * kFullTurn), std::max(radius, kMinKeyRadius)};
}

}  // namespace

Vec2 placeInSky(Vec3 direction) {
    const double horizontal = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    return {0.5 + angleOf(direction.x, -direction.z) / kFullTurn, 2.0 * angleOf(horizontal, direction.y) / kFullTurn};
}

Vec3 directionInSky(Vec2 place) {
    const double azimuth = kFullTurn * (place.x - 0.5), fromTop = 0.5 * kFullTurn * place.y;
    return {sine(fromTop) * sine(azimuth), cosine(fromTop), -sine(fromTop) * cosine(azimuth)};
}

std::uint32_t rowsAboveHorizon(const RadianceImage& image) { return std::max(image.height / 2, 1u); }

double solidAngle(const RadianceImage& image, std::uint32_t row) {
    const double step = 0.5 * kFullTurn / image.height;
    return kFullTurn / image.width * (cosine(step * row) - cosine(step * (row + 1)));
}

double luminance(const Vec3& colour) { return glm::dot(colour, Vec3(0.2126, 0.7152, 0.0722)); }

Vec3 meanRadiance(const RadianceImage& image) {
    Vec3 sum(0.0);
    double angles = 0.0;
    for (std::uint32_t row = 0; row < rowsAboveHorizon(image); ++row) {
        Vec3 inRow(0.0);
        for (std::uint32_t x = 0; x < image.width; ++x)
            inRow += colourOf(image.pixels[std::size_t{row} * image.width + x]);
        const double angle = solidAngle(image, row);
        sum += angle * inRow;
        angles += angle * image.width;
    }
    return sum / angles;
}

SkySampler::SkySampler(const RadianceImage& image, std::uint32_t maxWidth)
    : m_width(std::min(image.width, maxWidth)), m_rows(std::max<std::int64_t>(m_width / 4, 1)) {
    std::vector<double> weights(static_cast<std::size_t>(m_width * m_rows));
    m_pixels.resize(weights.size(), Vec3(0.0));
    const std::uint32_t rows = rowsAboveHorizon(image);
    for (std::uint32_t y = 0; y < rows; ++y) {
        const std::int64_t row = y * m_rows / rows;
        const double weight = solidAngle(image, y);
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const auto at = static_cast<std::size_t>(row * m_width + x * m_width / image.width);
            m_pixels[at] += weight * colourOf(image.pixels[std::size_t{y} * image.width + x]);
            weights[at] += weight;
        }
    }
    for (std::size_t k = 0; k < weights.size(); ++k) m_pixels[k] /= weights[k];
}

/// Columns go around, rows end at the zenith and the horizon.
const Vec3& SkySampler::pixel(std::int64_t x, std::int64_t y) const {
    const std::int64_t column = (x + m_width) % m_width, row = std::clamp<std::int64_t>(y, 0, m_rows - 1);
    return m_pixels[static_cast<std::size_t>(row * m_width + column)];
}

Vec3 SkySampler::operator()(Vec3 direction) const {
    const Vec2 place = placeInSky(direction);
    const Vec2 at = Vec2(place.x * static_cast<double>(m_width), 2.0 * place.y * static_cast<double>(m_rows)) - 0.5;
    const Vec2 first = glm::floor(at), part = at - first;
    const auto x = static_cast<std::int64_t>(first.x), y = static_cast<std::int64_t>(first.y);
    return glm::mix(glm::mix(pixel(x, y), pixel(x + 1, y), part.x),
                    glm::mix(pixel(x, y + 1), pixel(x + 1, y + 1), part.x), part.y);
}

std::optional<DirectionalLight> takeKeyLight(RadianceImage& image) {
    const auto end = image.pixels.begin() + std::ptrdiff_t{rowsAboveHorizon(image)} * image.width;
    const auto darker = [](const auto& one, const auto& other) {
        return luminance(colourOf(one)) < luminance(colourOf(other));
    };
    const auto brightest = std::max_element(image.pixels.begin(), end, darker);
    const double mean = luminance(meanRadiance(image)), peak = luminance(colourOf(*brightest));
    const double least = std::max(kMinEdge * peak, kMinContrast * mean);
    if (!(peak > least)) return std::nullopt;
    const auto lamp = lampAround(image, static_cast<std::size_t>(brightest - image.pixels.begin()), least);
    if (!lamp) return std::nullopt;
    const Vec3 around = meanOf(image, ringAround(image, *lamp));
    const DirectionalLight light = lightOf(image, *lamp, around);
    // The mean over the hemisphere is half of what a surface that faces a lamp reflects.
    if (light.radius > kMaxKeyRadius || 0.5 * luminance(light.light) < kMinShare * mean) return std::nullopt;
    const std::array<float, 3> left{static_cast<float>(around.x), static_cast<float>(around.y),
                                    static_cast<float>(around.z)};
    for (const std::size_t index : lamp->pixels) {
        for (std::size_t k = 0; k < 3; ++k) image.pixels[index][k] = std::min(image.pixels[index][k], left[k]);
    }
    return light;
}

}  // namespace rubble
