#include "core/geometry/mesh/TriangleContact.h"

#include "core/geometry/mesh/LatticeSigns.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

using Signs = std::array<int, 3>;

/// A triangle's corners in an order of our choice, with the sides of another plane that they are on.
struct Corners {
    std::array<Vec3, 3> points;
    Signs sides;

    /// Rotates the corner that is alone on its side of the plane to the front.
    void startAtLoneCorner() {
        for (int k = 0; k < 3; ++k) {
            const int s = sides[k];
            if (s == 0 || s * sides[(k + 1) % 3] > 0 || s * sides[(k + 2) % 3] > 0) continue;
            std::rotate(points.begin(), points.begin() + k, points.end());
            std::rotate(sides.begin(), sides.begin() + k, sides.end());
            return;
        }
    }
    void turnOver() { std::swap(points[1], points[2]), std::swap(sides[1], sides[2]); }
    void mirrorSides() {
        for (int& side : sides) side = -side;
    }
};

/// Whether two triangles, neither in the other's plane and each with corners on both sides of it or with an edge in it,
/// meet in more than a point.
/// Source: Guigue, Devillers, Fast and robust triangle-triangle overlap test using orientation predicates, 2003.
bool meetInSegment(Corners a, Corners b) {
    a.startAtLoneCorner();
    b.startAtLoneCorner();
    if (a.sides[0] < 0) b.turnOver(), a.mirrorSides();
    if (b.sides[0] < 0) a.turnOver(), b.mirrorSides();
    return volumeSign(a.points[0], a.points[1], b.points[0], b.points[1]) < 0 &&
           volumeSign(a.points[0], a.points[2], b.points[0], b.points[2]) > 0;
}

/// Triangles in one plane.
class PlaneView {
public:
    PlaneView(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b)
        : m_surface(surface), m_a(a), m_b(b), m_axis(surface.views[a].axis), m_signA(surface.views[a].sign) {
        m_signB = areaSign(surface.corner(b, 0), surface.corner(b, 1), surface.corner(b, 2), m_axis);
    }
    bool faceSameWay() const { return m_signA == m_signB; }
    bool overlap() const { return !isSeparatedByEdge(m_a, m_signA, m_b) && !isSeparatedByEdge(m_b, m_signB, m_a); }

    /// Whether two triangles with one common corner, k of a and l of b, have nothing else in common.
    bool meetInCornerOnly(int k, int l) const {
        const auto& a = m_surface.triangles[m_a];
        const auto& b = m_surface.triangles[m_b];
        const auto isBetween = [&](const auto& of, int corner, int sign, std::uint32_t point) {
            return sign * area(of[corner], of[(corner + 1) % 3], point) >= 0 &&
                   sign * area(of[corner], point, of[(corner + 2) % 3]) >= 0;
        };
        for (int i = 1; i < 3; ++i) {
            if (isBetween(a, k, m_signA, b[(l + i) % 3]) || isBetween(b, l, m_signB, a[(k + i) % 3])) return false;
        }
        return true;
    }

private:
    int area(std::uint32_t p, std::uint32_t q, std::uint32_t r) const {
        if (p == r || q == r) return 0;
        return areaSign(m_surface.points[p], m_surface.points[q], m_surface.points[r], m_axis);
    }
    bool isSeparatedByEdge(std::uint32_t of, int sign, std::uint32_t from) const {
        const auto& corners = m_surface.triangles[of];
        for (int k = 0; k < 3; ++k) {
            if (std::ranges::all_of(m_surface.triangles[from], [&](std::uint32_t point) {
                    return sign * area(corners[k], corners[(k + 1) % 3], point) <= 0;
                })) {
                return true;
            }
        }
        return false;
    }

    const LatticeSurface& m_surface;
    std::uint32_t m_a, m_b;
    int m_axis, m_signA, m_signB = 0;
};

TriangleContact contactInPlane(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b) {
    const PlaneView view(surface, a, b);
    if (view.overlap()) return view.faceSameWay() ? TriangleContact::Cross : TriangleContact::Face;
    int common = 0, k = 0, l = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (surface.triangles[a][i] == surface.triangles[b][j]) ++common, k = i, l = j;
        }
    }
    if (common >= 2 || (common == 1 && view.meetInCornerOnly(k, l))) return TriangleContact::None;
    return TriangleContact::Line;
}

