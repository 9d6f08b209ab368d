#include "core/fracture/solid/SampledHulls.h"

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/mesh/SolidMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace rubble {
namespace {

constexpr std::size_t kBetweenLooks = 1u << 14;  // steps between two looks at whether the task is cancelled

/// Points on a surface, each for the same area.
struct SurfaceSamples {
    std::vector<Vec3> points, normals;
    double area = 0.0;  // m², of each
};

/// About 20,000 points, at random places in the triangles at equal distances of area.
SurfaceSamples sampled(const TriangleMesh& mesh, const TaskContext& task) {
    constexpr int kSamples = 20'000;
    double whole = 0.0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) whole += glm::length(doubleArea(mesh, t)) / 2.0;
    SurfaceSamples samples;
    samples.area = whole / kSamples;
    Random random(mesh.triangles.size());
    double passed = 0.0;
    for (std::uint32_t t = 0; t < mesh.triangles.size() && whole > 0.0; ++t) {
        if (t % kBetweenLooks == 0 && task.isCancelled()) return {};
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 doubled = doubleArea(mesh, t);
        passed += glm::length(doubled) / 2.0;
        while ((static_cast<double>(samples.points.size()) + 0.5) * samples.area < passed) {
            const double s = std::sqrt(random.between(0.0, 1.0)), u = random.between(0.0, 1.0);
            samples.points.push_back((1.0 - s) * mesh.points[a] + s * (1.0 - u) * mesh.points[b] +
                                     s * u * mesh.points[c]);
            samples.normals.push_back(glm::normalize(doubled));
        }
    }
    return samples;
}

double squared(Vec3 v) { return glm::dot(v, v); }

/// Seeds with the samples in their cells.
class SampledCells {
public:
    SampledCells(const SurfaceSamples& samples, const TaskContext& task) : m_samples(samples), m_task(task) {}

    /// Adds seeds at the samples farthest from those that are there.
    void spread(std::size_t count) {
        const std::vector<Vec3>& points = m_samples.points;
        std::vector<double> distances(points.size(), std::numeric_limits<double>::infinity());
        std::size_t next = 0;
        while (seeds.size() < count && distances[next] > 0.0 && !m_task.isCancelled()) {
            seeds.push_back(points[next]);
            for (std::size_t k = 0; k < points.size(); ++k)
                distances[k] = std::min(distances[k], squared(points[k] - seeds.back()));
            next = static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin());
        }
    }

    /// Moves seeds to the means of their samples, which are assigned again.
    void relax(int rounds) {
        for (int round = 0; round < rounds && !m_task.isCancelled(); ++round) {
            assign();
            for (std::size_t seed = 0; seed < seeds.size(); ++seed) {
                if (m_ofSeed[seed].empty()) continue;
                Vec3 sum(0.0);
                for (const std::uint32_t k : m_ofSeed[seed]) sum += m_samples.points[k];
                seeds[seed] = sum / static_cast<double>(m_ofSeed[seed].size());
            }
        }
        assign();
    }

    /// Adds a seed to the cells whose surface is farthest below their hulls, by volume. Returns false where the volume
    /// is at most `allowed` m³, or there are as many seeds as may be.
    bool refine(double allowed, std::size_t most) {
        std::vector<std::pair<double, std::uint32_t>> excesses;
        double sum = 0.0;
        for (std::uint32_t seed = 0; seed < seeds.size() && !m_task.isCancelled(); ++seed) {
            excesses.emplace_back(-excessOf(seed), seed);
            sum -= excesses.back().first;
        }
        if (sum <= allowed || seeds.size() >= most || m_task.isCancelled()) return false;
        std::ranges::sort(excesses);
        const double ofEach = allowed / static_cast<double>(seeds.size());
        for (const auto& [negative, seed] : excesses) {
            if (-negative <= ofEach || seeds.size() >= most) break;
            const auto far = std::ranges::max_element(
                m_ofSeed[seed], {}, [&](std::uint32_t k) { return squared(m_samples.points[k] - seeds[seed]); });
            seeds.push_back(m_samples.points[*far]);
        }
        return true;
    }

    std::vector<Vec3> seeds;

private:
    void assign() {
        m_ofSeed.assign(seeds.size(), {});
        for (std::uint32_t k = 0; k < m_samples.points.size(); ++k) {
            if (k % kBetweenLooks == 0 && m_task.isCancelled()) return;
            const auto nearest =
                std::ranges::min_element(seeds, {}, [&](Vec3 seed) { return squared(m_samples.points[k] - seed); });
            m_ofSeed[static_cast<std::size_t>(nearest - seeds.begin())].push_back(k);
        }
    }

    /// The volume between the surface in a cell and its hull, m³: each sample's area times the way along its normal.
    double excessOf(std::uint32_t seed) const {
        std::vector<Vec3> points;
        for (const std::uint32_t k : m_ofSeed[seed]) points.push_back(m_samples.points[k]);
        const Result<Polytope> hull = convexHull(points);
        if (!hull) return 0.0;  // flat
        double sum = 0.0;
        for (const std::uint32_t k : m_ofSeed[seed]) {
            constexpr double kAlong = 1e-6;  // planes that a way is parallel to
            double way = std::numeric_limits<double>::infinity();
            for (const Plane& plane : hull->planes) {
                const double slope = glm::dot(plane.normal, m_samples.normals[k]);
                if (slope <= kAlong) continue;
                way = std::min(way, (plane.offset - glm::dot(plane.normal, m_samples.points[k])) / slope);
            }
            if (std::isfinite(way)) sum += std::max(way, 0.0) * m_samples.area;
        }
        return sum;
    }

    const SurfaceSamples& m_samples;
    const TaskContext& m_task;
    std::vector<std::vector<std::uint32_t>> m_ofSeed;
};

