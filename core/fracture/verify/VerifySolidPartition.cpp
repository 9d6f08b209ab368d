#include "core/fracture/verify/VerifySolidPartition.h"

#include "core/geometry/mesh/SolidMesh.h"
#include "core/geometry/predicates/SegmentDistance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble {
namespace {

using Fault = std::optional<std::string>;

class SolidPartitionCheck {
public:
    SolidPartitionCheck(const SolidPartition& partition, const TriangleMesh& mesh, std::span<const Vec3> seeds)
        : m_partition(partition), m_mesh(mesh), m_seeds(seeds), m_size(boundsOf(mesh).diagonal()) {}

    Fault check() const {
        for (const auto part :
             {&SolidPartitionCheck::indexFault, &SolidPartitionCheck::closedFault, &SolidPartitionCheck::outsideFault,
              &SolidPartitionCheck::volumeFault, &SolidPartitionCheck::seedFault}) {
            if (Fault fault = (this->*part)()) return fault;
        }
        return std::nullopt;
    }

private:
    static std::string text(std::size_t number) { return std::to_string(number); }
    std::array<Vec3, 3> corners(const std::array<std::uint32_t, 3>& triangle) const {
        return {m_partition.points[triangle[0]], m_partition.points[triangle[1]], m_partition.points[triangle[2]]};
    }

    Fault indexFault() const {
        const SolidPartition& p = m_partition;
        if (p.firstTriangle.size() != p.faces.size() + 1 || p.firstTriangle.back() != p.triangles.size()) {
            return "The triangles are not those of faces.";
        }
        for (std::size_t t = 0; t < p.triangles.size(); ++t) {
            const auto& [a, b, c] = p.triangles[t];
            if (std::max({a, b, c}) >= p.points.size()) return "Triangle " + text(t) + " has a point out of range.";
            if (a == b || b == c || c == a) return "Triangle " + text(t) + " has two equal corners.";
        }
        for (std::size_t f = 0; f < p.faces.size(); ++f) {
            const SolidPartition::Face& face = p.faces[f];
            if (face.fragment >= p.fragmentCount() || (face.behind != kNone && face.behind >= p.fragmentCount())) {
                return "Face " + text(f) + " has a fragment out of range.";
            }
            if (face.fragment == face.behind) return "Face " + text(f) + " has one fragment on both sides.";
            if ((face.behind == kNone) != (face.source < m_mesh.triangles.size())) {
                return "Face " + text(f) + " is neither inside nor of a triangle of the mesh.";
            }
        }
        if (p.partOfFragment.size() != p.fragmentCount()) return "The fragments have no part numbers.";
        for (std::uint32_t k = 1; k < p.fragmentCount(); ++k) {
            const std::uint32_t seed = p.seedOfFragment[k], before = p.seedOfFragment[k - 1];
            if (seed < before) return "Fragment " + text(k) + " is not ordered by seed.";
            if (seed == before && !(p.partOfFragment[k - 1] < p.partOfFragment[k] && p.partOfFragment[k] != kNone)) {
                return "Fragment " + text(k) + " is not ordered by part.";
            }
        }
        return std::nullopt;
    }

    Fault closedFault() const {
        std::vector<std::array<std::uint32_t, 3>> edges;  // lower point, higher point, 1 if from higher to lower
        for (std::uint32_t fragment = 0; fragment < m_partition.fragmentCount(); ++fragment) {
            edges.clear();
            for (const SolidPartition::FaceSide& side : m_partition.facesOf(fragment)) {
                for (const std::array<std::uint32_t, 3>& t : m_partition.trianglesOf(side.face)) {
                    for (int k = 0; k < 3; ++k) {
                        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                        edges.push_back({std::min(a, b), std::max(a, b), (a > b) != side.isReversed ? 1u : 0u});
                    }
                }
            }
            std::sort(edges.begin(), edges.end());
            for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
                int balance = 0;
                for (; end < edges.size() && edges[end][0] == edges[begin][0] && edges[end][1] == edges[begin][1];
                     ++end) {
                    balance += edges[end][2] == 0 ? 1 : -1;
                }
                if (balance == 0) continue;
                return "Fragment " + text(fragment) + " is open at the edge from point " + text(edges[begin][0]) +
                       " to point " + text(edges[begin][1]) + ".";
            }
        }
        return std::nullopt;
    }

    /// The ends of the longest side of a triangle of the mesh, relative to the partition's origin.
    std::array<Vec3, 2> longestSide(std::uint32_t triangle) const {
        std::array<Vec3, 2> longest{};
        for (int k = 0; k < 3; ++k) {
            const Vec3 from = m_mesh.points[m_mesh.triangles[triangle][k]] - m_partition.origin;
            const Vec3 to = m_mesh.points[m_mesh.triangles[triangle][(k + 1) % 3]] - m_partition.origin;
            if (glm::distance(from, to) > glm::distance(longest[0], longest[1])) longest = {from, to};
        }
        return longest;
    }

