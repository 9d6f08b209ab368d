#include "core/fracture/planes/SolidGap.h"

#include "core/base/Parallel.h"
#include "core/base/QuantityText.h"
#include "core/fracture/partition/CappedDiagnostics.h"
#include "core/fracture/planes/ContactPlanes.h"
#include "core/fracture/planes/PlaneCut.h"
#include "core/fracture/planes/SolidSplit.h"
#include "core/fracture/solid/SolidMerge.h"
#include "core/geometry/mesh/SolidMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

/// A convex polygon in space, counter-clockwise seen from where its normal points.
using Corners = std::vector<Vec3>;

/// What is nearer to a convex polygon than a margin, with its corners bevelled: below each of the planes.
std::vector<SectionPlane> regionAround(const Corners& polygon, const ContactPlane& contact, double margin) {
    const Vec3 normal = contact.normal;
    // The same two planes for all polygons of a contact.
    std::vector<SectionPlane> planes = {planeThrough((contact.height - margin) * normal, -normal),
                                        planeThrough((contact.height + margin) * normal, normal)};
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 corner = polygon[k], next = polygon[(k + 1) % polygon.size()] - corner,
                   before = polygon[(k + polygon.size() - 1) % polygon.size()] - corner;
        const double nextLength = glm::length(next), beforeLength = glm::length(before);
        if (nextLength == 0.0 || beforeLength == 0.0) continue;
        const Vec3 outward = glm::cross(next, normal);
        if (glm::length(outward) > 0.0) planes.push_back(planeThrough(corner, outward).movedUp(margin));
        const Vec3 bisector = next / nextLength + before / beforeLength;
        if (glm::length(bisector) > 0.5) planes.push_back(planeThrough(corner, -bisector).movedUp(margin));
    }
    return planes;
}

/// The loop around triangles; empty if it is not a single one.
PointLoop loopAround(std::span<const std::array<std::uint32_t, 3>> triangles) {
    if (triangles.size() == 1) return {triangles[0].begin(), triangles[0].end()};
    std::map<std::uint32_t, std::uint32_t> next;  // along the edges of one triangle only
    const auto isInner = [&](std::uint32_t from, std::uint32_t to) {
        return std::ranges::any_of(triangles, [&](const auto& t) {
            return (t[0] == to && t[1] == from) || (t[1] == to && t[2] == from) || (t[2] == to && t[0] == from);
        });
    };
    for (const std::array<std::uint32_t, 3>& t : triangles) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = t[k], to = t[(k + 1) % 3];
            if (!isInner(from, to) && !next.emplace(from, to).second) return {};
        }
    }
    if (next.empty()) return {};
    PointLoop loop;
    std::uint32_t point = next.begin()->first;
    do {
        loop.push_back(point);
        const auto after = next.find(point);
        if (after == next.end()) return {};
        point = after->second;
    } while (point != loop.front() && loop.size() <= next.size());
    return loop.size() == next.size() ? loop : PointLoop();
}

/// Whether each edge is there as often in one direction as in the other.
bool isClosed(const std::vector<SolidTriangle>& triangles) {
    std::vector<std::array<std::uint32_t, 3>> edges;  // lower point, higher point, 1 if from lower to higher
    for (const SolidTriangle& triangle : triangles) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle.corners[k], b = triangle.corners[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1u : 0u});
        }
    }
    std::ranges::sort(edges);
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        std::uint32_t forward = 0;
        for (; end < edges.size() && edges[end][0] == edges[begin][0] && edges[end][1] == edges[begin][1]; ++end) {
            forward += edges[end][2];
        }
        if (2 * forward != end - begin) return false;
    }
    return true;
}

bool isConvex(const Corners& loop, Vec3 normal) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 a = loop[k], b = loop[(k + 1) % loop.size()], c = loop[(k + 2) % loop.size()];
        const double turn = glm::dot(glm::cross(b - a, c - b), normal);
        if (turn < -1e-9 * glm::length(b - a) * glm::length(c - b)) return false;
    }
    return !loop.empty();
}

