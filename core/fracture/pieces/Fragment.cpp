#include "core/fracture/pieces/Fragment.h"

#include "core/geometry/polygon/IndexedCorners.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {
namespace {

/// Merges contacts, whose areas are the lengths of single edges: one per neighbour, ascending.
void mergeContacts(double minLength, double depth, std::vector<FragmentContact>& contacts) {
    std::sort(contacts.begin(), contacts.end(), [](const FragmentContact& a, const FragmentContact& b) {
        return a.fragment != b.fragment ? a.fragment < b.fragment : a.area < b.area;
    });
    std::size_t count = 0;
    for (std::size_t i = 0; i < contacts.size();) {
        FragmentContact merged{contacts[i].fragment, 0.0};
        for (; i < contacts.size() && contacts[i].fragment == merged.fragment; ++i) merged.area += contacts[i].area;
        if (merged.area <= minLength) continue;
        merged.area *= depth;
        contacts[count++] = merged;
    }
    contacts.resize(count);
}

/// The fragment that contains the mass of a piece; kNone: none.
std::uint32_t fragmentOf(const Fragments& all, std::uint32_t piece) {
    return piece == kNone ? kNone : all.fragmentOfPiece[piece];
}

void addHull(std::span<const Vec2> ring, double depth, std::vector<Polytope>& hulls) {
    Polytope hull = extruded(ring, -depth / 2.0, depth / 2.0);
    if (!hull.vertices.empty()) hulls.push_back(std::move(hull));
}

}  // namespace

std::uint32_t Fragment::piece() const { return m_all->pieceOfFragment[m_index]; }

const PieceRecord& Fragment::record() const { return m_all->records[piece()]; }

std::uint32_t Fragment::seed() const { return m_all->partition.seedOfPiece[piece()]; }

std::uint32_t Fragment::partOfCell() const { return rubble::partOfCell(m_all->partition, piece()); }

double Fragment::depth() const { return m_all->depth; }

Vec3 Fragment::offset() const { return Vec3{m_all->partition.origin + record().moments.centre, 0.0} + m_all->origin; }

double Fragment::volume() const { return record().receivesMass ? mass().volume : record().moments.area * m_all->depth; }

MassProperties Fragment::mass() const {
    if (record().receivesMass)
        return std::ranges::lower_bound(m_all->adjustedMasses, m_index, {}, &AdjustedMass::fragment)->mass;
    MassProperties mass = massOfPrism(record().moments, m_all->depth);
    mass.centre = Vec3{0.0, 0.0, 0.0};
    return mass;
}

bool Fragment::isConvex() const { return record().isConvex; }

Polygon Fragment::outline() const { return pieceOutline(m_all->shapes(), piece(), record().moments.centre); }

Polygon Fragment::cell() const { return pieceOutline(m_all->partition, piece(), record().moments.centre); }

std::vector<std::uint32_t> Fragment::edgeNeighbours() const { return neighboursIn(m_all->shapes()); }

std::vector<std::uint32_t> Fragment::cellNeighbours() const { return neighboursIn(m_all->partition); }

std::vector<std::uint32_t> Fragment::neighboursIn(const Partition& partition) const {
    std::vector<std::uint32_t> fragments;
    forEachEdge(partition, piece(), [&](std::uint32_t, std::uint32_t, std::uint32_t piece) {
        fragments.push_back(fragmentOf(*m_all, piece));
    });
    return fragments;
}

std::vector<FragmentContact> Fragment::contacts() const {
    std::vector<FragmentContact> contacts;
    const Partition& partition = m_all->partition;
    const auto addEdges = [&](std::uint32_t piece) {
        forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            const std::uint32_t behind = fragmentOf(*m_all, neighbour);
            if (behind == kNone || behind == m_index) return;
            contacts.push_back({behind, glm::distance(partition.points[from], partition.points[to])});
        });
    };
    addEdges(piece());
    for (const MassTransfer& transfer : m_all->massTransfers) {
        if (!record().receivesMass) break;
        if (fragmentOf(*m_all, transfer.receiver) == m_index) addEdges(transfer.thin);
    }
    mergeContacts(m_all->minSharedEdge, m_all->depth, contacts);
    return contacts;
}

std::vector<Polytope> Fragment::hulls() const {
    std::vector<Polytope> hulls;
    const Polygon piece = outline();
    if (isConvex()) {
        addHull(piece.outer, depth(), hulls);
        return hulls;
    }
    const std::vector<Vec2> corners = indexedCorners(piece).points;
    const std::optional<IndexLoops> parts = hullParts(piece, m_all->tolerance);
    for (const std::vector<std::uint32_t>& part : *parts) {
        Ring ring;
        for (const std::uint32_t corner : part) ring.push_back(corners[corner]);
        addHull(ring, depth(), hulls);
    }
    return hulls;
}

}  // namespace rubble
