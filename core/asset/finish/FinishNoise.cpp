#include "core/asset/finish/FinishNoise.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// A random number for a point of a lattice that repeats after `period`.
/// Source: Jarzynski, Olano, "Hash functions for GPU rendering", 2020 (PCG).
std::uint32_t hashOf(const std::array<int, 3>& point, int period, std::uint32_t number) {
    std::uint32_t state = number * 2654435769u;
    for (const int coordinate : point) {
        state += static_cast<std::uint32_t>((coordinate % period + period) % period);
        state = state * 747796405u + 2891336453u;
        const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
        state = (word >> 22u) ^ word;
    }
    return state;
}

double unitOf(std::uint32_t hash) { return static_cast<double>(hash >> 8u) / 16777216.0; }

/// One of the twelve directions from the middle of a cube to its edges, times an offset.
double slope(std::uint32_t hash, Vec3 offset) {
    const std::uint32_t edge = hash % 12;
    const int zero = static_cast<int>(edge / 4), one = (zero + 1) % 3, two = (zero + 2) % 3;
    return ((edge & 1u) != 0 ? -offset[one] : offset[one]) + ((edge & 2u) != 0 ? -offset[two] : offset[two]);
}

double eased(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }

/// Gradient noise, about in [-1, 1], of `period` cells in the cube.
double gradientNoise(Vec3 place, int period, std::uint32_t number) {
    const Vec3 scaled = static_cast<double>(period) * place, low = glm::floor(scaled), part = scaled - low;
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const std::array<int, 3> step{corner & 1, corner >> 1 & 1, corner >> 2};
        double weight = 1.0;
        Vec3 offset = part;
        std::array<int, 3> point{};
        for (int axis = 0; axis < 3; ++axis) {
            weight *= step[axis] != 0 ? eased(part[axis]) : 1.0 - eased(part[axis]);
            offset[axis] -= step[axis];
            point[axis] = static_cast<int>(low[axis]) + step[axis];
        }
        sum += weight * slope(hashOf(point, period, number), offset);
    }
    return sum;
}

double octaves(Vec3 place, std::uint32_t number) {
    double sum = 0.0, amplitude = 0.5;
    for (int period = FinishNoise::kCells / 2; period <= 2 * FinishNoise::kCells; period *= 2, amplitude *= 0.6)
        sum += amplitude * gradientNoise(place, period, number + static_cast<std::uint32_t>(period));
    return std::clamp(0.5 + 0.75 * sum, 0.0, 1.0);
}

/// The distance to the nearest point of a jittered grid, and its random number.
std::array<double, 2> nearestPoint(Vec3 place) {
    const Vec3 scaled = static_cast<double>(FinishNoise::kCells) * place, low = glm::floor(scaled);
    double nearest = 1e9;
    std::uint32_t found = 0;
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
        std::array<int, 3> cell{};
        const std::array<int, 3> step{neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1};
        Vec3 point(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            cell[axis] = static_cast<int>(low[axis]) + step[axis];
            const std::uint32_t hash = hashOf(cell, FinishNoise::kCells, static_cast<std::uint32_t>(40 + axis));
            point[axis] = cell[axis] + unitOf(hash);
        }
        const double distance = glm::distance(point, scaled);
        if (distance >= nearest) continue;
        nearest = distance;
        found = hashOf(cell, FinishNoise::kCells, 50);
    }
    return {std::min(nearest, 1.0), unitOf(found)};
}

std::uint8_t byteOf(double value) { return static_cast<std::uint8_t>(std::lround(255.0 * value)); }

}  // namespace

FinishNoise::FinishNoise() {
    m_texels.reserve(std::size_t{4} * kSide * kSide * kSide);
    for (int z = 0; z < kSide; ++z) {
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const Vec3 place = (Vec3(x, y, z) + 0.5) / static_cast<double>(kSide);
                const auto [distance, random] = nearestPoint(place);
                for (const double value : {octaves(place, 1), octaves(place, 2), distance, random})
                    m_texels.push_back(byteOf(value));
            }
        }
    }
}

const FinishNoise& FinishNoise::shared() {
    static const FinishNoise noise;
    return noise;
}

std::array<double, 4> FinishNoise::at(Vec3 place) const {
    const Vec3 texel = static_cast<double>(kSide) * place - 0.5, low = glm::floor(texel), part = texel - low;
    std::array<double, 4> sum{};
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        std::size_t index = 0;
        for (int axis = 2; axis >= 0; --axis) {
            const int step = corner >> axis & 1;
            weight *= step != 0 ? part[axis] : 1.0 - part[axis];
            const auto at = static_cast<long long>(low[axis]) + step;
            index = index * kSide + static_cast<std::size_t>((at % kSide + kSide) % kSide);
        }
        for (std::size_t channel = 0; channel < 4; ++channel)
            sum[channel] += weight / 255.0 * m_texels[4 * index + channel];
    }
    return sum;
}

}  // namespace rubble