/// Shrinks one fragment.
class FragmentShrinker {
public:
    FragmentShrinker(const SolidPartition& partition, std::uint32_t fragment, double margin, double tolerance,
                     const CancelToken& cancel)
        : m_partition(partition),
          m_sides(partition.facesOf(fragment)),
          m_margin(margin),
          m_tolerance(tolerance),
          m_fragment(fragment) {
        m_task.cancel = cancel;
        FragmentSurface surface = surfaceOf(partition, fragment);
        m_points = std::move(surface.points);
        m_triangles = std::move(surface.triangles);
    }

    Result<ShrunkFragment> shrink() {
        Box3 box;
        for (const Vec3 point : m_points) box.include(point);
        m_planes = contactPlanes(m_partition, m_fragment, m_tolerance, box.diagonal());
        std::vector<bool> isSupporting;  // as the fragment is before it is cut
        for (const ContactPlane& plane : m_planes) {
            isSupporting.push_back(
                std::ranges::all_of(m_points, [&](Vec3 point) { return plane.heightOf(point) <= plane.slack; }));
        }
        for (std::uint32_t k = 0; k < m_planes.size() && m_margin > 0.0; ++k) {
            if (isSupporting[k]) clip(k);
        }
        for (std::uint32_t k = 0; k < m_planes.size() && m_margin > 0.0; ++k) {
            if (isSupporting[k]) continue;
            if (Result<bool> carved = carveAround(k); !carved) return carved.error();
        }
        return largestPart();
    }

private:
    /// The tag of faces that a plane makes.
    std::uint32_t tagOf(std::uint32_t plane) const { return static_cast<std::uint32_t>(m_sides.size()) + plane; }

    /// Takes off what is nearer to a plane than the margin, or beyond it.
    void clip(std::uint32_t k) {
        const ContactPlane& plane = m_planes[k];
        const SectionPlane moved = planeThrough((plane.height - m_margin) * plane.normal, plane.normal);
        const PlaneCut cut = cutByPlane(m_triangles, m_points, moved, m_tolerance);
        m_triangles.clear();
        for (std::uint32_t f = 0; f < cut.faces.faceCount(); ++f) {
            const SolidPartition::Face& face = cut.faces.faces[f];
            if (face.fragment != 0) continue;
            const std::uint32_t tag = face.behind == kNone ? face.source : tagOf(k);
            for (const auto& triangle : cut.faces.trianglesOf(f)) m_triangles.push_back({triangle, tag});
        }
    }

    /// Takes off what is nearer to the faces in a plane than the margin.
    Result<bool> carveAround(std::uint32_t k) {
        const ContactPlane& plane = m_planes[k];
        for (const std::uint32_t side : plane.sides) {
            for (const Corners& polygon : polygonsOf(side, plane.normal)) {
                if (m_triangles.empty()) return true;
                const Result<bool> done = subtract(regionAround(polygon, plane, m_margin), tagOf(k));
                if (!done) return done;
            }
        }
        return true;
    }

    /// A face as one convex polygon, else as its triangles.
    std::vector<Corners> polygonsOf(std::uint32_t side, Vec3 normal) const {
        const std::span<const Vec3> points = m_partition.points;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (const auto& [a, b, c] : m_partition.trianglesOf(m_sides[side].face)) {
            triangles.push_back(m_sides[side].isReversed ? std::array{a, c, b} : std::array{a, b, c});
        }
        Corners loop;
        for (const std::uint32_t point : loopAround(triangles)) loop.push_back(points[point]);
        if (isConvex(loop, normal)) return {std::move(loop)};
        std::vector<Corners> polygons;
        for (const auto& [a, b, c] : triangles) polygons.push_back({points[a], points[b], points[c]});
        return polygons;
    }

    /// What is left, as a partition of one fragment, with a face for each triangle.
    SolidPartition whole() const {
        SolidPartition one;
        one.points = m_points;
        for (std::uint32_t t = 0; t < m_triangles.size(); ++t) {
            one.addFace({0, kNone, t}, std::span(&m_triangles[t].corners, 1));
        }
        one.seedOfFragment = {0};
        one.partOfFragment = {kNone};
        one.fragmentOfSeed = {0};
        one.listFaces();
        one.volumes = {one.volumeOf(0)};
        return one;
    }

