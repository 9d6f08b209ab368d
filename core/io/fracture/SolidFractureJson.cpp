#include "core/io/fracture/SolidFractureJson.h"

#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/solid/SolidHulls.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/io/fracture/FractureJson.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

#include <algorithm>

namespace rubble {
namespace {

Vec3 readPoint(const JsonValue& value) {
    const std::array<double, 3> xyz = value.numbers<3>();
    return {xyz[0], xyz[1], xyz[2]};
}

/// Points in use, those of the mesh first.
class PointNames {
public:
    PointNames(const SolidPartition& partition, const TriangleMesh& mesh) : m_names(partition.points.size(), kNone) {
        m_points = mesh.points;
        for (std::uint32_t k = 0; k < mesh.points.size(); ++k) m_names[k] = k;
        for (const std::array<std::uint32_t, 3>& triangle : partition.triangles) {
            for (const std::uint32_t point : triangle) {
                if (m_names[point] != kNone) continue;
                m_names[point] = static_cast<std::uint32_t>(m_points.size());
                m_points.push_back(partition.origin + partition.points[point]);
            }
        }
    }
    const std::vector<Vec3>& points() const { return m_points; }
    std::int64_t of(std::uint32_t point) const { return m_names[point]; }

private:
    std::vector<std::uint32_t> m_names;
    std::vector<Vec3> m_points;
};

void writeFace(JsonWriter& json, const SolidFractureInput& input, const SolidPartition& partition, std::uint32_t face,
               const PointNames& names) {
    const SolidPartition::Face& sides = partition.faces[face];
    json.openObject();
    json.wholeNumber("fragment", std::uint64_t{sides.fragment});
    if (sides.behind != kNone) json.wholeNumber("behind", std::uint64_t{sides.behind});
    if (sides.source != kNone) json.wholeNumber("source", std::uint64_t{input.sources[sides.source]});
    json.rows("triangles", partition.trianglesOf(face), [&](const auto& t) {
        return std::array{names.of(t[0]), names.of(t[1]), names.of(t[2])};
    });
    json.close();
}

void writeFragment(JsonWriter& json, const SolidPartition& partition, std::uint32_t fragment) {
    std::vector<std::uint32_t> faces, neighbours;
    for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
        const SolidPartition::Face& face = partition.faces[side.face];
        faces.push_back(side.face);
        if (face.behind != kNone) neighbours.push_back(side.isReversed ? face.fragment : face.behind);
    }
    std::ranges::sort(neighbours);
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    const TriangleMesh mesh = meshOf(partition, fragment);
    const Vec3 centre = partition.origin + massOf(mesh.points, mesh.triangles).centre;
    json.openObject();
    json.wholeNumber("seed", std::uint64_t{partition.seedOfFragment[fragment]});
    json.number("volume", partition.volumes[fragment]);
    json.numbers("centroid", {centre.x, centre.y, centre.z});
    json.wholeNumbers("faces", faces);
    json.wholeNumbers("neighbours", neighbours);
    json.close();
}

}  // namespace

bool hasMesh(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    return document && document->root().isObject() && document->root()["mesh"].isPresent();
}

Result<SolidFractureInput> readSolidFractureInput(std::string_view json, const TaskContext& task) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    const JsonValue root = document->root();
    root.requireObject({"mesh", "seeds"});
    root["mesh"].requireObject({"points", "triangles"});
    SolidFractureInput input;
    input.mesh.points = root["mesh"]["points"].list(readPoint);
    const std::uint32_t count = static_cast<std::uint32_t>(input.mesh.points.size());
    if (count == 0) root["mesh"]["points"].fail("a mesh needs points");
    for (const JsonValue triangle : root["mesh"]["triangles"].elements()) {
        const auto corners =
            triangle.list([&](const JsonValue& corner) { return corner.index(0, std::max(count, 1u) - 1); });
        if (corners.size() != 3) {
            triangle.fail("a triangle has three corners");
            break;
        }
        input.mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    }
    input.seeds = root["seeds"].list(readPoint);
    if (input.seeds.empty()) root["seeds"].fail("a mesh is cut by at least one seed");
    if (document->firstError()) return *document->firstError();
    Result<MeshVerdict> verdict = judgeMesh(input.mesh, task);
    if (!verdict) return verdict.error();
    if (!verdict->isFit()) return Error{ErrorCode::Degenerate, verdict->findings[0].message};
    input.mesh = std::move(verdict->mesh);
    input.sources = std::move(verdict->sources);
    input.notes = std::move(verdict->findings);
    return input;
}

Result<std::string> solidFractureJson(const SolidFractureInput& input, const TaskContext& task) {
    const Result<SolidPartition> partition = cutSolid(input.mesh, input.seeds, task);
    if (!partition) return partition.error();
    const PointNames names(*partition, input.mesh);
    JsonWriter json(JsonLayout::Compact);
    json.openObject();
    json.rows("points", names.points(), [](Vec3 point) { return std::array{point.x, point.y, point.z}; });
    json.openArray("faces");
    for (std::uint32_t face = 0; face < partition->faces.size(); ++face)
        writeFace(json, input, *partition, face, names);
    json.close();
    json.openArray("fragments");
    for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) writeFragment(json, *partition, k);
    json.close();
    json.openArray("report");
    for (const MeshFinding& note : input.notes) {
        json.openObject();
        json.text("code", nameOf(note.kind));
        json.text("message", note.message);
        json.close();
    }
    for (const Diagnostic& report : seedReports(*partition)) writeFractureReport(json, report);
    json.close();
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