constexpr std::size_t kDirections = 128;

/// Evenly spread over the sphere, on a Fibonacci spiral.
std::array<Vec3, kDirections> spreadDirections() {
    std::array<Vec3, kDirections> directions;
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (std::size_t k = 0; k < kDirections; ++k) {
        const double z = 1.0 - (2.0 * static_cast<double>(k) + 1.0) / kDirections;
        const double radius = std::sqrt(1.0 - z * z), angle = turn * static_cast<double>(k);
        directions[k] = {radius * cosine(angle), radius * sine(angle), z};
    }
    return directions;
}

/// The farthest of points in each of some directions, each point once, in their order.
std::vector<Vec3> supportPoints(std::span<const Vec3> points, std::span<const Vec3, kDirections> directions) {
    std::array<double, kDirections> farthest;
    farthest.fill(-std::numeric_limits<double>::infinity());
    std::array<std::uint32_t, kDirections> found{};
    for (std::uint32_t k = 0; k < points.size(); ++k) {
        for (std::size_t d = 0; d < kDirections; ++d) {
            const double along = glm::dot(points[k], directions[d]);
            if (along > farthest[d]) farthest[d] = along, found[d] = k;
        }
    }
    std::ranges::sort(found);
    const auto end = std::unique(found.begin(), found.end());
    std::vector<Vec3> kept;
    for (auto k = found.begin(); k != end; ++k) kept.push_back(points[*k]);
    return kept;
}

/// The points of a fragment's surface, each once, in the coordinates of the partition.
std::vector<Vec3> pointsOf(const SolidPartition& partition, std::uint32_t fragment) {
    std::vector<std::uint32_t> used;
    for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
        for (const std::array<std::uint32_t, 3>& triangle : partition.trianglesOf(side.face))
            used.insert(used.end(), triangle.begin(), triangle.end());
    }
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<Vec3> points;
    for (const std::uint32_t point : used) points.push_back(partition.points[point]);
    return points;
}

Result<Polytope> hullOfFragment(const SolidPartition& partition, std::uint32_t fragment,
                                std::span<const Vec3, kDirections> directions) {
    constexpr double kFlat = 1e-10;  // of a part's size, as hullsOf() has it
    const std::vector<Vec3> points = pointsOf(partition, fragment);
    Box3 box;
    for (const Vec3 point : points) box.include(point);
    Result<Polytope> hull = convexHull(supportPoints(points, directions), kFlat * box.diagonal());
    return hull ? hull : convexHull(points, kFlat * box.diagonal());
}

}  // namespace

std::vector<Vec3> sampledSeeds(const TriangleMesh& mesh, int cells, const TaskContext& task) {
    constexpr int kRelaxations = 4, kRefinements = 4;
    constexpr double kExcess = 0.05;  // of the volume
    const SurfaceSamples samples = sampled(mesh, task);
    if (samples.points.empty()) return {};
    SampledCells made(samples, task);
    made.spread(static_cast<std::size_t>(cells));
    made.relax(kRelaxations);
    const double allowed = kExcess * std::abs(signedVolume(mesh));
    for (int k = 0; k < kRefinements && made.refine(allowed, 4 * static_cast<std::size_t>(cells)); ++k) made.relax(2);
    return std::move(made.seeds);
}

Result<std::vector<Polytope>> sampledHulls(const TriangleMesh& mesh, int cells, const TaskContext& task) {
    const std::vector<Vec3> seeds = sampledSeeds(mesh, cells, task);
    if (task.isCancelled()) return TaskContext::cancelled();
    const Result<SolidPartition> partition = cutSolid(mesh, seeds, task);
    if (!partition) return partition.error();
    const std::array<Vec3, kDirections> directions = spreadDirections();
    std::vector<std::optional<Result<Polytope>>> each(partition->fragmentCount());
    forEachIndex(each.size(), task.threads, [&](std::size_t k) {
        if (!task.isCancelled()) each[k] = hullOfFragment(*partition, static_cast<std::uint32_t>(k), directions);
    });
    if (task.isCancelled()) return TaskContext::cancelled();
    std::vector<Polytope> hulls;
    for (std::optional<Result<Polytope>>& hull : each) {
        if (!*hull) return hull->error();
        hulls.push_back(translated(std::move(**hull), partition->origin));
    }
    return hulls;
}

}  // namespace rubble
