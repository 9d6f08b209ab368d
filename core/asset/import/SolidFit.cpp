#include "core/asset/import/SolidFit.h"

#include <algorithm>

namespace rubble {
namespace {

/// The centre of the box around the triangles that have three points.
Vec3 centreOf(const TriangleMesh& mesh) {
    Box3 box;
    for (const auto& [a, b, c] : mesh.triangles) {
        if (a == b || b == c || c == a) continue;
        for (const std::uint32_t corner : {a, b, c}) {
            if (corner < mesh.points.size()) box.include(mesh.points[corner]);
        }
    }
    return box.isEmpty() ? Vec3(0.0) : box.centre();
}

MeshProblem problemOf(const MeshFinding& finding, const TriangleMesh& mesh) {
    MeshProblem problem{finding.message, finding.place, {}, {}};
    const auto isKnown = [&](std::uint32_t point) { return point < mesh.points.size(); };
    for (const std::uint32_t t : finding.triangles) {
        const auto& [a, b, c] = mesh.triangles[t];
        if (isKnown(a) && isKnown(b) && isKnown(c))
            problem.triangles.push_back({mesh.points[a], mesh.points[b], mesh.points[c]});
    }
    for (const auto& [a, b] : finding.edges) problem.edges.push_back({mesh.points[a], mesh.points[b]});
    return problem;
}

}  // namespace

Result<SolidTrial> fittedSolid(const TriangleMesh& mesh, const TaskContext& context) {
    const Vec3 centre = centreOf(mesh);
    TriangleMesh local = mesh;
    for (Vec3& point : local.points) point -= centre;
    Result<MeshVerdict> verdict = judgeMesh(local, context, centre);
    if (!verdict) return verdict.error();
    SolidTrial trial;
    if (!verdict->isFit()) {
        trial.problem = problemOf(verdict->findings[0], mesh);
        return trial;
    }
    for (const MeshFinding& finding : verdict->findings) trial.notes.push_back(finding.message);
    SolidFit& solid = trial.solid.emplace();
    solid.position = centre;
    solid.parts = verdict->partCount;
    solid.cavities = static_cast<std::uint32_t>(std::ranges::count_if(verdict->shells, &MeshShell::isCavity));
    solid.mesh = closedMesh(std::move(*verdict));
    return trial;
}

}  // namespace rubble
