#include "tests/oracle/SolidFault.h"

#include "core/base/DisjointSets.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/verify/VerifySolidPartition.h"
#include "tests/oracle/ExactSolid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace rubble::oracle {
namespace {

constexpr double kTolerance = 1e-12;  // of the mesh's box

/// The triangles of a fragment, counter-clockwise from outside.
std::vector<std::array<std::uint32_t, 3>> trianglesOf(const SolidPartition& partition, std::uint32_t fragment) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
        for (auto triangle : partition.trianglesOf(side.face)) {
            if (side.isReversed) std::swap(triangle[1], triangle[2]);
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

/// How a surface is connected.
struct Topology {
    std::uint32_t shells = 0;
    int eulerNumber = 0;
    bool isKnown = true;  // no edge belongs to more than two triangles
};

Topology topologyOf(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>>
        cornersAt;  // directed edge: 3 * triangle + corner
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            cornersAt[{triangles[t][k], triangles[t][(k + 1) % 3]}].push_back(3 * t + k);
        }
    }
    DisjointSets shells(triangles.size()), fans(3 * triangles.size());
    for (const auto& [edge, corners] : cornersAt) {
        const auto other = cornersAt.find({edge[1], edge[0]});
        if (corners.size() != 1 || other == cornersAt.end() || other->second.size() != 1) return {0, 0, false};
        const std::uint32_t here = corners[0], there = other->second[0];
        const auto next = [](std::uint32_t corner) { return corner / 3 * 3 + (corner % 3 + 1) % 3; };
        shells.merge(here / 3, there / 3);
        fans.merge(here, next(there));
        fans.merge(next(here), there);
    }
    const auto setsIn = [](DisjointSets& sets) {
        const std::vector<std::uint32_t> roots = sets.roots();
        return static_cast<std::uint32_t>(std::set(roots.begin(), roots.end()).size());
    };
    return {setsIn(shells), static_cast<int>(setsIn(fans)) - static_cast<int>(triangles.size() / 2), true};
}

/// What the fragments of a seed are, for comparison with an ExactSolidCell.
struct SeedFragments {
    double volume = 0.0;
    std::uint32_t parts = 0;
    Topology topology;
    std::map<std::uint32_t, double> shared;
};

std::vector<SeedFragments> fragmentsBySeed(const SolidPartition& partition, std::size_t seedCount) {
    std::vector<SeedFragments> all(seedCount);
    for (std::uint32_t fragment = 0; fragment < partition.fragmentCount(); ++fragment) {
        SeedFragments& seed = all[partition.seedOfFragment[fragment]];
        const Topology topology = topologyOf(trianglesOf(partition, fragment));
        ++seed.parts;
        seed.volume += partition.volumes[fragment];
        seed.topology.shells += topology.shells;
        seed.topology.eulerNumber += topology.eulerNumber;
        seed.topology.isKnown = seed.topology.isKnown && topology.isKnown;
    }
    for (std::uint32_t face = 0; face < partition.faces.size(); ++face) {
        if (partition.faces[face].behind == kNone) continue;
        const std::uint32_t a = partition.seedOfFragment[partition.faces[face].fragment],
                            b = partition.seedOfFragment[partition.faces[face].behind];
        for (const auto& [p, q, r] : partition.trianglesOf(face)) {
            const Vec3 origin = partition.points[p];
            const double area =
                glm::length(glm::cross(partition.points[q] - origin, partition.points[r] - origin)) / 2.0;
            all[a].shared[b] += area;
            all[b].shared[a] += area;
        }
    }
    return all;
}

std::optional<std::string> seedFault(const SeedFragments& ours, const ExactSolidCell& exact, double extent) {
    const auto numbers = [](auto a, auto b) { return std::to_string(a) + " instead of " + std::to_string(b); };
    if (ours.parts != exact.parts) return "parts: " + numbers(ours.parts, exact.parts);
    if (std::abs(ours.volume - exact.volume) > kTolerance * extent * extent * extent)
        return "volume: " + numbers(ours.volume, exact.volume);
    if (ours.topology.isKnown && ours.topology.shells != exact.shells)
        return "shells: " + numbers(ours.topology.shells, exact.shells);
    if (ours.topology.isKnown && ours.topology.eulerNumber != exact.eulerNumber)
        return "Euler number: " + numbers(ours.topology.eulerNumber, exact.eulerNumber);
    if (ours.shared.size() != exact.shared.size())
        return "neighbours: " + numbers(ours.shared.size(), exact.shared.size());
    for (const auto& [other, area] : exact.shared) {
        const auto found = ours.shared.find(other);
        if (found == ours.shared.end()) return "no face with seed " + std::to_string(other);
        if (std::abs(found->second - area) > kTolerance * extent * extent)
            return "area of the face with seed " + std::to_string(other) + ": " + numbers(found->second, area);
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> solidFault(const TriangleMesh& mesh, std::span<const Vec3> seeds) {
    const Result<SolidPartition> partition = cutSolid(mesh, seeds);
    if (!partition) return partition.error().message;
    if (const auto fault = verifySolidPartition(*partition, mesh, seeds)) return fault;
    const std::vector<SeedFragments> ours = fragmentsBySeed(*partition, seeds.size());
    const std::vector<ExactSolidCell> exact = exactSolidCells(mesh, seeds);
    const Box3 box = boundsOf(mesh);
    for (std::size_t seed = 0; seed < seeds.size(); ++seed) {
        const auto fault = seedFault(ours[seed], exact[seed], glm::length(box.max - box.min));
        if (fault) return "seed " + std::to_string(seed) + ", " + *fault;
    }
    return std::nullopt;
}

TriangleMesh onCoarseLattice(TriangleMesh mesh) {
    for (Vec3& point : mesh.points) point = glm::round(point * 0x1p12) * 0x1p-12;
    return mesh;
}

}  // namespace rubble::oracle
