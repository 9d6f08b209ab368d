#include "core/io/pack/PackBodyJson.h"

#include "core/io/json/VectorJson.h"

#include <ranges>

namespace rubble {
namespace {

void writeInertia(JsonWriter& json, const PackBody& body) {
    const Mat3& inertia = body.inertia;
    json.rows("inertia", std::array{0, 1, 2}, [&](int row) {
        return std::array{inertia[0][row], inertia[1][row], inertia[2][row]};
    });
    if (!body.principal) return;
    const Quat& rotation = body.principal->rotation;
    json.openObject("principal");
    writeVector(json, "moments", body.principal->moments);
    json.numbers("rotation", {rotation.x, rotation.y, rotation.z, rotation.w});
    json.close();
}

void writeBounds(JsonWriter& json, const PackBounds& bounds) {
    json.openObject("bounds");
    writeVector(json, "min", bounds.min);
    writeVector(json, "max", bounds.max);
    json.number("radius", bounds.radius);
    json.number("thinnest", bounds.thinnest);
    json.close();
}

void writeNeighbour(JsonWriter& json, const PackNeighbour& neighbour) {
    json.openObject();
    json.wholeNumber("fragment", std::uint64_t{neighbour.fragment});
    json.number("area", neighbour.area);
    if (neighbour.centroid) writeVector(json, "centroid", *neighbour.centroid);
    if (neighbour.normal) writeVector(json, "normal", *neighbour.normal);
    json.close();
}

/// Writes the faces as loops of vertices.
void writeFaces(JsonWriter& json, const Polytope& hull, const std::vector<std::vector<SignedEdge>>& loops) {
    json.rows("faces", loops, [&](const std::vector<SignedEdge>& loop) {
        return std::views::transform(
            loop, [&](SignedEdge step) -> std::int64_t { return hull.edges[step.edge][step.sign > 0 ? 0 : 1]; });
    });
}

void writeSignedEdges(JsonWriter& json, const std::vector<std::vector<SignedEdge>>& loops) {
    json.openArray("signedEdges");
    for (const std::vector<SignedEdge>& loop : loops) {
        json.rows({}, loop, [](SignedEdge step) { return std::array<std::int64_t, 2>{step.edge, step.sign}; });
    }
    json.close();
}

void writeHull(JsonWriter& json, const PackHull& hull, PackTopology topology) {
    const Polytope& polytope = hull.polytope;
    // Both kinds of loops start with the same edge, so that they are parallel.
    const std::vector<std::vector<SignedEdge>> loops = signedEdgeLoops(polytope);
    json.openObject();
    json.rows("vertices", polytope.vertices, [](Vec3 vertex) { return std::array{vertex.x, vertex.y, vertex.z}; });
    const bool isFull = topology == PackTopology::Full;
    if (isFull)
        json.rows("edges", polytope.edges, [](const auto& edge) {
            return std::array<std::int64_t, 2>{edge[0], edge[1]};
        });
    writeFaces(json, polytope, loops);
    if (isFull) writeSignedEdges(json, loops);
    if (isFull)
        json.rows("planes", polytope.planes, [](const Plane& plane) {
            return std::array{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
        });
    if (hull.inset > 0.0) json.number("inset", hull.inset);
    json.close();
}

}  // namespace

void writePackBody(JsonWriter& json, std::string_view key, const PackBody& body, PackTopology topology) {
    json.openObject(key);
    json.text("id", body.id);
    json.text("name", body.name);
    json.wholeNumber("parent", body.parent == kNone ? std::nullopt : std::optional{body.parent});
    json.wholeNumber("level", std::uint64_t{body.level});
    if (body.childCount > 0) json.wholeNumber("firstChild", std::uint64_t{body.firstChild});
    json.wholeNumber("childCount", std::uint64_t{body.childCount});
    writeVector(json, "offset", body.offset);
    json.number("volume", body.volume);
    json.number("mass", body.mass);
    writeVector(json, "centreOfMass", body.centreOfMass);
    writeInertia(json, body);
    if (body.bounds) writeBounds(json, *body.bounds);
    if (body.threshold) json.number("threshold", *body.threshold);
    if (body.gap > 0.0) json.number("gap", body.gap);
    if (body.gap > 0.0) json.number("lostMass", body.lostMass);
    json.openArray("neighbours");
    for (const PackNeighbour& neighbour : body.neighbours) writeNeighbour(json, neighbour);
    json.close();
    json.openArray("hulls");
    for (const PackHull& hull : body.hulls) writeHull(json, hull, topology);
    json.close();
    json.close();
}

std::size_t packBodySize(const PackBody& body) {
    std::size_t size = 1024 + 120 * body.neighbours.size();
    for (const PackHull& hull : body.hulls) {
        const Polytope& polytope = hull.polytope;
        size += 80 + 64 * polytope.vertices.size() + 84 * polytope.planes.size() + 32 * polytope.edges.size();
    }
    return size;
}

}  // namespace rubble
