#include "core/fracture/fragments/Fragment.h"

#include "core/geometry/hull/AspectRatio.h"
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
std::uint32_t fragmentOf(const ExtrudedPieces& all, std::uint32_t piece) {
    return piece == kNone ? kNone : all.fragmentOfPiece[piece];
}

void addHull(std::span<const Vec2> ring, double depth, std::vector<Polytope>& hulls) {
    Polytope hull = extruded(ring, -depth / 2.0, depth / 2.0);
    if (!hull.vertices.empty()) hulls.push_back(std::move(hull));
}

}  // namespace

std::uint32_t Fragments::count() const {
    if (const SolidFragments* all = solid()) return all->count();
    return static_cast<std::uint32_t>(extruded()->pieceOfFragment.size());
}

std::optional<ExtrudedFragment> Fragment::extruded() const {
    const ExtrudedPieces* all = m_all->extruded();
    return all ? std::optional(ExtrudedFragment(*all, m_index)) : std::nullopt;
}

std::uint32_t Fragment::seed() const {
    if (const SolidFragments* all = m_all->solid())
        return all->partition.seedOfFragment[all->numberInPartition(m_index)];
    return m_all->extruded()->partition.seedOfPiece[extruded()->piece()];
}

std::uint32_t Fragment::partOfCell() const {
    if (const SolidFragments* all = m_all->solid())
        return all->partition.partOfFragment[all->numberInPartition(m_index)];
    return rubble::partOfCell(m_all->extruded()->partition, extruded()->piece());
}

Vec3 Fragment::offset() const {
    if (const SolidFragments* all = m_all->solid())
        return all->partition.origin + all->masses[m_index].centre + m_all->origin;
    return Vec3{m_all->extruded()->partition.origin + extruded()->record().moments.centre, 0.0} + m_all->origin;
}

double Fragment::volume() const {
    if (const SolidFragments* all = m_all->solid()) return all->masses[m_index].volume;
    const PieceRecord& record = extruded()->record();
    return record.receivesMass ? mass().volume : record.moments.area * m_all->extruded()->depth;
}

MassProperties Fragment::mass() const {
    const SolidFragments* all = m_all->solid();
    MassProperties mass = all ? all->masses[m_index] : extruded()->mass();
    mass.centre = Vec3{0.0, 0.0, 0.0};
    return mass;
}

double Fragment::aspectRatio() const {
    if (const SolidFragments* all = m_all->solid()) return rubble::aspectRatio(all->masses[m_index]);
    return rubble::aspectRatio(extruded()->outline());
}

bool Fragment::isConvex() const {
    if (const SolidFragments* all = m_all->solid()) return all->hulls[m_index].size() == 1;
    return extruded()->record().isConvex;
}

std::vector<FragmentContact> Fragment::contacts() const {
    const SolidFragments* all = m_all->solid();
    if (!all) return extruded()->contacts();
    std::vector<FragmentContact> contacts;
    for (std::uint32_t k = all->firstContact[m_index]; k < all->firstContact[m_index + 1]; ++k) {
        const SolidContact& contact = all->contacts[all->contactsOfFragment[k]];
        contacts.push_back({contact.first == m_index ? contact.second : contact.first, contact.area});
    }
    return contacts;
}

std::vector<Polytope> Fragment::hulls() const {
    if (const SolidFragments* all = m_all->solid()) return all->hulls[m_index];
    return extruded()->hulls();
}

MassProperties ExtrudedFragment::mass() const {
    if (record().receivesMass)
        return std::ranges::lower_bound(m_all->adjustedMasses, m_index, {}, &AdjustedMass::fragment)->mass;
    return massOfPrism(record().moments, m_all->depth);
}

Polygon ExtrudedFragment::outline() const { return pieceOutline(m_all->shapes(), piece(), record().moments.centre); }

Polygon ExtrudedFragment::cell() const { return pieceOutline(m_all->partition, piece(), record().moments.centre); }

std::vector<std::uint32_t> ExtrudedFragment::edgeNeighbours() const { return neighboursIn(m_all->shapes()); }

std::vector<std::uint32_t> ExtrudedFragment::cellNeighbours() const { return neighboursIn(m_all->partition); }

std::vector<std::uint32_t> ExtrudedFragment::neighboursIn(const Partition& partition) const {
    std::vector<std::uint32_t> fragments;
    forEachEdge(partition, piece(), [&](std::uint32_t, std::uint32_t, std::uint32_t piece) {
        fragments.push_back(fragmentOf(*m_all, piece));
    });
    return fragments;
}

std::vector<FragmentContact> ExtrudedFragment::contacts() const {
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

std::vector<Polytope> ExtrudedFragment::hulls() const {
    std::vector<Polytope> hulls;
    const Polygon piece = outline();
    if (record().isConvex) {
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