    /// Where a piece is, seen from a plane.
    struct Heights {
        double low = 0.0, high = 0.0;  // m; 0: no points below, above
        double sum = 0.0;              // m³: the integral over the surface; triangles without area have no part in it
    };
    Heights heightsOf(const SolidPartition& partition, std::uint32_t piece, const SectionPlane& plane) const {
        Heights heights;
        for (const SolidPartition::FaceSide& side : partition.facesOf(piece)) {
            for (const std::array<std::uint32_t, 3>& triangle : partition.trianglesOf(side.face)) {
                const Vec3 a = partition.points[triangle[0]], b = partition.points[triangle[1]],
                           c = partition.points[triangle[2]];
                heights.sum += glm::length(glm::cross(b - a, c - a)) * plane.heightOf((a + b + c) / 3.0) / 2.0;
                for (const Vec3 point : {a, b, c}) {
                    const double height = plane.heightOf(point);
                    if (height < -m_tolerance) heights.low = std::min(heights.low, height);
                    if (height > m_tolerance) heights.high = std::max(heights.high, height);
                }
            }
        }
        return heights;
    }

    /// Takes off a convex region: it is split off by all its planes, and what is left is merged again.
    Result<bool> subtract(const std::vector<SectionPlane>& planes, std::uint32_t tag) {
        SolidPartition parts = whole();
        std::vector<std::uint32_t> inside = {0};
        for (const SectionPlane& plane : planes) {
            std::vector<std::uint32_t> below;
            for (const std::uint32_t piece : inside) {
                const Heights heights = heightsOf(parts, piece, plane);
                if (heights.high == 0.0) below.push_back(piece);
                if (heights.high == 0.0 || heights.low == 0.0) continue;
                Result<SolidSplit> split = splitFragment(std::move(parts), piece, plane, m_task);
                if (!split) return split.error();
                parts = std::move(split->partition);
                for (const std::uint32_t part : split->pieces) {
                    if (heightsOf(parts, part, plane).sum < 0.0) below.push_back(part);
                }
            }
            inside = std::move(below);
            if (inside.empty()) return true;
        }
        std::vector<std::uint32_t> receivers(parts.fragmentCount(), kNone);
        for (const std::uint32_t piece : inside) receivers[piece] = inside[0];
        const auto left = std::ranges::find(receivers, kNone);
        const std::uint32_t first = static_cast<std::uint32_t>(left - receivers.begin());
        std::ranges::replace(receivers, kNone, first);
        if (left == receivers.end())
            m_triangles.clear();
        else
            adopt(mergedFragments(std::move(parts), receivers), first < inside[0] ? 0 : 1, tag);
        return true;
    }

    /// Goes on with a fragment of a partition of what was left; its inner faces get a tag. Triangles that were cut, but
    /// of which nothing is gone, become whole again.
    void adopt(const SolidPartition& merged, std::uint32_t fragment, std::uint32_t tag) {
        std::vector<std::vector<std::array<std::uint32_t, 3>>> parts(m_triangles.size());
        std::vector<bool> isCut(m_triangles.size()), isNeeded(merged.points.size());
        std::vector<SolidTriangle> left;
        for (std::uint32_t f = 0; f < merged.faces.size(); ++f) {
            const SolidPartition::Face& face = merged.faces[f];
            if (face.behind == kNone && face.fragment != fragment) isCut[face.source] = true;
            for (const auto& [a, b, c] : merged.trianglesOf(f)) {
                if (face.behind == kNone && face.fragment == fragment) parts[face.source].push_back({a, b, c});
                if (face.behind == kNone) continue;
                left.push_back({face.fragment == fragment ? std::array{a, b, c} : std::array{a, c, b}, tag});
                isNeeded[a] = isNeeded[b] = isNeeded[c] = true;
            }
        }
        std::vector<PointLoop> loops(parts.size());
        for (std::uint32_t t = 0; t < parts.size(); ++t) {
            if (!isCut[t]) loops[t] = loopAround(parts[t]);
            for (const std::uint32_t point : m_triangles[t].corners) isNeeded[point] = true;
            if (!loops[t].empty()) continue;
            for (const auto& triangle : parts[t]) {
                for (const std::uint32_t point : triangle) isNeeded[point] = true;
            }
        }
        std::vector<SolidTriangle> whole = left;
        for (std::uint32_t t = 0; t < parts.size(); ++t) {
            for (const auto& triangle : parts[t]) left.push_back({triangle, m_triangles[t].tag});
            if (!loops[t].empty()) parts[t] = triangulated(merged.points, std::move(loops[t]), isNeeded);
            for (const auto& triangle : parts[t]) whole.push_back({triangle, m_triangles[t].tag});
        }
        if (isClosed(whole)) left = std::move(whole);  // not where triangles without area have no loop to go by
        m_points = merged.points;
        m_triangles = std::move(left);
        dropUnusedPoints();
    }