    Fault outsideFault() const {
        std::vector<double> covered(m_mesh.triangles.size(), 0.0);
        for (std::uint32_t f = 0; f < m_partition.faces.size(); ++f) {
            const SolidPartition::Face& face = m_partition.faces[f];
            if (face.behind != kNone) continue;
            const Vec3 normal = doubleArea(m_mesh, face.source);
            const double length = glm::length(normal);
            if (length == 0.0) continue;
            const auto [start, end] = longestSide(face.source);
            for (const std::array<std::uint32_t, 3>& t : m_partition.trianglesOf(f)) {
                const auto [a, b, c] = corners(t);
                covered[face.source] += glm::dot(glm::cross(b - a, c - a), normal) / length;
                // From a point nearby, since the normal of a narrow triangle has few digits.
                const Vec3 nearby = start + closestFraction(a, start, end) * (end - start);
                if (std::abs(glm::dot(a - nearby, normal)) > 1e-11 * m_size * length) {
                    return "Face " + text(f) + " is not in the plane of triangle " + text(face.source) + ".";
                }
            }
        }
        for (std::size_t t = 0; t < covered.size(); ++t) {
            const double whole = glm::length(doubleArea(m_mesh, t));
            if (std::abs(covered[t] - whole) > 1e-11 * m_size * m_size) {
                return "Triangle " + text(t) + " is covered by " + std::to_string(covered[t] / whole) + " of its area.";
            }
        }
        return std::nullopt;
    }

    double volumeOf(std::uint32_t fragment) const {
        double six = 0.0;
        const Vec3 origin = m_partition.points[m_partition.trianglesOf(m_partition.facesOf(fragment)[0].face)[0][0]];
        for (const SolidPartition::FaceSide& side : m_partition.facesOf(fragment)) {
            for (const std::array<std::uint32_t, 3>& t : m_partition.trianglesOf(side.face)) {
                const auto [a, b, c] = corners(t);
                const double part = glm::dot(a - origin, glm::cross(b - origin, c - origin));
                six += side.isReversed ? -part : part;
            }
        }
        return six / 6.0;
    }

    Fault volumeFault() const {
        const double whole = signedVolume(m_mesh);
        double sum = 0.0;
        for (std::uint32_t k = 0; k < m_partition.fragmentCount(); ++k) {
            const double volume = m_partition.volumes[k];
            if (!(volume > 0.0)) return "Fragment " + text(k) + " has the volume " + std::to_string(volume) + ".";
            if (std::abs(volume - volumeOf(k)) > 1e-13 * whole + 1e-9 * volume) {
                return "The volume of fragment " + text(k) + " is not that of its triangles.";
            }
            sum += volume;
        }
        if (std::abs(sum - whole) <= 1e-12 * std::max(whole, 1e-3 * m_size * m_size * m_size)) return std::nullopt;
        return "The volumes sum up to " + std::to_string(sum / whole) +
               " of the mesh's: " + std::to_string(sum - whole);
    }

    Fault seedFault() const {
        if (m_seeds.empty()) return std::nullopt;
        for (std::uint32_t f = 0; f < m_partition.faces.size(); ++f) {
            const SolidPartition::Face& face = m_partition.faces[f];
            for (const std::array<std::uint32_t, 3>& t : m_partition.trianglesOf(f)) {
                const auto [a, b, c] = corners(t);
                const Vec3 centre = m_partition.origin + (a + b + c) / 3.0;
                const Vec3 normal = glm::cross(b - a, c - a);
                for (const std::uint32_t fragment : {face.fragment, face.behind}) {
                    if (fragment == kNone) continue;
                    const bool isFront = fragment == face.fragment;
                    if (!isOfSeed(centre, isFront ? -normal : normal, m_partition.seedOfFragment[fragment])) {
                        return "Face " + text(f) + " of fragment " + text(fragment) + " is nearer to another seed.";
                    }
                }
            }
        }
        return std::nullopt;
    }

    /// Whether no seed is nearer to a point than `seed`, nor as near and nearer to what is inward of it.
    bool isOfSeed(Vec3 point, Vec3 inward, std::uint32_t seed) const {
        const double distance = glm::length(point - m_seeds[seed]), tolerance = 1e-11 * m_size;
        return std::ranges::none_of(m_seeds, [&](Vec3 other) {
            const double difference = glm::length(point - other) - distance;
            const Vec3 apart = other - m_seeds[seed];
            return difference < -tolerance ||
                   (difference < tolerance &&
                    glm::dot(inward, apart) > 0.99 * glm::length(inward) * glm::length(apart) + 1e-9 * m_size * m_size);
        });
    }

    const SolidPartition& m_partition;
    const TriangleMesh& m_mesh;
    std::span<const Vec3> m_seeds;
    double m_size;
};

}  // namespace

std::optional<std::string> verifySolidPartition(const SolidPartition& partition, const TriangleMesh& mesh,
                                                std::span<const Vec3> seeds) {
    return SolidPartitionCheck(partition, mesh, seeds).check();
}

}  // namespace rubble
