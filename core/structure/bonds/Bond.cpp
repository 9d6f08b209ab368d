#include "core/structure/bonds/Bond.h"

#include "core/geometry/polygon/AreaMoments.h"
#include "core/structure/bonds/FragmentSilhouette.h"
#include "core/structure/bonds/SharedEdges.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rubble {
namespace {

/// An edge of the face of a bond, counter-clockwise around the first fragment.
struct BondEdge {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    double length = 0.0;  // m
    Vec2 from{0.0};       // m, as the points of the partition
    Vec2 to{0.0};
};

/// The edges between two fragments, by pair. Within a pair by length, so that their sum has the bits of
/// Fragment::contacts().
std::vector<BondEdge> bondEdges(const Fragments& fragments) {
    std::vector<BondEdge> edges;
    const Partition& partition = fragments.extruded()->partition;
    for (const SharedEdge& edge : sharedEdges(fragments)) {
        const Vec2 from = partition.points[edge.from], to = partition.points[edge.to];
        edges.push_back({edge.first, edge.second, glm::distance(from, to), from, to});
    }
    std::ranges::stable_sort(edges, [](const BondEdge& a, const BondEdge& b) {
        return std::tie(a.first, a.second, a.length) < std::tie(b.first, b.second, b.length);
    });
    return edges;
}

/// The integral of r rᵀ over a rectangle: an edge extruded along z, r from `centroid`.
Mat3 momentsOfRectangle(const BondEdge& edge, double depth, Vec2 centroid) {
    const double area = edge.length * depth;
    const Vec3 along{edge.to - edge.from, 0.0}, across{0.0, 0.0, depth};
    const Vec3 arm{edge.from + (edge.to - edge.from) / 2.0 - centroid, 0.0};
    return area * (glm::outerProduct(along, along) / 12.0 + glm::outerProduct(across, across) / 12.0 +
                   glm::outerProduct(arm, arm));
}

/// The bond of a pair without its distance; a mean normal that vanishes leads from one centre to the other.
Bond bondOfEdges(std::span<const BondEdge> edges, double depth, const BondedPoints& centres) {
    constexpr double kVanished = 1e-9;  // of the length of the edges: the rounding of thousands of edges
    Bond bond{.first = edges[0].first, .second = edges[0].second};
    const Vec2 origin = edges[0].from;  // keeps the digits of the centroid
    double length = 0.0;
    Vec2 centroid{0.0}, normal{0.0};
    for (const BondEdge& edge : edges) {
        length += edge.length;
        centroid += edge.length * ((edge.from - origin) + (edge.to - edge.from) / 2.0);
        normal -= perpendicular(edge.to - edge.from);
    }
    centroid = origin + centroid / length;
    for (const BondEdge& edge : edges) bond.moments += momentsOfRectangle(edge, depth, centroid);
    bond.area = length * depth;
    bond.centroid = Vec3{centroid, 0.0};
    const Vec3 apart = centres.second - centres.first;
    if (glm::length(normal) > kVanished * length) {
        bond.normal = Vec3{glm::normalize(normal), 0.0};
    } else {
        bond.normal = glm::length(apart) > 0.0 ? glm::normalize(apart) : Vec3{1.0, 0.0, 0.0};
    }
    return bond;
}

/// The seeds of two fragments, m, in the frame of the offsets; nothing if they share a seed or one has none.
std::optional<BondedPoints> seedsOfPair(const Fragments& fragments, const Seeds& seeds, const Bond& bond) {
    const std::uint32_t first = fragments[bond.first].seed(), second = fragments[bond.second].seed();
    if (first == second || first >= seeds.positions.size() || second >= seeds.positions.size()) return std::nullopt;
    return BondedPoints{seeds.at(first) + fragments.origin, seeds.at(second) + fragments.origin};
}

bool isFiniteAndPositive(double value) { return value > 0.0 && std::isfinite(value); }

std::optional<std::string> faultOfBond(const Bond& bond, std::uint32_t nodes) {
    constexpr double kRounding = 1e-12;
    const bool isAnchor = bond.second == kNone;
    if (bond.first >= nodes || (!isAnchor && bond.second >= nodes)) return "refers to a node that does not exist";
    if (!isAnchor && bond.second <= bond.first) return "does not lead to a larger node";
    if (!isFiniteAndPositive(bond.area)) return "has no area";
    if (!isFiniteAndPositive(bond.seedDistance)) return "has no distance";
    if (!(std::abs(glm::length(bond.normal) - 1.0) <= kRounding)) return "has a normal that is not of length 1";
    const double size = bond.moments[0][0] + bond.moments[1][1] + bond.moments[2][2];
    for (int column = 0; column < 3; ++column) {
        if (!(bond.moments[column][column] >= -kRounding * size)) return "has a negative moment";
        for (int row = 0; row < column; ++row) {
            const double asymmetry = bond.moments[column][row] - bond.moments[row][column];
            if (!(std::abs(asymmetry) <= kRounding * size)) return "has moments that are not symmetric";
        }
    }
    return std::nullopt;
}

/// The bonds of the fragments of a mesh: one for each contact.
std::vector<Bond> solidBonds(const Fragments& fragments, const Seeds& seeds) {
    const SolidFragments& all = *fragments.solid();
    const Vec3 origin = all.partition.origin + fragments.origin;
    std::vector<Bond> bonds;
    for (const SolidContact& contact : all.contacts) {
        const BondedPoints centres{fragments[contact.first].offset(), fragments[contact.second].offset()};
        const Vec3 apart = centres.second - centres.first;
        Bond bond{.first = contact.first,
                  .second = contact.second,
                  .area = contact.area,
                  .centroid = contact.centroid + origin,
                  .normal = contact.normal,
                  .moments = contact.moments};
        if (bond.normal == Vec3(0.0))
            bond.normal = glm::length(apart) > 0.0 ? glm::normalize(apart) : Vec3{1.0, 0.0, 0.0};
        bond.seedDistance = seedDistanceOf(bond, seedsOfPair(fragments, seeds, bond), centres);
        bonds.push_back(bond);
    }
    return bonds;
}

}  // namespace

