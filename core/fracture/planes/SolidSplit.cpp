#include "core/fracture/planes/SolidSplit.h"

#include "core/fracture/planes/PlaneCut.h"

#include <algorithm>
#include <string>
#include <utility>

namespace rubble {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The parts of a fragment that is cut by a plane.
struct FragmentPieces {
    std::vector<std::uint32_t> ofSide;  // the piece of each side of a face of the cut, 2 * face, + 1 if from behind
    std::uint32_t count = 0;
};

/// Whether two shells have a common point.
bool doTouch(const SolidFaces& faces, const SolidShell& a, const SolidShell& b) {
    const auto has = [&](const SolidShell& shell, std::uint32_t point) {
        return std::ranges::any_of(shell.sides, [&](std::uint32_t side) {
            return std::ranges::any_of(faces.trianglesOf(side / 2),
                                       [&](const Triangle& t) { return std::ranges::find(t, point) != t.end(); });
        });
    };
    return std::ranges::any_of(a.sides, [&](std::uint32_t side) {
        return std::ranges::any_of(faces.trianglesOf(side / 2)[0], [&](std::uint32_t point) { return has(b, point); });
    });
}

/// The piece that a shell is added to which is too thin to be one: across a face in the cut, else a neighbour on the
/// same side, else any there.
std::uint32_t pieceBeside(const SolidFaces& faces, const SolidShells& found, const SolidShell& shell,
                          std::span<const std::uint32_t> owners) {
    for (const std::uint32_t side : shell.sides) {
        const auto owner = std::ranges::find(owners, found.ownerOf(found.ofSide[side ^ 1]));
        if (owner != owners.end()) return static_cast<std::uint32_t>(owner - owners.begin());
    }
    std::uint32_t beside = 0;
    int best = 0;
    for (std::uint32_t piece = 0; piece < owners.size(); ++piece) {
        const SolidShell& owner = found.shells[owners[piece]];
        const int closeness = owner.cell != shell.cell ? 0 : doTouch(faces, shell, owner) ? 2 : 1;
        if (closeness > best) best = closeness, beside = piece;
    }
    return beside;
}

/// Finds the parts: shells, with their cavities and with what is too thin to be one.
Result<FragmentPieces> piecesOf(const PlaneCut& cut, std::span<const Vec3> points, double tolerance,
                                const TaskContext& task) {
    const Result<SolidShells> found = shellsOf(cut.faces, points, tolerance, task);
    if (!found) return found.error();
    const std::vector<SolidShell>& shells = found->shells;
    std::vector<std::uint32_t> owners;
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
        if (shells[s].owner == s && shells[s].volume > kMinShellVolume) owners.push_back(s);
    }
    std::ranges::stable_sort(owners, [&](std::uint32_t a, std::uint32_t b) {
        const Vec3 p = points[shells[a].smallest], q = points[shells[b].smallest];
        return p != q ? lexicographicLess(p, q) : shells[a].cell < shells[b].cell;
    });
    FragmentPieces pieces;
    pieces.count = static_cast<std::uint32_t>(owners.size());
    std::vector<std::uint32_t> pieceOfShell(shells.size());
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
        const auto owner = std::ranges::find(owners, found->ownerOf(s));
        pieceOfShell[s] = owner != owners.end() ? static_cast<std::uint32_t>(owner - owners.begin())
                                                : pieceBeside(cut.faces, *found, shells[s], owners);
    }
    for (const std::uint32_t shell : found->ofSide)
        pieces.ofSide.push_back(shell == kNone ? kNone : pieceOfShell[shell]);
    return pieces;
}

/// Writes the partition with the pieces in place of their fragment.
class SplitWriter {
public:
    SplitWriter(const SolidPartition& before, std::uint32_t fragment, const FragmentSurface& surface,
                const PlaneCut& cut, const FragmentPieces& pieces)
        : m_before(before), m_fragment(fragment), m_surface(surface), m_cut(cut), m_pieces(pieces) {
        for (std::uint32_t k = 0; k < cut.edges.size(); ++k) {
            m_edges.push_back({nameOf(cut.edges[k].low), nameOf(cut.edges[k].high), nameOf(cut.edges[k].point)});
        }
    }

    SolidSplit write() {
        SolidPartition& p = m_result.partition;
        p.origin = m_before.origin;
        p.points.reserve(m_before.points.size() + m_edges.size());
        p.points = m_before.points;
        p.points.insert(p.points.end(), m_surface.points.begin() + static_cast<std::ptrdiff_t>(m_surface.names.size()),
                        m_surface.points.end());
        p.duplicates = m_before.duplicates;
        numberFragments();
        addFaces();
        p.listFaces();
        for (const std::uint32_t piece : m_result.pieces) p.volumes[piece] = p.volumeOf(piece);
        std::ranges::sort(m_touched);
        const auto repeated = std::ranges::unique(m_touched);
        m_touched.erase(repeated.begin(), repeated.end());
        for (const std::uint32_t neighbour : m_touched) p.volumes[neighbour] = p.volumeOf(neighbour);
        return std::move(m_result);
    }

private:
    /// The partition's point that a point of the surface is.
    std::uint32_t nameOf(std::uint32_t point) const {
        const std::size_t known = m_surface.names.size();
        return point < known ? m_surface.names[point]
                             : static_cast<std::uint32_t>(m_before.points.size() + (point - known));
    }

