#include "core/io/pack/VerifyPackContacts.h"

#include "core/base/MessageText.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/io/pack/ConvexOverlap.h"
#include "core/io/pack/VerifyPackBody.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

using ErrorText = std::optional<std::string>;

constexpr double kDistanceTolerance = 1e-8;  // of the parent's size: between faces that meet
constexpr double kRounding = 1e-14;          // of coordinates
constexpr double kAreaTolerance = 1e-5;      // of an area, and of the parent's size times its depth
constexpr double kHiddenByGap = 4.0;         // gaps: by which the ends of a cut may be farther than that of the faces
constexpr double kHiddenByInset = 16.0;      // insets: that narrow faces which vanished, at acute corners, were wide

/// A box that contains a body, in the asset's frame.
struct Bounds {
    Vec3 min, max;
};

Bounds boundsOf(const std::vector<Polytope>& solids, Vec3 offset) {
    Bounds bounds{Vec3(1e308), Vec3(-1e308)};
    for (const Polytope& solid : solids) {
        for (const Vec3& vertex : solid.vertices) {
            bounds.min = glm::min(bounds.min, vertex + offset);
            bounds.max = glm::max(bounds.max, vertex + offset);
        }
    }
    return bounds;
}

bool touch(const Bounds& a, const Bounds& b, double reach) {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.min[axis] > b.max[axis] + reach || b.min[axis] > a.max[axis] + reach) return false;
    }
    return true;
}

/// Verifies the contacts of the fragments of one body.
class SiblingContacts {
public:
    SiblingContacts(const Pack& pack, const PackBody& parent, std::vector<std::uint32_t> children)
        : m_pack(pack),
          m_children(std::move(children)),
          m_parentId(parent.id),
          m_parent(boundsOf(solidsOf(parent), parent.offset)) {
        const bool isGapKnown = parent.gap > 0.0 || pack.gap == 0.0 || hasGaps(pack);
        m_gap = isGapKnown ? parent.gap : pack.gap;
        const Vec3 size = m_parent.max - m_parent.min;
        m_size = glm::length(size);
        m_depth = size.z;
        const double farthest = std::max(glm::length(m_parent.min), glm::length(m_parent.max));
        m_distanceTolerance = kDistanceTolerance * m_size + kRounding * farthest;
        m_areaTolerance = kAreaTolerance * m_size * m_depth;
        m_hidden = kHiddenByGap * m_gap + kHiddenByInset * pack.inset;
        m_reach = m_gap + m_distanceTolerance;
        for (const std::uint32_t child : m_children) {
            const Vec3 offset = pack.fragments[child].offset;
            m_solids.push_back(solidsOf(pack.fragments[child]));
            m_bounds.push_back(boundsOf(m_solids.back(), offset));
            std::vector<PlacedFace>& faces = m_faces.emplace_back();
            for (const Polytope& solid : m_solids.back())
                std::ranges::move(placedFaces(solid, offset), std::back_inserter(faces));
        }
    }

    ErrorText error() {
        for (std::size_t k = 0; k < m_children.size(); ++k) {
            if (!isWithinParent(m_bounds[k])) return ownerOf(k) + "it extends beyond its parent.";
        }
        for (std::size_t k = 0; k < m_children.size(); ++k) {
            for (const PackNeighbour& contact : fragment(k).neighbours) {
                const auto other = std::ranges::lower_bound(m_children, contact.fragment) - m_children.begin();
                const auto index = static_cast<std::size_t>(other);
                if (index < k) continue;
                if (ErrorText error = pairError(k, index, contact.area)) return error;
            }
        }
        if (ErrorText error = unlistedError()) return error;
        if (m_gap == 0.0 || m_isGapSeen || !m_isLongCutSeen) return std::nullopt;
        return "No fragments of " + quotedName(m_parentId) + " are as far apart as its gap, " + messageText(m_gap) +
               " m.";
    }

private:
    static bool hasGaps(const Pack& pack) {
        const auto hasGap = [](const PackBody& body) { return body.gap > 0.0; };
        return hasGap(pack.whole) || std::ranges::any_of(pack.fragments, hasGap);
    }
    const PackBody& fragment(std::size_t k) const { return m_pack.fragments[m_children[k]]; }
    std::string ownerOf(std::size_t k) const {
        return "Fragment " + std::to_string(m_children[k]) + " " + quotedName(fragment(k).id) + ": ";
    }

    bool isWithinParent(const Bounds& bounds) const {
        bool isWithin = true;
        for (int axis = 0; axis < 3; ++axis) {
            const double slack = m_distanceTolerance + kHiddenByInset * m_pack.inset;
            isWithin &=
                bounds.min[axis] >= m_parent.min[axis] - slack && bounds.max[axis] <= m_parent.max[axis] + slack;
        }
        return isWithin;
    }

    /// Calls visit(first, second) for the pairs of children that may touch, each once.
    template <class Visit>
    ErrorText forEachNearPair(Visit visit) const {
        std::vector<std::size_t> order(m_children.size()), open;
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
        std::ranges::sort(order, {}, [&](std::size_t k) { return m_bounds[k].min.x; });
        const double reach = m_reach;
        for (const std::size_t next : order) {
            std::erase_if(open, [&](std::size_t k) { return m_bounds[k].max.x + reach < m_bounds[next].min.x; });
            for (const std::size_t before : open) {
                if (!touch(m_bounds[before], m_bounds[next], reach)) continue;
                if (ErrorText error = visit(std::min(before, next), std::max(before, next))) return error;
            }
            open.push_back(next);
        }
        return std::nullopt;
    }

