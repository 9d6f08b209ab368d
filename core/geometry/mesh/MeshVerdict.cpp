#include "core/geometry/mesh/MeshVerdict.h"

#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/geometry/mesh/MeshCrossings.h"
#include "core/geometry/mesh/MeshWelding.h"
#include "core/geometry/mesh/PreparedMesh.h"
#include "core/geometry/mesh/SolidLattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace rubble {
namespace {

using Kind = MeshFindingKind;

std::string placeText(Vec3 place) {
    return "(" + roundedText(place.x, 6) + ", " + roundedText(place.y, 6) + ", " + roundedText(place.z, 6) + ")";
}
/// "1 edge has one face only, at (0, 0, 0)." or "3 edges have ..., the first at (0, 0, 0)."
std::string sentence(std::size_t count, const char* one, const char* many, Vec3 place, const std::string& end = "") {
    return (count == 1 ? std::string("1 ") + one + ", at " : std::to_string(count) + " " + many + ", the first at ") +
           placeText(place) + end + ".";
}

template <class Item>
std::vector<Item> firstOf(std::vector<Item> items) {
    if (items.size() > kMaxMarked) items.resize(kMaxMarked);
    return items;
}

bool isFinitePoint(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// What makes triangles useless; the rest of the judgement needs points that exist and are finite.
std::optional<MeshFinding> numberFault(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return MeshFinding{Kind::NoTriangles, 0, {}, {}, {}, "The mesh has no triangles."};
    MeshFinding unknown{Kind::UnknownPoint, 0, {}, {}, {}, {}}, infinite{Kind::NotFinite, 0, {}, {}, {}, {}};
    const auto isInfinite = [](double x) { return !(x > -kMaxMeshCoordinate && x < kMaxMeshCoordinate); };
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::uint32_t corner : mesh.triangles[t]) {
            MeshFinding* fault = nullptr;
            if (corner >= mesh.points.size())
                fault = &unknown;
            else if (const Vec3 p = mesh.points[corner]; isInfinite(p.x) || isInfinite(p.y) || isInfinite(p.z))
                fault = &infinite;
            if (fault && (fault->triangles.empty() || fault->triangles.back() != t)) fault->triangles.push_back(t);
        }
    }
    for (MeshFinding* fault : {&unknown, &infinite}) {
        if (fault->triangles.empty()) continue;
        fault->count = fault->triangles.size();
        const bool isOne = fault->count == 1;
        std::string what = " to points that do not exist";
        if (fault == &infinite) {
            const auto isFinite = [&](std::uint32_t corner) { return isFinitePoint(mesh.points[corner]); };
            what = std::ranges::all_of(mesh.triangles[fault->triangles[0]], isFinite)
                       ? " to points 1e30 m or more from the origin"
                       : " to points that are not finite";
        }
        fault->message = std::to_string(fault->count) + (isOne ? " triangle refers" : " triangles refer") + what +
                         (isOne ? ": triangle " : ", the first is triangle ") + std::to_string(fault->triangles[0]) +
                         ".";
        fault->triangles = firstOf(std::move(fault->triangles));
        return *fault;
    }
    return std::nullopt;
}

class MeshJudge {
public:
    MeshJudge(const TriangleMesh& given, const TaskContext& task, Vec3 origin)
        : m_given(given), m_task(task), m_origin(origin) {}