    void numberFragments() {
        SolidPartition& p = m_result.partition;
        const std::uint32_t seed = m_before.seedOfFragment[m_fragment];
        std::uint32_t end = m_fragment, free = 0;  // of the fragments of the seed; the next part number
        for (std::uint32_t k = m_before.fragmentOfSeed[seed];
             k < m_before.fragmentCount() && m_before.seedOfFragment[k] == seed; ++k) {
            end = k + 1;
            if (m_before.partOfFragment[k] != kNone) free = std::max(free, m_before.partOfFragment[k] + 1);
        }
        p.seedOfFragment = m_before.seedOfFragment;
        p.partOfFragment = m_before.partOfFragment;
        p.fragmentOfSeed = m_before.fragmentOfSeed;
        p.volumes = m_before.volumes;
        if (p.partOfFragment[m_fragment] == kNone) p.partOfFragment[m_fragment] = free++;
        const std::uint32_t more = m_pieces.count - 1;
        const auto at = static_cast<std::ptrdiff_t>(end);
        p.seedOfFragment.insert(p.seedOfFragment.begin() + at, more, seed);
        p.partOfFragment.insert(p.partOfFragment.begin() + at, more, 0);
        p.volumes.insert(p.volumes.begin() + at, more, 0.0);
        m_result.pieces.push_back(m_fragment);
        for (std::uint32_t k = 0; k < more; ++k) {
            p.partOfFragment[end + k] = free++;
            m_result.pieces.push_back(end + k);
        }
        for (std::uint32_t& first : p.fragmentOfSeed) {
            if (first != kNone && first >= end) first += more;
        }
        for (std::uint32_t k = 0; k < m_before.fragmentCount(); ++k) {
            m_result.numbers.push_back(k < end ? k : k + more);
        }
    }

    SolidPartition::Face renumbered(SolidPartition::Face face) const {
        face.fragment = m_result.numbers[face.fragment];
        if (face.behind != kNone) face.behind = m_result.numbers[face.behind];
        return face;
    }

    void addFaces() {
        SolidPartition& p = m_result.partition;
        p.faces.reserve(m_before.faces.size() + m_surface.triangles.size());
        p.firstTriangle.reserve(p.faces.capacity() + 1);
        p.triangles.reserve(m_before.triangles.size() + 4 * m_surface.triangles.size());
        std::vector<bool> isEnd(m_before.points.size());
        for (const PlaneCrossing& edge : m_edges) isEnd[edge.low] = isEnd[edge.high] = true;
        sortTriangles();
        std::uint32_t place = 0;  // in the faces of the fragment
        std::vector<Triangle> divided;
        for (std::uint32_t f = 0; f < m_before.faces.size(); ++f) {
            const SolidPartition::Face& face = m_before.faces[f];
            if (face.fragment == m_fragment || face.behind == m_fragment) {
                addCutFace(face, place++);
                continue;
            }
            const std::span<const Triangle> triangles = m_before.trianglesOf(f);
            const auto isNear = [&](const Triangle& t) { return isEnd[t[0]] + isEnd[t[1]] + isEnd[t[2]] > 1; };
            if (std::ranges::none_of(triangles, isNear)) {
                p.addFace(renumbered(face), triangles);
                continue;
            }
            divided.clear();
            for (const Triangle& triangle : triangles) appendDivided(triangle, divided);
            p.addFace(renumbered(face), divided);
            if (divided.size() == triangles.size()) continue;
            m_touched.push_back(m_result.numbers[face.fragment]);
            if (face.behind != kNone) m_touched.push_back(m_result.numbers[face.behind]);
        }
        addInnerFaces();
    }