    /// Siblings that touch are neighbours.
    ErrorText unlistedError() {
        return forEachNearPair([&](std::size_t first, std::size_t second) -> ErrorText {
            const std::vector<PackNeighbour>& contacts = fragment(first).neighbours;
            const auto isListed =
                std::ranges::find(contacts, m_children[second], &PackNeighbour::fragment) != contacts.end();
            return isListed ? std::nullopt : pairError(first, second, 0.0);
        });
    }

    /// The contact of two children.
    struct Contact {
        double area = 0.0;    // m², of opposite faces as far apart as the gap
        double nearer = 0.0;  // m², of those nearer to each other
        std::size_t faces = 0;
    };
    Contact contactOf(std::size_t first, std::size_t second) const {
        Contact contact;
        if (!touch(m_bounds[first], m_bounds[second], m_reach)) return contact;
        for (const PlacedFace& one : m_faces[first]) {
            for (const PlacedFace& other : m_faces[second]) {
                const auto overlap = overlapOf(one, other, m_reach);
                if (!overlap) continue;
                const bool isNearer = overlap->distance < m_gap - m_distanceTolerance;
                (isNearer ? contact.nearer : contact.area) += overlap->area;
                contact.faces += overlap->area > 0.0;
            }
        }
        return contact;
    }

    /// Compares the contact of two children with the stated area; 0: they are not listed as neighbours.
    ErrorText pairError(std::size_t first, std::size_t second, double stated) {
        const Contact contact = contactOf(first, second);
        const double cuts =
            static_cast<double>(m_pack.inset > 0.0 ? std::max<std::size_t>(1, contact.faces) : contact.faces);
        const double hidden = m_areaTolerance + m_hidden * m_depth * cuts;
        const std::string other = ownerOf(first) + "its neighbour " + std::to_string(m_children[second]);
        if (m_gap > 0.0 && contact.nearer > hidden) return other + " is nearer than the gap.";
        m_isGapSeen |= contact.area > 0.0;
        m_isLongCutSeen |= stated > 2.0 * hidden;
        const double slack = kAreaTolerance * stated + hidden;
        if (contact.area > stated + slack) {
            if (stated == 0.0)
                return ownerOf(first) + "it touches fragment " + std::to_string(m_children[second]) +
                       ", which is not listed as a neighbour.";
            return areaError(other, stated, "at least ", contact.area);
        }
        if (stated == 0.0) return std::nullopt;
        if (m_gap == 0.0 && contact.area < stated - slack) return areaError(other, stated, "", contact.area);
        if (m_gap > 0.0) {
            const double most = mostBesideGap(first, second);
            if (stated > most) return areaError(other, stated, "at most ", most);
        }
        return std::nullopt;
    }
    static std::string areaError(const std::string& other, double stated, const std::string& bound, double expected) {
        return other + " has a contact area of " + messageText(stated) + " m² instead of " + bound +
               messageText(expected) + " m².";
    }

    /// An upper bound of the contact area of two fragments before the gap was taken from them. That of convex ones is a
    /// part of a straight cut, which lies in both if their sides are moved back.
    double mostBesideGap(std::size_t first, std::size_t second) const {
        const double margin = m_gap / 2.0 + m_distanceTolerance;
        const Box2 box{Vec2(m_parent.min) - Vec2(margin), Vec2(m_parent.max) + Vec2(margin)};
        const std::vector<Polytope>&own = m_solids[first], &others = m_solids[second];
        double length = own.size() + others.size() > 2 ? m_size : 0.0;
        for (const Polytope& one : own) {
            for (const Polytope& other : others)
                length += widenedOverlap(one, fragment(first).offset, other, fragment(second).offset, margin, box);
        }
        return (length + m_hidden) * m_depth + m_areaTolerance;
    }

    const Pack& m_pack;
    std::vector<std::uint32_t> m_children;  // ascending
    std::string m_parentId;
    Bounds m_parent;
    double m_gap = 0.0, m_size = 0.0, m_depth = 0.0;          // m
    double m_distanceTolerance = 0.0, m_areaTolerance = 0.0;  // m, m²
    double m_hidden = 0.0, m_reach = 0.0;                     // m: of the end of a cut; between faces that meet
    bool m_isGapSeen = false, m_isLongCutSeen = false;
    std::vector<std::vector<Polytope>> m_solids;  // this and the following: one per child
    std::vector<Bounds> m_bounds;
    std::vector<std::vector<PlacedFace>> m_faces;
};

}  // namespace

std::optional<std::string> verifyPackContacts(const Pack& pack) {
    // The hulls of meshes are around them: where they touch says little of their faces.
    const auto isOfPrism = [](const PackBody& body) {
        return std::ranges::all_of(body.hulls, [](const PackHull& hull) { return isPrism(hull.polytope); });
    };
    if (!isOfPrism(pack.whole) || !std::ranges::all_of(pack.fragments, isOfPrism)) return std::nullopt;
    std::map<std::uint32_t, std::vector<std::uint32_t>> children;
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) children[pack.fragments[k].parent].push_back(k);
    for (auto& [parent, list] : children) {
        const PackBody& body = parent == kNone ? pack.whole : pack.fragments[parent];
        if (ErrorText error = SiblingContacts(pack, body, std::move(list)).error()) return error;
    }
    return std::nullopt;
}

}  // namespace rubble