    static std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Vec3> points, PointLoop loop,
                                                                  const std::vector<bool>& isNeeded) {
        Vec3 normal(0.0);
        for (std::size_t k = 2; k < loop.size(); ++k) {
            normal += glm::cross(points[loop[k - 1]] - points[loop[0]], points[loop[k]] - points[loop[0]]);
        }
        std::erase_if(loop, [&](std::uint32_t point) { return !isNeeded[point]; });
        PointTriangles triangles;
        triangulateFace(points, std::span(&loop, 1), PlaneView(normal), 0.0, triangles);
        return {triangles.begin(), triangles.end()};
    }

    void dropUnusedPoints() {
        std::vector<std::uint32_t> numbers(m_points.size(), kNone);
        std::vector<Vec3> used;
        for (SolidTriangle& triangle : m_triangles) {
            for (std::uint32_t& corner : triangle.corners) {
                std::uint32_t& number = numbers[corner];
                if (number == kNone) number = static_cast<std::uint32_t>(used.size()), used.push_back(m_points[corner]);
                corner = number;
            }
        }
        m_points = std::move(used);
    }

    Result<ShrunkFragment> largestPart() const {
        SolidFaces faces;
        for (const SolidTriangle& triangle : m_triangles) {
            faces.triangles.push_back(triangle.corners);
            faces.corners.insert(faces.corners.end(), triangle.corners.begin(), triangle.corners.end());
            faces.faces.push_back({0, kNone, triangle.tag});
            const std::uint32_t count = static_cast<std::uint32_t>(faces.faces.size());
            faces.firstTriangle.push_back(count);
            faces.firstLoop.push_back(count);
            faces.firstCorner.push_back(3 * count);
        }
        const Result<SolidShells> shells = shellsOf(faces, m_points, m_tolerance, m_task);
        if (!shells) return shells.error();
        std::uint32_t largest = kNone;
        ShrunkFragment result;
        for (std::uint32_t s = 0; s < shells->shells.size(); ++s) {
            const SolidShell& shell = shells->shells[s];
            if (shell.owner != s || !(shell.volume > kMinShellVolume)) continue;
            result.isDisconnected = largest != kNone;
            if (largest == kNone || shell.volume > shells->shells[largest].volume) largest = s;
        }
        if (largest == kNone) return result;
        std::vector<std::uint32_t> numbers(m_points.size(), kNone);
        std::vector<SolidTriangle> part, withThin;  // triangles without area may join the part with shells of no volume
        for (std::uint32_t t = 0; t < m_triangles.size(); ++t) {
            const std::uint32_t owner = shells->ownerOf(shells->ofSide[2 * t]);
            if (owner == largest) part.push_back(m_triangles[t]);
            if (owner == largest || owner == kNone || !(shells->shells[owner].volume > kMinShellVolume)) {
                withThin.push_back(m_triangles[t]);
            }
        }
        const std::vector<SolidTriangle>& left = isClosed(part) ? part : isClosed(withThin) ? withThin : m_triangles;
        for (const SolidTriangle& triangle : left) add(triangle, numbers, result);
        result.volume = signedVolume(result.mesh);
        return result;
    }

    void add(const SolidTriangle& triangle, std::vector<std::uint32_t>& numbers, ShrunkFragment& result) const {
        std::array<std::uint32_t, 3> corners{};
        for (int k = 0; k < 3; ++k) {
            std::uint32_t& number = numbers[triangle.corners[k]];
            if (number == kNone) {
                number = static_cast<std::uint32_t>(result.mesh.points.size());
                result.mesh.points.push_back(m_points[triangle.corners[k]]);
            }
            corners[k] = number;
        }
        result.mesh.triangles.push_back(corners);
        result.sides.push_back(sideOf(triangle.tag));
    }

    ShrunkFragment::Side sideOf(std::uint32_t tag) const {
        if (tag >= m_sides.size()) return {m_planes[tag - m_sides.size()].neighbour, kNone};
        const SolidPartition::Face& face = m_partition.faces[m_sides[tag].face];
        return {m_sides[tag].isReversed ? face.fragment : face.behind, face.source};
    }

    const SolidPartition& m_partition;
    std::span<const SolidPartition::FaceSide> m_sides;
    double m_margin, m_tolerance;
    std::uint32_t m_fragment;
    TaskContext m_task;  // on this thread
    std::vector<ContactPlane> m_planes;
    std::vector<Vec3> m_points;
    std::vector<SolidTriangle> m_triangles;  // tag: the place in facesOf(fragment), or tagOf() a plane
};