    Result<MeshVerdict> judge() {
        if (const std::optional<MeshFinding> fault = numberFault(m_given)) {
            m_verdict.findings.push_back(*fault);
            return std::move(m_verdict);
        }
        for (const auto step : {&MeshJudge::prepare, &MeshJudge::agree, &MeshJudge::separate, &MeshJudge::measure,
                                &MeshJudge::nest, &MeshJudge::cross}) {
            const Result<bool> isGood = (this->*step)();
            if (!isGood) return isGood.error();
            if (!*isGood) return std::move(m_verdict);
        }
        finish();
        return std::move(m_verdict);
    }

private:
    /// Neighbours at edges. Each step returns false after a fault.
    Result<bool> prepare() {
        Result<PreparedMesh> prepared = preparedMesh(m_given, m_task.stage(0.0, 0.2));
        if (!prepared) return prepared.error();
        m_prepared = std::move(*prepared);
        m_task.report(0.2);
        if (const auto& dropped = m_prepared.dropped; !dropped.empty()) {
            const Vec3 place = placeOf(m_given.triangles[dropped[0]][0]);
            note(Kind::DroppedTriangles, dropped.size(), place, dropped,
                 sentence(dropped.size(), "triangle has a corner twice and is left out",
                          "triangles have a corner twice and are left out", place));
        }
        if (m_prepared.mesh.triangles.empty())
            return fault(
                {Kind::NoVolume, 1, placeOf(m_given.triangles[0][0]), {}, {}, "No triangle of the mesh has an area."});
        if (const auto& welded = m_prepared.welded; !welded.empty()) {
            const Vec3 place = placeOf(welded[0]);
            const double moved = m_prepared.maxWeldDistance;
            const std::string distance = moved > 0.0 ? ", moved by up to " + roundedText(moved, 3) + " m" : "";
            note(Kind::WeldedPoints, welded.size(), place, {},
                 sentence(welded.size(), "point is joined with another one so that the mesh closes",
                          "points are joined with others so that the mesh closes", place, distance));
        }
        if (!m_prepared.edges.open.empty())
            return edgeFault(Kind::Open, m_prepared.edges.open, "edge has one face only", "edges have one face only");
        if (!m_prepared.edges.crowded.empty()) return crowdedFault(m_prepared.edges.crowded);
        return true;
    }

    /// Windings.
    Result<bool> agree() {
        Result<Windings> windings = agreeWindings(m_prepared.mesh.triangles, m_prepared.edges.across, m_task);
        if (!windings) return windings.error();
        m_windings = std::move(*windings);
        if (!m_windings.conflicting.empty())
            return edgeFault(Kind::NotOrientable, m_windings.conflicting,
                             "edge has faces that cannot be turned to face the same way",
                             "edges have faces that cannot be turned to face the same way");
        std::vector<std::uint32_t> turned;
        for (std::uint32_t t = 0; t < m_windings.turned.size(); ++t)
            if (m_windings.turned[t]) turned.push_back(t);
        m_surface.points = std::move(m_prepared.onLattice);
        m_surface.triangles = m_prepared.mesh.triangles;
        m_surface.across = std::move(m_prepared.edges.across);
        if (!turned.empty()) {
            const Vec3 place = middleOf(turned[0]);
            note(Kind::TurnedTriangles, turned.size(), place, given(turned),
                 sentence(turned.size(), "triangle is turned to face the same way as its neighbours",
                          "triangles are turned to face the same way as their neighbours", place));
            m_surface.turnOver(m_windings.turned);
        }
        return true;
    }

    /// Points of their own for parts that share only points.
    Result<bool> separate() {
        Result<SeparatedPoints> separated = separateFans(m_surface, m_task);
        if (!separated) return separated.error();
        m_surface.triangles = std::move(separated->triangles);
        for (const std::uint32_t source : separated->copied) {
            m_surface.points.push_back(Vec3(m_surface.points[source]));
            m_prepared.mesh.points.push_back(Vec3(m_prepared.mesh.points[source]));
        }
        if (const auto& copied = separated->copied; !copied.empty()) {
            const Vec3 place = m_origin + m_prepared.mesh.points[copied[0]];
            note(Kind::SeparatedPoints, copied.size(), place, {},
                 sentence(copied.size(), "point at which parts of the mesh only touch is separated",
                          "points at which parts of the mesh only touch are separated", place));
        }
        if (m_prepared.edges.divided.empty()) return true;
        // Sheets that meet at an edge may be one sheet around its ends; then the edge cannot be two.
        const Result<EdgePairs> edges = pairEdges(m_surface.triangles, m_surface.points, false, m_task);
        if (!edges) return edges.error();
        std::vector<std::uint32_t> crowded = edges->divided;
        crowded.insert(crowded.end(), edges->crowded.begin(), edges->crowded.end());
        std::ranges::sort(crowded);
        return crowded.empty() ? Result<bool>(true) : crowdedFault(crowded);
    }

