#include "core/geometry/mesh/ClosedMesh.h"

#include "core/geometry/mesh/MeshHash.h"

#include <algorithm>

namespace rubble {
namespace {

std::shared_ptr<const ClosedMesh> withProperties(TriangleMesh mesh) {
    auto closed = std::make_shared<ClosedMesh>();
    closed->bounds = boundsOf(mesh);
    closed->mass = massOf(mesh.points, mesh.triangles);
    closed->hash = hashOf(mesh);
    closed->mesh = std::move(mesh);
    return closed;
}

/// Whether a finding says that something was done to the mesh.
bool isChange(const MeshFinding& finding) {
    switch (finding.kind) {
        case MeshFindingKind::DroppedTriangles:
        case MeshFindingKind::WeldedPoints:
        case MeshFindingKind::SeparatedPoints:
        case MeshFindingKind::TurnedTriangles:
        case MeshFindingKind::TurnedShells: return true;
        default: return false;
    }
}

}  // namespace

ContentHash hashOf(const TriangleMesh& mesh) {
    Hasher hasher;
    hasher.add(std::uint64_t{mesh.points.size()});
    for (const Vec3& point : mesh.points) {
        for (int axis = 0; axis < 3; ++axis) hasher.add(point[axis]);
    }
    for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
        for (const std::uint32_t point : triangle) hasher.add(std::uint64_t{point});
    }
    return hasher.digest();
}

std::shared_ptr<const ClosedMesh> closedMesh(MeshVerdict verdict) { return withProperties(std::move(verdict.mesh)); }

std::shared_ptr<const ClosedMesh> scaled(const ClosedMesh& mesh, Vec3 factors) {
    TriangleMesh made = mesh.mesh;
    const Vec3 centre = mesh.bounds.centre();
    for (Vec3& point : made.points) point = centre + factors * (point - centre);
    return withProperties(std::move(made));
}

Result<std::shared_ptr<const ClosedMesh>> closedMesh(TriangleMesh mesh, const TaskContext& task) {
    const Result<MeshVerdict> verdict = judgeMesh(mesh, task);
    if (!verdict) return verdict.error();
    if (!verdict->isFit()) return Error{ErrorCode::Degenerate, verdict->findings[0].message};
    const auto change = std::ranges::find_if(verdict->findings, isChange);
    if (change != verdict->findings.end()) return Error{ErrorCode::Degenerate, change->message};
    return withProperties(std::move(mesh));
}

}  // namespace rubble
