#include "core/fracture/verify/VerifySolidFragments.h"

#include "core/base/MessageText.h"
#include "core/fracture/solid/SolidHulls.h"
#include "core/fracture/verify/VerifySolidPartition.h"
#include "core/geometry/hull/SimplifiedHull.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rubble {
namespace {

constexpr double kSolidSlack = 1e-9;  // of the mesh's extent or volume

std::optional<std::string> solidFragmentFault(const Fragments& fragments, std::uint32_t index, double slack) {
    const Fragment fragment = fragments[index];
    if (!(fragment.volume() > 0.0)) return "has no volume.";
    const SolidFragments& all = *fragments.solid();
    const TriangleMesh mesh = all.meshOf(index);
    const MassProperties mass = massOf(mesh.points, mesh.triangles);
    if (!(glm::distance(mass.centre, all.masses[index].centre) <= slack) ||
        !(std::abs(mass.volume - fragment.volume()) <= kSolidSlack * mass.volume))
        return "does not have the mass of its faces.";
    const std::vector<Polytope> hulls = fragment.hulls();
    if (hulls.empty()) return "has no hull.";
    for (const Polytope& hull : hulls) {
        if (const std::optional<std::string> fault = verifyPolytope(hull)) return "has an invalid hull: " + *fault;
    }
    const double diagonal = boundsOf(mesh).diagonal();
    for (const Vec3& point : mesh.points) {
        const Vec3 own = point - mass.centre;
        const auto isIn = [&](const Polytope& hull) {
            const double outside = slack + maxCollisionError(hull.vertices.size(), diagonal) + all.hullsCutBack[index];
            return std::ranges::all_of(
                hull.planes, [&](const Plane& plane) { return glm::dot(plane.normal, own) <= plane.offset + outside; });
        };
        if (std::ranges::none_of(hulls, isIn)) return "has a point outside its hulls.";
    }
    const std::vector<FragmentContact> contacts = fragment.contacts();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (k > 0 && contacts[k - 1].fragment >= contacts[k].fragment) return "has contacts out of order.";
        const std::vector<FragmentContact> others = fragments[contacts[k].fragment].contacts();
        const auto back = std::ranges::find(others, index, &FragmentContact::fragment);
        if (back == others.end() || back->area != contacts[k].area)
            return "has a contact with fragment " + std::to_string(contacts[k].fragment) + " that is not mutual.";
    }
    return std::nullopt;
}

/// Checks that a mesh is closed, with each edge as often in one direction as in the other.
bool isClosed(const TriangleMesh& mesh) {
    std::map<std::array<std::uint32_t, 2>, int> edges;
    for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            edges[{low, high}] += triangle[k] == low ? 1 : -1;
        }
    }
    return std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
}

/// Checks what a gap leaves of a fragment of the partition: a closed mesh, no larger, and half a gap away from each
/// plane of a common face that the fragment is on one side of.
std::optional<std::string> shrunkFault(const SolidFragments& all, std::uint32_t index, double gap, double slack) {
    const std::uint32_t number = all.numberInPartition(index);
    const TriangleMesh before = meshOf(all.partition, number), left = all.meshOf(index);
    if (!isClosed(left)) return "is open where the gap was taken off.";
    if (all.masses[index].volume > all.partition.volumes[number] * (1.0 + kSolidSlack)) return "grew by the gap.";
    for (const SolidPartition::FaceSide& side : all.partition.facesOf(number)) {
        if (all.partition.faces[side.face].behind == kNone) continue;
        for (const auto& [a, b, c] : all.partition.trianglesOf(side.face)) {
            const std::vector<Vec3>& points = all.partition.points;
            const Vec3 area = glm::cross(points[b] - points[a], points[c] - points[a]);
            if (!(glm::length(area) > slack * slack)) continue;
            const Vec3 outwards = side.isReversed ? -glm::normalize(area) : glm::normalize(area);
            const auto heightOf = [&](Vec3 point) { return glm::dot(point - points[a], outwards); };
            if (std::ranges::any_of(before.points, [&](Vec3 point) { return heightOf(point) > slack; })) continue;
            if (std::ranges::any_of(left.points, [&](Vec3 point) { return heightOf(point) > slack - gap / 2.0; }))
                return "is nearer to a common face than half the gap.";
        }
    }
    return std::nullopt;
}

/// Checks the numbers of the fragments that a gap leaves.
std::optional<std::string> remainingFault(const SolidFragments& all, double gap) {
    if ((gap > 0.0) != (all.shrunk != nullptr)) return "The fragments are not shrunk as the gap requires.";
    const std::uint32_t count = all.partition.fragmentCount();
    if (all.remaining.empty() && all.count() == count) return std::nullopt;
    if (!all.shrunk || all.remaining.size() != all.count() || all.count() >= count)
        return "Fragments of the partition are missing.";
    for (std::uint32_t k = 0; k < all.count(); ++k) {
        const bool isAscending = k == 0 || all.remaining[k - 1] < all.remaining[k];
        if (!isAscending || all.remaining[k] >= count) return "The fragments are not those of the partition in order.";
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifySolidFragments(const Fragments& fragments, const TriangleMesh& mesh) {
    if (!fragments.solid()) return "The fragments are not those of a mesh.";
    if (std::optional<std::string> fault = verifySolidPartition(fragments.solid()->partition, mesh, {})) return fault;
    const SolidFragments& all = *fragments.solid();
    if (std::optional<std::string> fault = remainingFault(all, fragments.gap)) return fault;
    const double slack = kSolidSlack * boundsOf(mesh).diagonal();
    double volume = all.gapVolume;
    for (std::uint32_t k = 0; k < fragments.count(); ++k) {
        std::optional<std::string> fault = solidFragmentFault(fragments, k, slack);
        if (!fault && all.shrunk) fault = shrunkFault(all, k, fragments.gap, slack);
        if (fault) return "Fragment " + std::to_string(k) + " " + *fault;
        volume += fragments[k].volume();
    }
    const double expected = massOf(mesh.points, mesh.triangles).volume;
    if (std::abs(volume - expected) <= kSolidSlack * expected) return std::nullopt;
    return "The volumes sum to " + messageText(volume) + " m³ instead of " + messageText(expected) + " m³.";
}

}  // namespace rubble
