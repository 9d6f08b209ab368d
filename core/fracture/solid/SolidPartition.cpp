#include "core/fracture/solid/SolidPartition.h"

#include <glm/geometric.hpp>

#include <numeric>

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

}  // namespace rubble
