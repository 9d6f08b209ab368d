#include "core/fracture/verify/VerifyFragments.h"

#include "core/base/MessageText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace rubble {
namespace {

using Fault = std::optional<std::string>;

constexpr double kRelative = 1e-9;  // of the prism's diameter, area or volume; of a mass's moment or inertia

bool isFinite(Vec3 point) { return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z); }

/// Calls visit(from, to) for every edge, in the order of ExtrudedFragment::edgeNeighbours().
template <class Visit>
void forEachEdge(const Polygon& outline, Visit visit) {
    const auto visitRing = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    };
    visitRing(outline.outer);
    for (const Ring& hole : outline.holes) visitRing(hole);
}

/// Verifies common properties, and that fragments and pieces refer to each other.
Fault tableFault(const Fragments& fragments, const Prism& prism) {
    if (!fragments.extruded()) return "The fragments are not those of a prism.";
    const ExtrudedPieces& all = *fragments.extruded();
    const std::uint32_t count = fragments.count();
    if (all.depth != prism.depth) return "The fragments have a different depth from the prism.";
    if (all.fragmentOfPiece.size() != all.partition.pieceCount()) return "There are pieces without a fragment.";
    for (const std::uint32_t fragment : all.fragmentOfPiece) {
        if (fragment != kNone && fragment >= count) return "A piece refers to a fragment that does not exist.";
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t piece = all.pieceOfFragment[i];
        if (piece >= all.partition.pieceCount() || all.fragmentOfPiece[piece] != i) {
            return "Fragment " + std::to_string(i) + " does not have a piece of its own.";
        }
    }
    return std::nullopt;
}

/// Verifies the volume, and the centre of mass as origin, unless mass was transferred to the fragment.
Fault massFault(const Fragments& all, std::uint32_t index, double slack) {
    const Fragment fragment = all[index];
    if (!(fragment.volume() > 0.0) || !std::isfinite(fragment.volume())) return "has no volume.";
    if (!isFinite(fragment.offset())) return "has an offset that is not finite.";
    const ExtrudedFragment extruded = *fragment.extruded();
    const Vec2 centre = centroid(extruded.outline());
    if (!extruded.record().receivesMass && !(glm::length(centre) <= slack)) {
        return "does not have its centre of mass as origin.";
    }
    return std::nullopt;
}

/// Hull vertices are corners of the outline on the front or the back; hulls fill the piece up to `slack` m³.
Fault hullFault(const Fragment& fragment, const Polygon& outline, double slack) {
    std::vector<std::array<double, 2>> corners;
    forEachEdge(outline, [&](Vec2 corner, Vec2) { corners.push_back({corner.x, corner.y}); });
    std::sort(corners.begin(), corners.end());
    const double depth = fragment.extruded()->depth();
    double volume = 0.0;
    const std::vector<Polytope> hulls = fragment.hulls();
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        const std::string hull = "has a hull " + std::to_string(k);
        if (const Fault fault = verifyPolytope(hulls[k])) return hull + " that is not a valid polytope: " + *fault;
        for (const Vec3& vertex : hulls[k].vertices) {
            if (std::abs(vertex.z) != depth / 2.0 ||
                !std::binary_search(corners.begin(), corners.end(), std::array{vertex.x, vertex.y})) {
                return hull + " with a vertex that is not a corner of the piece.";
            }
        }
        volume += massOf(hulls[k]).volume;
    }
    const double expected = area(outline) * depth;
    if (!(std::abs(volume - expected) <= slack + kRelative * expected)) {
        return "is filled by its hulls with " + messageText(volume) + " m³ instead of " + messageText(expected) +
               " m³.";
    }
    return std::nullopt;
}

using ContactLists = std::vector<std::vector<FragmentContact>>;  // one per fragment

const FragmentContact* findContact(const std::vector<FragmentContact>& contacts, std::uint32_t to) {
    const auto found = std::ranges::lower_bound(contacts, to, {}, &FragmentContact::fragment);
    return found != contacts.end() && found->fragment == to ? &*found : nullptr;
}