/// On which side of the plane of a triangle the corners of another one are.
Signs sidesOf(const LatticeSurface& surface, std::uint32_t plane, std::uint32_t triangle) {
    const auto& p = surface.triangles[plane];
    Signs sides{};
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t point = surface.triangles[triangle][k];
        if (point == p[0] || point == p[1] || point == p[2]) continue;
        sides[k] = volumeSign(surface.points[p[0]], surface.points[p[1]], surface.points[p[2]], surface.points[point]);
    }
    return sides;
}

int zerosIn(const Signs& sides) { return static_cast<int>(std::ranges::count(sides, 0)); }

/// Whether corners on these sides of a plane have at most one of them in common with it.
bool isBeside(const Signs& sides) {
    const auto [least, most] = std::ranges::minmax(sides);
    return zerosIn(sides) < 2 && (least >= 0 || most <= 0);
}

/// A piece of an edge, from p to q, with the triangles on its sides; degenerate ones are passed over.
struct EdgePiece {
    Vec3 p, q;
    std::array<std::uint32_t, 2> halfEdges;  // of triangles that are not degenerate
};

int longestAxis(Vec3 p, Vec3 q) {
    const Vec3 size = glm::abs(q - p);
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Of points on one line: whether x is strictly between p and q.
bool isBetween(Vec3 p, Vec3 q, Vec3 x) {
    const int axis = longestAxis(p, q);
    return (p[axis] < x[axis] && x[axis] < q[axis]) || (q[axis] < x[axis] && x[axis] < p[axis]);
}

/// Appends the pieces of an edge between p and q, seen from the triangle of `from`, that continue at half-edge `to`.
void appendPieces(const LatticeSurface& surface, std::uint32_t from, std::uint32_t to, Vec3 p, Vec3 q,
                  std::vector<EdgePiece>& pieces, int depth) {
    constexpr int kMaxDepth = 64;  // of degenerate triangles beside each other
    if (p == q || depth > kMaxDepth) return;
    if (!surface.isDegenerate(to / 3)) {
        pieces.push_back({p, q, {from, to}});
        return;
    }
    // The degenerate triangle lies on a line: the piece leaves it through the edges that cover it.
    const std::uint32_t first = to / 3 * 3 + (to % 3 + 1) % 3, second = to / 3 * 3 + (to % 3 + 2) % 3;
    const Vec3 u = surface.points[surface.origin(to)], v = surface.points[surface.target(to)];
    const Vec3 w = surface.points[surface.apex(to)];
    const auto pass = [&](std::uint32_t exit, Vec3 begin, Vec3 end) {
        appendPieces(surface, from, surface.across[exit], begin, end, pieces, depth + 1);
    };
    if (isBetween(p, q, w)) {  // `first` ends at w and begins at v
        const bool isSame =
            (p[longestAxis(p, q)] < q[longestAxis(p, q)]) == (u[longestAxis(u, v)] < v[longestAxis(u, v)]);
        pass(second, isSame ? p : w, isSame ? w : q);
        pass(first, isSame ? w : p, isSame ? q : w);
        return;
    }
    const int axis = longestAxis(u, v);
    const double low = std::min(p[axis], q[axis]), high = std::max(p[axis], q[axis]);
    const auto covers = [&](Vec3 a, Vec3 b) {
        return std::min(a[axis], b[axis]) <= low && std::max(a[axis], b[axis]) >= high;
    };
    if (covers(v, w))
        pass(first, p, q);
    else if (covers(w, u))
        pass(second, p, q);
}

std::vector<EdgePiece> edgePiecesOf(const LatticeSurface& surface, std::uint32_t triangle) {
    std::vector<EdgePiece> pieces;
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        appendPieces(surface, h, surface.across[h], surface.points[surface.origin(h)],
                     surface.points[surface.target(h)], pieces, 0);
    }
    return pieces;
}

/// A triangle beside a segment, seen along it.
struct Leaf {
    std::uint32_t triangle = 0;
    Vec3 apex{0.0, 0.0, 0.0};  // a corner on its side
    int jump = 0;              // from what is before it, counter-clockwise, to what is behind: +1 into the solid
};