    /// Groups the triangles of the surface by the face that they are of and by their piece.
    void sortTriangles() {
        const SolidFaces& faces = m_cut.faces;
        for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
            if (faces.faces[f].behind != kNone) continue;
            Triangle triangle = faces.trianglesOf(f)[0];
            for (std::uint32_t& corner : triangle) corner = nameOf(corner);
            m_parts.push_back({faces.faces[f].source, m_pieces.ofSide[2 * f], triangle});
        }
        std::ranges::stable_sort(m_parts, [](const Part& a, const Part& b) {
            return a.place != b.place ? a.place < b.place : a.piece < b.piece;
        });
    }

    /// Adds a face of the fragment, as one face for each piece that has a part of it.
    void addCutFace(const SolidPartition::Face& before, std::uint32_t place) {
        const bool isReversed = before.behind == m_fragment;
        const auto parts = std::ranges::equal_range(m_parts, place, {}, &Part::place);
        std::vector<Triangle> triangles;
        for (auto begin = parts.begin(); begin != parts.end();) {
            const std::uint32_t piece = begin->piece;
            triangles.clear();
            for (; begin != parts.end() && begin->piece == piece; ++begin) {
                const auto& [a, b, c] = begin->triangle;
                triangles.push_back(isReversed ? Triangle{a, c, b} : Triangle{a, b, c});
            }
            SolidPartition::Face face = renumbered(before);
            (isReversed ? face.behind : face.fragment) = m_result.pieces[piece];
            m_result.partition.addFace(face, triangles);
        }
        const std::uint32_t other = isReversed ? before.fragment : before.behind;
        if (other != kNone) m_touched.push_back(m_result.numbers[other]);
    }

    /// Adds the faces between pieces.
    void addInnerFaces() {
        const SolidFaces& faces = m_cut.faces;
        std::vector<Triangle> triangles;
        for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
            if (faces.faces[f].behind == kNone) continue;
            const std::uint32_t below = m_pieces.ofSide[2 * f], above = m_pieces.ofSide[2 * f + 1];
            if (below == above) continue;
            triangles.clear();
            for (const auto& [a, b, c] : faces.trianglesOf(f)) triangles.push_back({nameOf(a), nameOf(b), nameOf(c)});
            m_result.partition.addFace({m_result.pieces[below], m_result.pieces[above], kNone}, triangles);
        }
    }

    /// The point where an edge is cut; kNone if it is not.
    std::uint32_t pointOn(std::uint32_t a, std::uint32_t b) const {
        const auto [low, high] = std::minmax(a, b);
        const auto isBefore = [](const PlaneCrossing& edge, const std::pair<std::uint32_t, std::uint32_t>& ends) {
            return std::pair(edge.low, edge.high) < ends;
        };
        const auto found = std::lower_bound(m_edges.begin(), m_edges.end(), std::pair(low, high), isBefore);
        return found != m_edges.end() && found->low == low && found->high == high ? found->point : kNone;
    }

    /// Appends a triangle, divided at the points on its edges.
    void appendDivided(Triangle triangle, std::vector<Triangle>& triangles) const {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
            const std::uint32_t point = pointOn(a, b);
            if (point == kNone) continue;
            appendDivided({a, point, c}, triangles);
            appendDivided({point, b, c}, triangles);
            return;
        }
        triangles.push_back(triangle);
    }

    struct Part {
        std::uint32_t place;  // of the face
        std::uint32_t piece;
        Triangle triangle;
    };
    const SolidPartition& m_before;
    std::uint32_t m_fragment;
    const FragmentSurface& m_surface;
    const PlaneCut& m_cut;
    const FragmentPieces& m_pieces;
    std::vector<PlaneCrossing> m_edges;    // with the partition's points
    std::vector<Part> m_parts;             // by place, then piece
    std::vector<std::uint32_t> m_touched;  // neighbours with points more
    SolidSplit m_result;
};

SolidSplit unchanged(SolidPartition partition, std::uint32_t fragment) {
    SolidSplit split{std::move(partition), {fragment}, {}};
    for (std::uint32_t k = 0; k < split.partition.fragmentCount(); ++k) split.numbers.push_back(k);
    return split;
}

}  // namespace

Result<SolidSplit> splitFragment(SolidPartition partition, std::uint32_t fragment, const SectionPlane& plane,
                                 const TaskContext& task) {
    if (fragment >= partition.fragmentCount()) {
        return Error{ErrorCode::BadInput, "There is no fragment " + std::to_string(fragment) + "."};
    }
    if (!plane.isFinite()) {
        return Error{ErrorCode::BadInput, "The plane of the cut is not finite."};
    }
    if (task.isCancelled()) return TaskContext::cancelled();
    const double tolerance = planeTolerance(partition);
    FragmentSurface surface = surfaceOf(partition, fragment);
    const SectionPlane local{plane.origin - partition.origin, plane.x, plane.y};
    const PlaneCut cut = cutByPlane(surface.triangles, surface.points, local, tolerance);
    const auto isOfOneSide = [&](const SolidPartition::Face& face) {
        return face.behind == kNone && face.fragment == cut.faces.faces[0].fragment;
    };
    if (std::ranges::all_of(cut.faces.faces, isOfOneSide)) return unchanged(std::move(partition), fragment);
    const Result<FragmentPieces> pieces = piecesOf(cut, surface.points, tolerance, task);
    if (!pieces) return pieces.error();
    if (pieces->count < 2) return unchanged(std::move(partition), fragment);
    return SplitWriter(partition, fragment, surface, cut, *pieces).write();
}

}  // namespace rubble
