#include "core/io/pack/PackBodyJson.h"

#include "core/io/json/VectorJson.h"

#include <ranges>

namespace rubble {
namespace {

void writeInertia(JsonWriter& json, const Mat3& inertia, double density) {
    json.rows("inertia", std::array{0, 1, 2}, [&](int row) {
        return std::array{density * inertia[0][row], density * inertia[1][row], density * inertia[2][row]};
    });
}

/// Writes the faces as loops of vertices and of signed edges. Both start with the same edge, so that they are parallel.
void writeFaces(JsonWriter& json, const Polytope& hull) {
    const std::vector<std::vector<SignedEdge>> loops = signedEdgeLoops(hull);
    json.rows("faces", loops, [&](const std::vector<SignedEdge>& loop) {
        return std::views::transform(
            loop, [&](SignedEdge step) -> std::int64_t { return hull.edges[step.edge][step.sign > 0 ? 0 : 1]; });
    });
    json.openArray("signedEdges");
    for (const std::vector<SignedEdge>& loop : loops) {
        json.rows({}, loop, [](SignedEdge step) { return std::array<std::int64_t, 2>{step.edge, step.sign}; });
    }
    json.close();
}

void writeHull(JsonWriter& json, const Polytope& hull) {
    json.openObject();
    json.rows("vertices", hull.vertices, [](Vec3 vertex) { return std::array{vertex.x, vertex.y, vertex.z}; });
    json.rows("edges", hull.edges, [](const auto& edge) { return std::array<std::int64_t, 2>{edge[0], edge[1]}; });
    writeFaces(json, hull);
    json.rows("planes", hull.planes, [](const Plane& plane) {
        return std::array{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
    });
    json.close();
}

}  // namespace

void writePackBody(JsonWriter& json, std::string_view key, const PackBodySource& body, double density) {
    json.openObject(key);
    json.text("id", body.id);
    json.text("name", body.name);
    json.wholeNumber("parent", body.parent == kNone ? std::nullopt : std::optional{body.parent});
    writeVector(json, "offset", body.offset);
    json.number("volume", body.mass.volume);
    json.number("mass", density * body.mass.volume);
    writeVector(json, "centreOfMass", {0.0, 0.0, 0.0});
    writeInertia(json, body.mass.inertia, density);
    if (body.threshold) json.number("threshold", *body.threshold);
    if (body.gap > 0.0) {
        json.number("gap", body.gap);
        json.number("lostMass", density * body.lostVolume);
    }
    json.openArray("neighbours");
    for (const FragmentContact& contact : body.contacts) {
        json.openObject();
        json.wholeNumber("fragment", std::uint64_t{body.firstSibling + contact.fragment});
        json.number("area", contact.area);
        json.close();
    }
    json.close();
    json.openArray("hulls");
    for (const Polytope& hull : body.hulls) writeHull(json, hull);
    json.close();
    json.close();
}

std::size_t packBodySize(const PackBodySource& body) {
    std::size_t size = 512 + 48 * body.contacts.size();
    for (const Polytope& hull : body.hulls) {
        size += 80 + 64 * hull.vertices.size() + 84 * hull.planes.size() + 32 * hull.edges.size();
    }
    return size;
}

}  // namespace rubble