/// The space around a segment from p to q with the triangles of two surfaces that pass there.
class AroundSegment {
public:
    AroundSegment(const LatticeSurface& surface, Vec3 p, Vec3 q) : m_surface(surface), m_p(p), m_q(q) {}

    void addEdge(const EdgePiece& piece) {
        for (const std::uint32_t h : piece.halfEdges) add(h / 3, m_surface.points[m_surface.apex(h)]);
    }
    /// A face through which the segment passes.
    void addFace(std::uint32_t triangle) {
        const auto [axis, sign] = m_surface.views[triangle];
        bool hasLeft = false, hasRight = false;
        for (int k = 0; k < 3; ++k) {
            const Vec3 corner = m_surface.corner(triangle, k);
            const int side = areaSign(m_p, m_q, corner, axis);
            if (side == 0 || std::exchange(side > 0 ? hasLeft : hasRight, true)) continue;
            add(triangle, corner);
        }
    }

    /// Whether the numbers of the regions between the leaves differ by more than 1.
    bool isCrossed(FaceLayers& layers) {
        const AngleAround angles(m_p, m_q, m_leaves[0].apex);
        std::ranges::stable_sort(m_leaves,
                                 [&](const Leaf& a, const Leaf& b) { return angles.compare(a.apex, b.apex) < 0; });
        struct Group {
            std::size_t begin, end;
            int before, after;
        };
        std::vector<Group> groups;
        int number = 0, least = 1 << 20, most = -least;
        for (std::size_t begin = 0, end = 0; begin < m_leaves.size(); begin = end) {
            const int before = number;
            for (; end < m_leaves.size() && angles.compare(m_leaves[begin].apex, m_leaves[end].apex) == 0; ++end) {
                number += m_leaves[end].jump;
            }
            groups.push_back({begin, end, before, number});
            least = std::min(least, number), most = std::max(most, number);
        }
        if (most - least > 1) return true;
        std::vector<TrianglePair> unknown;
        for (const Group& group : groups) {
            if (group.end - group.begin != 2 || group.before != group.after) continue;
            const std::uint32_t a = m_leaves[group.begin].triangle, b = m_leaves[group.begin + 1].triangle;
            const TrianglePair pair{std::min(a, b), std::max(a, b)};
            if (most == least)
                unknown.push_back(pair);
            else
                layers.known.push_back({pair, group.after == most ? FaceLayer::Gap : FaceLayer::Solid});
        }
        if (unknown.size() == 2) layers.same.push_back({unknown[0], unknown[1]});
        return false;
    }

private:
    void add(std::uint32_t triangle, Vec3 apex) {
        const auto [axis, sign] = m_surface.views[triangle];
        m_leaves.push_back({triangle, apex, -areaSign(m_p, m_q, apex, axis) * sign});
    }
    const LatticeSurface& m_surface;
    Vec3 m_p, m_q;
    std::vector<Leaf> m_leaves;
};

/// Whether a segment passes through a triangle's inside, in its plane.
bool passesInside(const LatticeSurface& surface, std::uint32_t triangle, Vec3 p, Vec3 q) {
    const Vec3 a = surface.corner(triangle, 0), b = surface.corner(triangle, 1), c = surface.corner(triangle, 2);
    if (volumeSign(a, b, c, p) != 0 || volumeSign(a, b, c, q) != 0) return false;
    const auto [axis, sign] = surface.views[triangle];
    bool hasLeft = false, hasRight = false;
    for (int k = 0; k < 3; ++k) {
        const Vec3 from = surface.corner(triangle, k), to = surface.corner(triangle, (k + 1) % 3);
        if (sign * areaSign(from, to, p, axis) <= 0 && sign * areaSign(from, to, q, axis) <= 0) return false;
        const int side = areaSign(p, q, from, axis);
        hasLeft |= side > 0, hasRight |= side < 0;
    }
    return hasLeft && hasRight;
}

/// Whether two segments have more than a point in common.
bool overlapOnLine(const EdgePiece& a, const EdgePiece& b) {
    if (!areCollinear(a.p, a.q, b.p) || !areCollinear(a.p, a.q, b.q)) return false;
    const int axis = longestAxis(a.p, a.q);
    return std::max(std::min(a.p[axis], a.q[axis]), std::min(b.p[axis], b.q[axis])) <
           std::min(std::max(a.p[axis], a.q[axis]), std::max(b.p[axis], b.q[axis]));
}

