#include "core/fracture/solid/SolidPartition.h"

#include "core/fracture/partition/CappedDiagnostics.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <string>

namespace rubble {

double SolidPartition::volumeOf(std::uint32_t fragment) const {
    const std::span<const FaceSide> sides = facesOf(fragment);
    const Vec3 start = points[trianglesOf(sides[0].face)[0][0]];
    double six = 0.0;
    for (const FaceSide& side : sides) {
        for (const auto& [a, b, c] : trianglesOf(side.face)) {
            const double part = glm::dot(points[a] - start, glm::cross(points[b] - start, points[c] - start));
            six += side.isReversed ? -part : part;
        }
    }
    return six / 6.0;
}

void SolidPartition::addFace(const Face& face, std::span<const std::array<std::uint32_t, 3>> itsTriangles) {
    triangles.insert(triangles.end(), itsTriangles.begin(), itsTriangles.end());
    firstTriangle.push_back(static_cast<std::uint32_t>(triangles.size()));
    faces.push_back(face);
}

void SolidPartition::listFaces() {
    firstFace.assign(fragmentCount() + 1, 0);
    for (const Face& face : faces) {
        ++firstFace[face.fragment + 1];
        if (face.behind != kNone) ++firstFace[face.behind + 1];
    }
    std::partial_sum(firstFace.begin(), firstFace.end(), firstFace.begin());
    facesOfFragment.resize(firstFace.back());
    std::vector<std::uint32_t> next(firstFace.begin(), firstFace.end() - 1);
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        facesOfFragment[next[faces[f].fragment]++] = {f, false};
        if (faces[f].behind != kNone) facesOfFragment[next[faces[f].behind]++] = {f, true};
    }
}

std::vector<Diagnostic> seedReports(const SolidPartition& partition) {
    CappedDiagnostics found;
    for (std::uint32_t seed = 0; seed < partition.fragmentOfSeed.size(); ++seed) {
        if (partition.fragmentOfSeed[seed] != kNone) continue;
        const std::string name = "Seed " + std::to_string(seed);
        const auto equal =
            std::ranges::lower_bound(partition.duplicates, seed, {}, [](const auto& pair) { return pair[0]; });
        if (equal != partition.duplicates.end() && (*equal)[0] == seed) {
            const std::uint32_t other = (*equal)[1];
            found.add(DiagnosticCode::DuplicateSeed, [&] {
                return diagnostic(DiagnosticCode::DuplicateSeed, {.seed = seed, .otherSeed = other},
                                  name + " equals seed " + std::to_string(other) + " and was left out.");
            });
        } else {
            found.add(DiagnosticCode::SeedWithoutCell, [&] {
                return diagnostic(DiagnosticCode::SeedWithoutCell, {.seed = seed},
                                  name + " has no cell inside the mesh.");
            });
        }
    }
    return std::move(found).list();
}

}  // namespace rubble
