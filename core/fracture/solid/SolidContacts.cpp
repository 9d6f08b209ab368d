#include "core/fracture/solid/SolidContacts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace rubble {
namespace {

/// The integral of x xᵀ over a triangle of an area.
Mat3 secondMoments(Vec3 a, Vec3 b, Vec3 c, double area) {
    const Vec3 sum = a + b + c;
    return area / 12.0 *
           (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) + glm::outerProduct(sum, sum));
}

SolidContact contactOf(const SolidPartition& partition, const std::vector<std::uint32_t>& faces) {
    const SolidPartition::Face& any = partition.faces[faces[0]];
    SolidContact contact{.first = std::min(any.fragment, any.behind), .second = std::max(any.fragment, any.behind)};
    const Vec3 origin = partition.points[partition.trianglesOf(faces[0])[0][0]];
    Vec3 first(0.0), normal(0.0);
    for (const std::uint32_t face : faces) {
        const double direction = partition.faces[face].fragment == contact.first ? 1.0 : -1.0;
        for (const auto& corner : partition.trianglesOf(face)) {
            const Vec3 a = partition.points[corner[0]] - origin, b = partition.points[corner[1]] - origin,
                       c = partition.points[corner[2]] - origin;
            const Vec3 twice = glm::cross(b - a, c - a);
            const double area = glm::length(twice) / 2.0;
            contact.area += area;
            first += area / 3.0 * (a + b + c);
            normal += direction * twice;
            contact.moments += secondMoments(a, b, c, area);
        }
    }
    if (contact.area > 0.0) {
        const Vec3 centre = first / contact.area;
        contact.moments -= contact.area * glm::outerProduct(centre, centre);
        contact.centroid = origin + centre;
    }
    const double length = glm::length(normal);
    if (length > 1e-9 * contact.area) contact.normal = normal / length;
    return contact;
}

}  // namespace

std::vector<SolidContact> contactsOf(const SolidPartition& partition) {
    std::vector<std::array<std::uint32_t, 3>> inner;  // first, second, face
    for (std::uint32_t f = 0; f < partition.faces.size(); ++f) {
        const SolidPartition::Face& face = partition.faces[f];
        if (face.behind == kNone) continue;
        inner.push_back({std::min(face.fragment, face.behind), std::max(face.fragment, face.behind), f});
    }
    std::ranges::sort(inner);
    std::vector<SolidContact> contacts;
    std::vector<std::uint32_t> faces;
    for (std::size_t begin = 0, end = 0; begin < inner.size(); begin = end) {
        faces.clear();
        for (; end < inner.size() && inner[end][0] == inner[begin][0] && inner[end][1] == inner[begin][1]; ++end) {
            faces.push_back(inner[end][2]);
        }
        contacts.push_back(contactOf(partition, faces));
    }
    return contacts;
}

}  // namespace rubble