/// Reports that a fragment vanishes, or else falls apart.
Diagnostic lossReport(const SolidPartition& partition, std::uint32_t fragment, const ShrunkFragment& left) {
    const double lost = partition.volumes[fragment] - left.volume;
    const std::uint32_t seed = partition.seedOfFragment[fragment];
    const std::string of = seed == kNone ? "the mesh" : "the cell of seed " + std::to_string(seed),
                      volume = quantityText(QuantityKind::Volume, lost);
    return diagnostic(
        DiagnosticCode::VanishedPiece, {.seed = seed},
        left.isDisconnected
            ? "The gap between fragments cuts a fragment of " + of + " apart; its largest part remains, and " + volume +
                  " are left out."
            : "A fragment of " + of + " is narrower than the gap between fragments; it is omitted with " + volume + ".",
        lost);
}

}  // namespace

Result<ShrunkSolid> shrunkFragments(const SolidPartition& partition, double gap, const TaskContext& task) {
    if (!(gap >= 0.0) || !std::isfinite(gap)) {
        return Error{ErrorCode::BadInput, "The gap between fragments is negative or not finite."};
    }
    const double tolerance = planeTolerance(partition);
    ShrunkSolid solid;
    solid.fragments.resize(partition.fragmentCount());
    std::vector<Error> errors(partition.fragmentCount());
    std::vector<std::uint8_t> hasFailed(partition.fragmentCount());
    forEachIndex(solid.fragments.size(), task.threads, [&](std::size_t k) {
        if (task.isCancelled()) return;
        const std::uint32_t fragment = static_cast<std::uint32_t>(k);
        Result<ShrunkFragment> shrunk =
            FragmentShrinker(partition, fragment, gap / 2.0, tolerance, task.cancel).shrink();
        hasFailed[k] = !shrunk;
        if (shrunk)
            solid.fragments[k] = std::move(*shrunk);
        else
            errors[k] = shrunk.error();
    });
    if (task.isCancelled()) return TaskContext::cancelled();
    if (const auto failed = std::ranges::find(hasFailed, 1); failed != hasFailed.end()) {
        return errors[static_cast<std::size_t>(failed - hasFailed.begin())];
    }
    CappedDiagnostics found;
    for (std::uint32_t k = 0; k < partition.fragmentCount(); ++k) {
        const ShrunkFragment& left = solid.fragments[k];
        if (!left.mesh.triangles.empty() && !left.isDisconnected) continue;
        found.add(DiagnosticCode::VanishedPiece, [&] { return lossReport(partition, k, left); });
    }
    solid.diagnostics = std::move(found).list();
    return solid;
}

Diagnostic vanishedReport(const SolidPartition& partition, std::uint32_t fragment) {
    return lossReport(partition, fragment, {});
}

}  // namespace rubble