    /// Triangles on the lattice.
    Result<bool> measure() {
        const std::size_t count = m_surface.triangles.size();
        m_surface.views.resize(count);
        std::vector<char> hasShortEdge(3 * count, 0);
        constexpr std::size_t kChunkSize = 1u << 14;
        const std::size_t chunks = count / kChunkSize + 1;
        forEachIndex(chunks, m_task.threads, [&](std::size_t chunk) {
            const IndexRange range = chunkRange(count, chunk, chunks);
            if (m_task.isCancelled()) return;
            for (auto t = static_cast<std::uint32_t>(range.begin); t < range.end; ++t) {
                const Vec3 a = m_surface.corner(t, 0), b = m_surface.corner(t, 1), c = m_surface.corner(t, 2);
                m_surface.views[t] = viewOf(a, b, c);
                for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
                    const std::uint32_t from = m_surface.origin(h), to = m_surface.target(h);
                    hasShortEdge[h] = from < to && m_surface.points[from] == m_surface.points[to] &&
                                      m_prepared.mesh.points[from] != m_prepared.mesh.points[to];
                }
            }
        });
        if (m_task.isCancelled()) return TaskContext::cancelled();
        std::vector<std::uint32_t> shortEdges, degenerate;
        for (std::uint32_t h = 0; h < 3 * count; ++h)
            if (hasShortEdge[h]) shortEdges.push_back(h);
        if (!shortEdges.empty()) {
            const std::string end = ", on the lattice of " + roundedText(m_prepared.step, 2) + " m on which it is cut";
            return edgeFault(Kind::CoincidingPoints, shortEdges, "edge of the mesh has ends that coincide",
                             "edges of the mesh have ends that coincide", end);
        }
        for (std::uint32_t t = 0; t < count; ++t)
            if (m_surface.isDegenerate(t)) degenerate.push_back(t);
        if (!degenerate.empty()) {
            const Vec3 place = middleOf(degenerate[0]);
            note(Kind::DegenerateTriangles, degenerate.size(), place, given(degenerate),
                 sentence(degenerate.size(), "triangle has no area", "triangles have no area", place));
        }
        return true;
    }

    /// Shells.
    Result<bool> nest() {
        m_task.report(0.3);
        Result<TriangleTree> tree = TriangleTree::make(m_surface, m_task);
        if (!tree) return tree.error();
        m_tree = std::move(*tree);
        m_task.report(0.5);
        Result<ShellNesting> nesting =
            nestShells(m_surface, m_prepared.mesh.points, m_windings.shellOf, *m_tree, m_task);
        if (!nesting) return nesting.error();
        m_nesting = std::move(*nesting);
        constexpr double kMinThickness = 4.0;  // steps
        std::vector<std::uint32_t> flat, turned;
        for (std::uint32_t s = 0; s < m_nesting.shells.size(); ++s) {
            const MeshShell& shell = m_nesting.shells[s];
            if (!(std::abs(shell.volume) > kMinThickness * m_prepared.step * shell.area)) flat.push_back(s);
            if (m_nesting.turned[s]) turned.push_back(s);
        }
        const auto placeOf = [&](std::uint32_t s) { return middleOf(m_nesting.shells[s].firstTriangle); };
        if (!flat.empty())
            return fault({Kind::NoVolume,
                          flat.size(),
                          placeOf(flat[0]),
                          trianglesOfShells(flat),
                          {},
                          sentence(flat.size(), "shell of the mesh encloses no volume",
                                   "shells of the mesh enclose no volume", placeOf(flat[0]))});
        if (!turned.empty()) {
            note(Kind::TurnedShells, turned.size(), placeOf(turned[0]), trianglesOfShells(turned),
                 sentence(turned.size(), "shell of the mesh is inside out and is turned",
                          "shells of the mesh are inside out and are turned", placeOf(turned[0])));
            std::vector<char> isTurned(m_surface.triangles.size());
            for (std::size_t t = 0; t < isTurned.size(); ++t) isTurned[t] = m_nesting.turned[m_windings.shellOf[t]];
            m_surface.turnOver(isTurned);
        }
        return true;
    }

    /// Crossings and overlaps.
    Result<bool> cross() {
        m_task.report(0.55);
        const Result<MeshCrossings> crossings = findCrossings(m_surface, *m_tree, m_task);
        if (!crossings) return crossings.error();
        m_task.report(1.0);
        std::vector<TrianglePair> within, between;
        for (const TrianglePair& pair : crossings->crossing)
            (m_windings.shellOf[pair[0]] == m_windings.shellOf[pair[1]] ? within : between).push_back(pair);
        if (!within.empty()) {
            MeshFinding found = pairFinding(Kind::Crossing, within, "cross");
            if (!crossings->isComplete) found.message = "More than " + found.message;
            return fault(std::move(found));
        }
        if (!between.empty()) return crossingShells(between);
        if (!m_nesting.overlapping.empty()) return nestedShells();
        if (!crossings->thin.empty())
            return fault(pairFinding(Kind::NoThickness, crossings->thin, "have solid of no thickness between them"));
        if (!crossings->touching.empty())
            m_verdict.findings.push_back(pairFinding(Kind::TouchingTriangles, crossings->touching, "touch"));
        return true;
    }

    Result<bool> crossingShells(const std::vector<TrianglePair>& pairs) {
        std::set<std::array<std::uint32_t, 2>> shells;
        for (const auto& [a, b] : pairs) {
            const std::uint32_t s = m_windings.shellOf[a], t = m_windings.shellOf[b];
            shells.insert({std::min(s, t), std::max(s, t)});
        }
        MeshFinding found = pairFinding(Kind::OverlappingShells, pairs, "cross");
        found.count = shells.size();
        const auto [first, second] = *shells.begin();
        const std::string names = std::to_string(first) + " and " + std::to_string(second);
        const auto pair = std::ranges::find_if(pairs, [&](const TrianglePair& p) {
            const std::uint32_t s = m_windings.shellOf[p[0]], t = m_windings.shellOf[p[1]];
            return std::min(s, t) == first && std::max(s, t) == second;
        });
        found.place = placeOf(*pair);
        found.message =
            (shells.size() == 1 ? "Shells " + names + " overlap"
                                : std::to_string(shells.size()) + " pairs of shells overlap, the first is " + names) +
            ": triangles " + numberOf((*pair)[0]) + " and " + numberOf((*pair)[1]) + " cross at " +
            placeText(found.place) + ".";
        return fault(std::move(found));
    }

    Result<bool> nestedShells() {
        const auto [inner, outer] = m_nesting.overlapping[0];
        const std::size_t count = m_nesting.overlapping.size();
        const Vec3 place = middleOf(m_nesting.shells[inner].firstTriangle);
        std::vector<std::uint32_t> inside;
        for (const auto& pair : m_nesting.overlapping) inside.push_back(pair[0]);
        const std::string both = m_nesting.shells[inner].isCavity() ? "both are hollow" : "both are solid";
        const std::string what =
            count == 1 ? "Shell " + std::to_string(inner) + " is inside shell " + std::to_string(outer) + " and " + both
                       : std::to_string(count) + " shells are inside others where " + both + ", the first is shell " +
                             std::to_string(inner) + " inside shell " + std::to_string(outer);
        return fault({Kind::OverlappingShells,
                      count,
                      place,
                      trianglesOfShells(inside),
                      {},
                      what + ", at " + placeText(place) + "."});
    }

    /// Triangles that cross or touch.
    MeshFinding pairFinding(Kind kind, const std::vector<TrianglePair>& pairs, const std::string& verb) const {
        MeshFinding found{kind, pairs.size(), placeOf(pairs[0]), {}, {}, {}};
        std::set<std::uint32_t> triangles;
        for (const TrianglePair& pair : pairs) {
            if (triangles.size() + 2 > kMaxMarked) break;
            triangles.insert({m_prepared.sources[pair[0]], m_prepared.sources[pair[1]]});
        }
        found.triangles.assign(triangles.begin(), triangles.end());
        const std::string names = numberOf(pairs[0][0]) + " and " + numberOf(pairs[0][1]);
        found.message = (pairs.size() == 1 ? "Triangles " + names + " " + verb
                                           : std::to_string(pairs.size()) + " pairs of triangles " + verb +
                                                 ", the first are " + names) +
                        ", at " + placeText(found.place) + ".";
        return found;
    }

    Vec3 placeOf(const TrianglePair& pair) const {
        const SolidLattice lattice(boundsOf(m_prepared.mesh));
        return m_origin + lattice.origin() + lattice.metres(commonPoint(m_surface, pair[0], pair[1]));
    }
    /// The place of a point of the mesh as given.
    Vec3 placeOf(std::uint32_t point) const { return m_origin + m_given.points[point]; }
    std::string numberOf(std::uint32_t triangle) const { return std::to_string(m_prepared.sources[triangle]); }

    Vec3 middleOf(std::uint32_t triangle) const {
        const auto [a, b, c] = m_given.triangles[m_prepared.sources[triangle]];
        return m_origin + (m_given.points[a] + m_given.points[b] + m_given.points[c]) / 3.0;
    }
    std::vector<std::uint32_t> given(std::vector<std::uint32_t> triangles) const {
        for (std::uint32_t& triangle : triangles) triangle = m_prepared.sources[triangle];
        return triangles;
    }
    std::vector<std::uint32_t> trianglesOfShells(const std::vector<std::uint32_t>& shells) const {
        std::vector<std::uint32_t> triangles;
        for (std::uint32_t t = 0; t < m_windings.shellOf.size() && triangles.size() < kMaxMarked; ++t) {
            if (std::ranges::binary_search(shells, m_windings.shellOf[t])) triangles.push_back(m_prepared.sources[t]);
        }
        return triangles;
    }

    void note(Kind kind, std::size_t count, Vec3 place, std::vector<std::uint32_t> triangles, std::string message) {
        m_verdict.findings.push_back({kind, count, place, firstOf(std::move(triangles)), {}, std::move(message)});
    }
    Result<bool> fault(MeshFinding found) {
        m_verdict.findings.insert(m_verdict.findings.begin(), std::move(found));
        return false;
    }
    Result<bool> crowdedFault(const std::vector<std::uint32_t>& halfEdges) {
        return edgeFault(Kind::CrowdedEdge, halfEdges, "edge has more than two faces",
                         "edges have more than two faces");
    }
    /// A fault at edges, of the triangles as prepared.
    Result<bool> edgeFault(Kind kind, const std::vector<std::uint32_t>& halfEdges, const char* one, const char* many,
                           const std::string& end = "") {
        MeshFinding found{kind, halfEdges.size(), {}, {}, {}, {}};
        std::set<std::uint32_t> triangles;
        for (const std::uint32_t h : firstOf(halfEdges)) {
            const std::uint32_t source = m_prepared.sources[h / 3];
            const auto& corners = m_given.triangles[source];
            // A triangle that was turned over has its edges in the opposite order.
            const bool isTurned = kind != Kind::NotOrientable && !m_windings.turned.empty() && m_windings.turned[h / 3];
            const std::uint32_t k = isTurned ? 2 - h % 3 : h % 3;
            found.edges.push_back({corners[k], corners[(k + 1) % 3]});
            triangles.insert(source);
        }
        found.triangles.assign(triangles.begin(), triangles.end());
        found.place = m_origin + (m_given.points[found.edges[0][0]] + m_given.points[found.edges[0][1]]) / 2.0;
        found.message = sentence(found.count, one, many, found.place, end);
        return fault(std::move(found));
    }

    void finish() {
        m_verdict.mesh = {std::move(m_prepared.mesh.points), std::move(m_surface.triangles)};
        m_verdict.sources = std::move(m_prepared.sources);
        m_verdict.shellOf = std::move(m_windings.shellOf);
        m_verdict.shells = std::move(m_nesting.shells);
        m_verdict.partCount = m_nesting.partCount;
        for (const MeshShell& shell : m_verdict.shells) m_verdict.volume += shell.volume;
    }

    const TriangleMesh& m_given;
    const TaskContext& m_task;
    Vec3 m_origin;
    PreparedMesh m_prepared;
    Windings m_windings;
    LatticeSurface m_surface;
    std::optional<TriangleTree> m_tree;
    ShellNesting m_nesting;
    MeshVerdict m_verdict;
};

}  // namespace

const char* nameOf(MeshFindingKind kind) {
    constexpr std::array<const char*, kMeshFindingKinds> kNames = {"NoTriangles",
                                                                   "UnknownPoint",
                                                                   "NotFinite",
                                                                   "Open",
                                                                   "CrowdedEdge",
                                                                   "NotOrientable",
                                                                   "CoincidingPoints",
                                                                   "NoVolume",
                                                                   "Crossing",
                                                                   "OverlappingShells",
                                                                   "NoThickness",
                                                                   "DroppedTriangles",
                                                                   "WeldedPoints",
                                                                   "SeparatedPoints",
                                                                   "TurnedTriangles",
                                                                   "TurnedShells",
                                                                   "DegenerateTriangles",
                                                                   "TouchingTriangles"};
    return kNames[static_cast<std::size_t>(kind)];
}

bool isFault(MeshFindingKind kind) { return kind <= MeshFindingKind::NoThickness; }

Result<MeshVerdict> judgeMesh(const TriangleMesh& mesh, const TaskContext& task, Vec3 origin) {
    return MeshJudge(mesh, task, origin).judge();
}

}  // namespace rubble
