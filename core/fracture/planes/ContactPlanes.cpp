#include "core/fracture/planes/ContactPlanes.h"

#include "core/geometry/search/Box3.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace rubble {
namespace {

constexpr double kMinContactWidth = 16.0;  // tolerances

/// An inner face of a fragment.
struct ContactFace {
    std::uint32_t side = 0;  // place in facesOf(fragment)
    Vec3 doubleArea{0.0};    // out of the fragment
    double size = 0.0;       // m²: the length of doubleArea
    double width = 0.0;      // m
};

class ContactFinder {
public:
    ContactFinder(const SolidPartition& partition, std::uint32_t fragment, double tolerance)
        : m_partition(partition), m_fragment(fragment), m_sides(partition.facesOf(fragment)), m_tolerance(tolerance) {}

    std::vector<ContactPlane> find(double extent) {
        std::vector<ContactFace> faces;
        for (std::uint32_t side = 0; side < m_sides.size(); ++side) {
            if (neighbourOf(side) == kNone) continue;
            const ContactFace face = measured(side);
            if (face.width > kMinContactWidth * m_tolerance) faces.push_back(face);
        }
        std::ranges::stable_sort(faces, [](const ContactFace& a, const ContactFace& b) { return a.size > b.size; });
        for (const ContactFace& face : faces) add(face, extent);
        return std::move(m_planes);
    }

private:
    std::uint32_t neighbourOf(std::uint32_t side) const {
        const SolidPartition::Face& face = m_partition.faces[m_sides[side].face];
        return m_sides[side].isReversed ? face.fragment : face.behind;
    }

    ContactFace measured(std::uint32_t side) const {
        ContactFace face{.side = side};
        Box3 box;
        for (const auto& [a, b, c] : m_partition.trianglesOf(m_sides[side].face)) {
            const Vec3 p = m_partition.points[a], q = m_partition.points[b], r = m_partition.points[c];
            for (const Vec3 point : {p, q, r}) box.include(point);
            face.doubleArea += glm::cross(q - p, r - p);
        }
        if (m_sides[side].isReversed) face.doubleArea = -face.doubleArea;
        face.size = glm::length(face.doubleArea);
        face.width = face.size / box.diagonal();
        return face;
    }

    void add(const ContactFace& face, double extent) {
        const std::uint32_t neighbour = neighbourOf(face.side);
        const std::span<const std::array<std::uint32_t, 3>> triangles =
            m_partition.trianglesOf(m_sides[face.side].face);
        for (ContactPlane& plane : m_planes) {
            if (plane.neighbour != neighbour || glm::dot(plane.normal, face.doubleArea) <= 0.0) continue;
            const auto isIn = [&](std::uint32_t point) {
                return std::abs(plane.heightOf(m_partition.points[point])) <= plane.slack;
            };
            if (std::ranges::all_of(triangles, [&](const auto& t) { return isIn(t[0]) && isIn(t[1]) && isIn(t[2]); })) {
                plane.sides.push_back(face.side);
                return;
            }
        }
        const Vec3 normal = face.doubleArea / face.size;
        double sum = 0.0;
        for (const auto& t : triangles) {
            for (const std::uint32_t point : t) sum += glm::dot(m_partition.points[point], normal);
        }
        const double height = sum / (3.0 * static_cast<double>(triangles.size()));
        m_planes.push_back({neighbour, normal, height, m_tolerance * (1.0 + extent / face.width), {face.side}});
    }

    const SolidPartition& m_partition;
    std::uint32_t m_fragment;
    std::span<const SolidPartition::FaceSide> m_sides;
    double m_tolerance;
    std::vector<ContactPlane> m_planes;
};

}  // namespace

std::vector<ContactPlane> contactPlanes(const SolidPartition& partition, std::uint32_t fragment, double tolerance,
                                        double extent) {
    return ContactFinder(partition, fragment, tolerance).find(extent);
}

}  // namespace rubble