std::vector<Bond> bondsOf(const BakedFracture& fracture) { return bondsOf(fracture.fragments, fracture.seeds); }

std::vector<Bond> bondsOf(const Fragments& fragments, const Seeds& seeds) {
    if (fragments.solid()) return solidBonds(fragments, seeds);
    const ExtrudedPieces& pieces = *fragments.extruded();
    const std::vector<BondEdge> edges = bondEdges(fragments);
    const Vec3 origin = Vec3{pieces.partition.origin, 0.0} + fragments.origin;
    std::vector<Bond> bonds;
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        double length = 0.0;
        for (; end < edges.size() && edges[end].first == edges[begin].first && edges[end].second == edges[begin].second;
             ++end)
            length += edges[end].length;
        if (length <= pieces.minSharedEdge) continue;
        const BondedPoints centres{fragments[edges[begin].first].offset(), fragments[edges[begin].second].offset()};
        Bond bond = bondOfEdges(std::span(edges).subspan(begin, end - begin), pieces.depth, centres);
        bond.centroid += origin;
        bond.seedDistance = seedDistanceOf(bond, seedsOfPair(fragments, seeds, bond), centres);
        bonds.push_back(bond);
    }
    return bonds;
}

std::optional<double> distanceAcross(const Bond& bond, const BondedPoints& points) {
    const double before = glm::dot(bond.normal, bond.centroid - points.first);
    const double behind = glm::dot(bond.normal, points.second - bond.centroid);
    if (!(before > 0.0) || !(behind > 0.0)) return std::nullopt;
    return before + behind;
}

double seedDistanceOf(const Bond& bond, const std::optional<BondedPoints>& seeds, const BondedPoints& centres) {
    if (seeds) {
        if (const std::optional<double> distance = distanceAcross(bond, *seeds)) return *distance;
    }
    if (const std::optional<double> distance = distanceAcross(bond, centres)) return *distance;
    const double around = glm::distance(centres.first, bond.centroid) + glm::distance(bond.centroid, centres.second);
    return around > 0.0 ? around : std::sqrt(bond.area);
}

double seedDistanceToFace(const Bond& bond, Vec3 point) {
    const double distance = glm::dot(bond.normal, bond.centroid - point);
    if (distance > 0.0) return distance;
    const double around = glm::distance(point, bond.centroid);
    return around > 0.0 ? around : std::sqrt(bond.area);
}

Bond paintedAnchor(const Fragments& fragments, std::uint32_t fragment) {
    const Fragment held = fragments[fragment];
    const AreaMoments moments = momentsOf(silhouetteOf(held));
    Bond bond{.first = fragment,
              .area = moments.area,
              .centroid = held.offset() + Vec3{moments.centre, 0.0},
              .normal = {0.0, 0.0, 1.0},
              .seedDistance = depthOf(held) / 2.0};
    bond.moments[0] = {moments.xx, moments.xy, 0.0};
    bond.moments[1] = {moments.xy, moments.yy, 0.0};
    return bond;
}

std::optional<std::string> verifyBonds(std::span<const Bond> bonds, std::uint32_t nodes) {
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        const std::string name = "Bond " + std::to_string(k);
        if (const std::optional<std::string> fault = faultOfBond(bonds[k], nodes)) return name + " " + *fault + ".";
        if (k == 0) continue;
        const Bond& last = bonds[k - 1];
        const auto pair = std::tie(bonds[k].first, bonds[k].second), lastPair = std::tie(last.first, last.second);
        if (pair < lastPair) return name + " is out of order.";
        if (pair == lastPair && last.second != kNone) return name + " joins the same fragments as the one before.";
    }
    return std::nullopt;
}

}  // namespace rubble