/// Bonds are ascending and mutual, and match the edges that have a fragment behind them; with a gap edges are not
/// compared.
Fault contactFault(const ContactLists& lists, std::uint32_t index, const Fragment& fragment, const Polygon& outline,
                   double slack, bool hasGap) {
    const std::vector<FragmentContact>& contacts = lists[index];
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (contacts[k].fragment >= lists.size() || contacts[k].fragment == index)
            return "has a contact with a fragment that does not exist.";
        if (k > 0 && contacts[k - 1].fragment >= contacts[k].fragment) return "has contacts out of order.";
        const FragmentContact* back = findContact(lists[contacts[k].fragment], index);
        if (!(contacts[k].area > 0.0) || !back || back->area != contacts[k].area) {
            return "has a contact with fragment " + std::to_string(contacts[k].fragment) + " that is not mutual.";
        }
    }
    if (hasGap) return std::nullopt;
    Fault fault;
    const std::vector<std::uint32_t> neighbours = fragment.extruded()->edgeNeighbours();
    std::size_t edge = 0;
    forEachEdge(outline, [&](Vec2 from, Vec2 to) {
        const std::uint32_t behind = neighbours[edge++];
        if (behind == kNone || behind == index || findContact(contacts, behind)) return;
        if (!(fragment.extruded()->depth() * glm::distance(from, to) <= slack)) {
            fault = "has no contact with fragment " + std::to_string(behind) + ", which it touches.";
        }
    });
    return fault;
}

Fault orderFault(const Fragments& fragments) {
    const ExtrudedPieces& pieces = *fragments.extruded();
    const auto key = [&](std::uint32_t i) {
        const std::span<const std::uint32_t> cells = pieces.partition.cutCellsOf(fragments[i].extruded()->piece());
        return std::tuple(fragments[i].seed(), std::vector(cells.begin(), cells.end()), fragments[i].partOfCell());
    };
    for (std::uint32_t i = 1; i < fragments.count(); ++i) {
        if (!(key(i - 1) < key(i))) return "Fragment " + std::to_string(i) + " is out of order.";
    }
    return std::nullopt;
}

/// The fragments together have the mass of the prism minus the gap, and without a gap its centre and inertia.
Fault sumFault(const Fragments& fragments, const Prism& prism, double gapVolume) {
    const MassProperties whole = massOfPrism(prism.outline, prism.depth);
    std::vector<MassProperties> parts;
    for (std::uint32_t i = 0; i < fragments.count(); ++i) {
        parts.push_back(fragments[i].mass());
        parts.back().centre = fragments[i].offset() - fragments.origin;
    }
    const MassProperties sum = combined(parts);
    if (!(std::abs(sum.volume + gapVolume - whole.volume) <= kRelative * whole.volume)) {
        return "The fragments' volumes sum to " + messageText(sum.volume) + " m³, with a gap of " +
               messageText(gapVolume) + " m³ instead of " + messageText(whole.volume) + " m³.";
    }
    const double reach = glm::length(Vec3(boundsOf(prism.outline.outer).size(), prism.depth));
    const double slack = kRelative + gapVolume / whole.volume;
    if (!(glm::distance(sum.centre, whole.centre) <= slack * (reach + glm::length(whole.centre)))) {
        return "The fragments' centre of mass is not the prism's.";
    }
    for (int column = 0; column < 3; ++column) {
        if (!(glm::length(sum.inertia[column] - whole.inertia[column]) <= slack * whole.volume * reach * reach)) {
            return "The fragments' inertia does not sum to the prism's.";
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyFragments(const Fragments& fragments, const Prism& prism) {
    if (Fault fault = tableFault(fragments, prism)) return fault;
    const double diameter = boundsOf(prism.outline.outer).diagonal();
    const ExtrudedPieces& pieces = *fragments.extruded();
    const bool hasGap = &pieces.shapes() != &pieces.partition;
    ContactLists contacts;
    for (std::uint32_t i = 0; i < fragments.count(); ++i) contacts.push_back(fragments[i].contacts());
    for (std::uint32_t i = 0; i < fragments.count(); ++i) {
        const auto named = [&](const Fault& fault) { return "Fragment " + std::to_string(i) + " " + *fault; };
        const Fragment fragment = fragments[i];
        const Polygon outline = fragment.extruded()->outline();
        const double hullSlack = kRelative * diameter * perimeter(outline) * prism.depth;
        const double bondSlack = 2.0 * kRelative * diameter * prism.depth;
        if (const Fault fault = massFault(fragments, i, kRelative * diameter)) return named(fault);
        if (const Fault fault = hullFault(fragment, outline, hullSlack)) return named(fault);
        if (const Fault fault = contactFault(contacts, i, fragment, outline, bondSlack, hasGap)) return named(fault);
    }
    if (Fault fault = orderFault(fragments)) return fault;
    return sumFault(fragments, prism, (pieces.partition.gap + pieces.gapArea) * prism.depth);
}

}  // namespace rubble
