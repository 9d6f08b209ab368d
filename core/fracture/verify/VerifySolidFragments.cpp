#include "core/fracture/verify/VerifySolidFragments.h"

#include "core/base/MessageText.h"
#include "core/fracture/solid/SolidHulls.h"
#include "core/fracture/verify/VerifySolidPartition.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kSolidSlack = 1e-9;  // of the mesh's extent or volume

std::optional<std::string> solidFragmentFault(const Fragments& fragments, std::uint32_t index, double slack) {
    const Fragment fragment = fragments[index];
    if (!(fragment.volume() > 0.0)) return "has no volume.";
    const SolidFragments& all = *fragments.solid();
    const TriangleMesh mesh = meshOf(all.partition, index);
    const MassProperties mass = massOf(mesh.points, mesh.triangles);
    if (!(glm::distance(mass.centre, all.masses[index].centre) <= slack) ||
        !(std::abs(mass.volume - fragment.volume()) <= kSolidSlack * mass.volume))
        return "does not have the mass of its faces.";
    const std::vector<Polytope> hulls = fragment.hulls();
    if (hulls.empty()) return "has no hull.";
    for (const Polytope& hull : hulls) {
        if (const std::optional<std::string> fault = verifyPolytope(hull)) return "has an invalid hull: " + *fault;
    }
    for (const Vec3& point : mesh.points) {
        const Vec3 own = point - mass.centre;
        const auto isIn = [&](const Polytope& hull) {
            return std::ranges::all_of(
                hull.planes, [&](const Plane& plane) { return glm::dot(plane.normal, own) <= plane.offset + slack; });
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

}  // namespace

std::optional<std::string> verifySolidFragments(const Fragments& fragments, const TriangleMesh& mesh) {
    if (!fragments.solid()) return "The fragments are not those of a mesh.";
    if (std::optional<std::string> fault = verifySolidPartition(fragments.solid()->partition, mesh, {})) return fault;
    const double slack = kSolidSlack * boundsOf(mesh).diagonal();
    double volume = 0.0;
    for (std::uint32_t k = 0; k < fragments.count(); ++k) {
        if (const std::optional<std::string> fault = solidFragmentFault(fragments, k, slack))
            return "Fragment " + std::to_string(k) + " " + *fault;
        volume += fragments[k].volume();
    }
    const double expected = massOf(mesh.points, mesh.triangles).volume;
    if (std::abs(volume - expected) <= kSolidSlack * expected) return std::nullopt;
    return "The volumes sum to " + messageText(volume) + " m³ instead of " + messageText(expected) + " m³.";
}

}  // namespace rubble