bool areOneEdge(const EdgePiece& a, const EdgePiece& b) {
    return a.halfEdges == b.halfEdges || (a.halfEdges[0] == b.halfEdges[1] && a.halfEdges[1] == b.halfEdges[0]);
}

/// Clips a convex polygon by the side of a plane to which `normal` points.
void clip(std::vector<Vec3>& polygon, Vec3 onPlane, Vec3 normal) {
    std::vector<Vec3> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        const double da = glm::dot(a - onPlane, normal), db = glm::dot(b - onPlane, normal);
        if (da >= 0.0) kept.push_back(a);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) kept.push_back(a + (b - a) * (da / (da - db)));
    }
    if (!kept.empty()) polygon = std::move(kept);  // rounding may leave nothing of a touch
}

}  // namespace

TriangleContact contactOf(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b) {
    if (surface.isDegenerate(a) || surface.isDegenerate(b)) return TriangleContact::None;
    const Signs sidesB = sidesOf(surface, a, b);
    if (isBeside(sidesB)) return TriangleContact::None;
    if (zerosIn(sidesB) == 3) return contactInPlane(surface, a, b);
    const Signs sidesA = sidesOf(surface, b, a);
    if (isBeside(sidesA)) return TriangleContact::None;
    if (zerosIn(sidesA) == 2 && zerosIn(sidesB) == 2) {  // an edge of each on the common line
        int common = 0;
        for (const std::uint32_t point : surface.triangles[a])
            common += static_cast<int>(std::ranges::count(surface.triangles[b], point));
        if (common == 2) return TriangleContact::None;
    }
    const Corners cornersA{{surface.corner(a, 0), surface.corner(a, 1), surface.corner(a, 2)}, sidesA};
    const Corners cornersB{{surface.corner(b, 0), surface.corner(b, 1), surface.corner(b, 2)}, sidesB};
    if (!meetInSegment(cornersA, cornersB)) return TriangleContact::None;
    return zerosIn(sidesA) == 2 || zerosIn(sidesB) == 2 ? TriangleContact::Line : TriangleContact::Cross;
}

EdgePassage passageAtEdges(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b, FaceLayers& layers) {
    const std::vector<EdgePiece> piecesA = edgePiecesOf(surface, a), piecesB = edgePiecesOf(surface, b);
    EdgePassage passage = EdgePassage::None;
    const auto check = [&](AroundSegment& around) {
        passage = std::max(passage, around.isCrossed(layers) ? EdgePassage::Cross : EdgePassage::Touch);
    };
    const auto checkFace = [&](const EdgePiece& piece, std::uint32_t face) {
        if (!passesInside(surface, face, piece.p, piece.q)) return;
        AroundSegment around(surface, piece.p, piece.q);
        around.addEdge(piece);
        around.addFace(face);
        check(around);
    };
    for (const EdgePiece& piece : piecesA) checkFace(piece, b);
    for (const EdgePiece& piece : piecesB) checkFace(piece, a);
    for (const EdgePiece& pieceA : piecesA) {
        for (const EdgePiece& pieceB : piecesB) {
            if (areOneEdge(pieceA, pieceB) || !overlapOnLine(pieceA, pieceB)) continue;
            AroundSegment around(surface, pieceA.p, pieceA.q);
            around.addEdge(pieceA);
            around.addEdge(pieceB);
            check(around);
        }
    }
    return passage;
}

Vec3 commonPoint(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b) {
    const Vec3 p = surface.corner(b, 0), q = surface.corner(b, 1), r = surface.corner(b, 2);
    const Vec3 normal = glm::cross(q - p, r - p);
    std::vector<Vec3> polygon = {surface.corner(a, 0), surface.corner(a, 1), surface.corner(a, 2)};
    clip(polygon, p, normal);
    clip(polygon, p, -normal);
    clip(polygon, p, glm::cross(normal, q - p));
    clip(polygon, q, glm::cross(normal, r - q));
    clip(polygon, r, glm::cross(normal, p - r));
    Vec3 sum(0.0);
    for (const Vec3 point : polygon) sum += point;
    return sum / static_cast<double>(polygon.size());
}

}  // namespace rubble
