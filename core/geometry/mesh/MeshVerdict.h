#pragma once

#include "core/base/TaskContext.h"
#include "core/geometry/mesh/MeshShells.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rubble {

/// What is found about a mesh that is to be cut as a solid.
enum class MeshFindingKind {
    // Faults: the mesh cannot be cut.
    NoTriangles,
    UnknownPoint,       // a triangle refers to a point that does not exist
    NotFinite,          // a coordinate is not finite, or as large as kMaxMeshCoordinate
    Open,               // edges with one triangle
    CrowdedEdge,        // edges with more than two triangles that do not bound solids one by one
    NotOrientable,      // the triangles cannot all be turned the same way
    CoincidingPoints,   // the ends of edges coincide on the lattice on which the mesh is cut
    NoVolume,           // a shell is thinner than the lattice
    Crossing,           // triangles of one shell cross
    OverlappingShells,  // shells cross, or one is inside another and both are solid
    NoThickness,        // solid between two triangles in one place
    // Notes: what holds of a mesh that can be cut, or was done to its copy.
    DroppedTriangles,     // with a corner twice
    WeldedPoints,         // the mesh is closed only with points at, or near, one place as one
    SeparatedPoints,      // parts that share only a corner or an edge got points of their own
    TurnedTriangles,      // to agree with their neighbours
    TurnedShells,         // inside out
    DegenerateTriangles,  // without area
    TouchingTriangles,    // the mesh touches itself in edges or faces
};
inline constexpr int kMeshFindingKinds = 18;
/// The kind's name: "Open".
const char* nameOf(MeshFindingKind kind);
bool isFault(MeshFindingKind kind);

/// One finding about a mesh.
struct MeshFinding {
    MeshFindingKind kind = MeshFindingKind::NoTriangles;
    std::size_t count = 0;      // of triangles, points, edges, shells, or pairs of triangles that cross or touch
    Vec3 place{0.0, 0.0, 0.0};  // m, of the first
    std::vector<std::uint32_t> triangles;             // of the mesh as given; at most kMaxMarked
    std::vector<std::array<std::uint32_t, 2>> edges;  // points of the mesh as given; at most kMaxMarked
    std::string message;                              // one sentence with count and place
};
/// The most triangles or edges that a finding lists.
inline constexpr std::size_t kMaxMarked = 10'000;

/// Whether and how a mesh can be cut as a solid.
struct MeshVerdict {
    std::vector<MeshFinding> findings;  // a fault comes first; at most one
    bool isFit() const { return findings.empty() || !isFault(findings[0].kind); }

    // Of a mesh that is fit:
    TriangleMesh mesh;                   // closed, two triangles at each edge, counter-clockwise from outside
    std::vector<std::uint32_t> sources;  // each triangle's index in the mesh as given, ascending
    std::vector<std::uint32_t> shellOf;  // each triangle's
    std::vector<MeshShell> shells;       // by first triangle
    std::uint32_t partCount = 0;         // separate solids
    double volume = 0.0;                 // m³
};

/// Judges whether a mesh is the boundary of solids, exactly: closed, with neighbours facing the same way, not crossing
/// itself, every place inside one solid at most. It may touch itself in faces, edges and corners. Nested shells that
/// face each other's way around are cavities.
///
/// Points are used by index where the mesh is closed that way; else equal ones are one, else near ones, as welded()
/// has it. Crossings are decided for the points on the SolidLattice of the mesh, so as it is cut. The mesh stays as it
/// is; what was done to the copy is found in the notes. The result does not depend on the number of threads.
/// O(n log n) for n triangles plus the number of those that meet. `origin`, m: of the mesh's frame in the world, in
/// which the places of findings are.
///
/// Errors: Cancelled.
Result<MeshVerdict> judgeMesh(const TriangleMesh& mesh, const TaskContext& task = {}, Vec3 origin = Vec3(0.0));

}  // namespace rubble
