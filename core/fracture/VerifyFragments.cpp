#include "core/fracture/Verify.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

using Fault = std::optional<std::string>;

constexpr double kRelative = 1e-9;  // of the prism's diameter, area or volume; of a mass's moment or inertia

std::string text(std::uint64_t number) { return std::to_string(number); }

bool isFinite(Vec3 point) { return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z); }

double perimeterOf(const Polygon& polygon) {
    double sum = perimeter(polygon.outer);
    for (const Ring& hole : polygon.holes) sum += perimeter(hole);
    return sum;
}

/// Calls visit(from, to) for every edge, in the order of `across`.
template <class Visit>
void forEachEdge(const Polygon& outline, Visit visit) {
    const auto visitRing = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    };
    visitRing(outline.outer);
    for (const Ring& hole : outline.holes) visitRing(hole);
}

Fault numberFault(const Fragment& fragment, double depth) {
    if (fragment.depth != depth) return "has another depth than the prism.";
    if (!(fragment.mass.volume > 0.0) || !std::isfinite(fragment.mass.volume)) return "has no volume.";
    if (!isFinite(fragment.offset)) return "has an offset that is not finite.";
    if (fragment.mass.centre != Vec3(0.0, 0.0, 0.0)) return "does not have its centre of mass as origin.";
    if (fragment.piece >= fragment.piecesOfSeed) return "is a piece too many of its seed.";
    return std::nullopt;
}

Fault acrossFault(const Fragment& fragment, std::size_t count) {
    std::size_t edges = 0;
    forEachEdge(fragment.outline, [&](Vec2, Vec2) { ++edges; });
    if (fragment.across.size() != edges) return "has edges without neighbours.";
    for (const std::uint32_t behind : fragment.across) {
        if (behind != kNone && behind >= count) return "names a neighbour that is not there.";
    }
    return std::nullopt;
}

/// Hull corners are corners of the outline on the front or the back; hulls fill the piece up to `slack` m^3.
Fault hullFault(const Fragment& fragment, double slack) {
    std::vector<std::array<double, 2>> corners;
    forEachEdge(fragment.outline, [&](Vec2 corner, Vec2) { corners.push_back({corner.x, corner.y}); });
    std::sort(corners.begin(), corners.end());
    double volume = 0.0;
    const std::vector<Polytope> hulls = hullsOf(fragment);
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        const std::string hull = "has a hull " + text(k);
        if (const Fault fault = verifyPolytope(hulls[k])) return hull + " that is no polytope: " + *fault;
        for (const Vec3& vertex : hulls[k].vertices) {
            if (std::abs(vertex.z) != fragment.depth / 2.0 ||
                !std::binary_search(corners.begin(), corners.end(), std::array{vertex.x, vertex.y})) {
                return hull + " with a corner that is not the piece's.";
            }
        }
        volume += massOf(hulls[k]).volume;
    }
    const double expected = area(fragment.outline) * fragment.depth;
    if (!(std::abs(volume - expected) <= slack + kRelative * expected)) {
        return "is filled by its hulls with " + std::to_string(volume) + " m^3 in place of " +
               std::to_string(expected) + " m^3.";
    }
    return std::nullopt;
}

const Bond* findBond(const Fragment& fragment, std::uint32_t to) {
    const auto found = std::ranges::lower_bound(fragment.bonds, to, {}, &Bond::fragment);
    return found != fragment.bonds.end() && found->fragment == to ? &*found : nullptr;
}

/// Bonds ascend, are mutual, and are those edges that have a fragment behind them.
Fault bondFault(const std::vector<Fragment>& fragments, std::uint32_t index, double slack) {
    const Fragment& fragment = fragments[index];
    for (std::size_t k = 0; k < fragment.bonds.size(); ++k) {
        const Bond& bond = fragment.bonds[k];
        if (bond.fragment >= fragments.size() || bond.fragment == index) return "has a bond to nobody.";
        if (k > 0 && fragment.bonds[k - 1].fragment >= bond.fragment) return "has bonds out of order.";
        const Bond* back = findBond(fragments[bond.fragment], index);
        if (!(bond.area > 0.0) || !back || back->area != bond.area) {
            return "has a bond to fragment " + text(bond.fragment) + " that is not mutual.";
        }
    }
    Fault fault;
    std::size_t edge = 0;
    forEachEdge(fragment.outline, [&](Vec2 from, Vec2 to) {
        const std::uint32_t behind = fragment.across[edge++];
        if (behind == kNone || behind == index || findBond(fragment, behind)) return;
        if (!(fragment.depth * glm::distance(from, to) <= slack)) {
            fault = "has no bond to fragment " + text(behind) + ", which it touches.";
        }
    });
    return fault;
}

Fault orderFault(const std::vector<Fragment>& fragments) {
    for (std::size_t i = 1; i < fragments.size(); ++i) {
        const auto key = [](const Fragment& fragment) { return std::pair(fragment.seed, fragment.piece); };
        if (!(key(fragments[i - 1]) < key(fragments[i]))) return "Fragment " + text(i) + " is out of order.";
    }
    return std::nullopt;
}

/// The fragments together weigh as much as the prism less its gap, about the same centre, with the same inertia.
Fault sumFault(const std::vector<Fragment>& fragments, const Prism& prism, double gapVolume) {
    const MassProperties whole = massOfPrism(prism.outline, prism.depth);
    std::vector<MassProperties> parts;
    for (const Fragment& fragment : fragments) {
        parts.push_back(fragment.mass);
        parts.back().centre = fragment.offset;
    }
    const MassProperties sum = combined(parts);
    if (!(std::abs(sum.volume + gapVolume - whole.volume) <= kRelative * whole.volume)) {
        return "The fragments' volumes sum to " + std::to_string(sum.volume) + " m^3, with a gap of " +
               std::to_string(gapVolume) + " m^3, in place of " + std::to_string(whole.volume) + " m^3.";
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

std::optional<std::string> verifyFragments(const Fragments& all, const Prism& prism, double gapArea) {
    const std::vector<Fragment>& fragments = all.fragments;
    const double diameter = boundsOf(prism.outline.outer).diagonal();
    for (std::uint32_t i = 0; i < fragments.size(); ++i) {
        const auto named = [&](const Fault& fault) { return "Fragment " + text(i) + " " + *fault; };
        const double hullSlack = kRelative * diameter * perimeterOf(fragments[i].outline) * prism.depth;
        if (const Fault fault = numberFault(fragments[i], prism.depth)) return named(fault);
        if (const Fault fault = acrossFault(fragments[i], fragments.size())) return named(fault);
        if (const Fault fault = hullFault(fragments[i], hullSlack)) return named(fault);
        if (const Fault fault = bondFault(fragments, i, 2.0 * kRelative * diameter * prism.depth)) return named(fault);
    }
    if (Fault fault = orderFault(fragments)) return fault;
    return sumFault(fragments, prism, gapArea * prism.depth);
}

}  // namespace rubble
