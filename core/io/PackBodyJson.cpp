#include "core/io/PackBodyJson.h"

#include "core/base/Assert.h"
#include "core/io/JsonText.h"
#include "core/io/PackText.h"

#include <utility>

namespace rubble {
namespace {

// The most characters that parts of a body take, with the commas and brackets about them.
constexpr std::size_t kVertexRoom = 3 * (kLongestNumberText + 1) + 2;
constexpr std::size_t kPlaneRoom = 4 * (kLongestNumberText + 1) + 2;
constexpr std::size_t kIndexRoom = 11;
constexpr std::size_t kHullRoom = 80;
constexpr std::size_t kBondRoom = 24 + kIndexRoom + kLongestNumberText;
constexpr std::size_t kBodyRoom = 200 + 20 * (kLongestNumberText + 1);

std::size_t roomFor(const Polytope& hull) {
    std::size_t corners = 0;
    for (const std::vector<std::uint32_t>& face : hull.faces) corners += face.size();
    const std::size_t indices = 2 * hull.edges.size() + corners + 2 * corners;  // edges, faces, signed edges
    return kHullRoom + kVertexRoom * hull.vertices.size() + kPlaneRoom * hull.faces.size() +
           (kIndexRoom + 3) * indices + 6 * hull.faces.size() + 3 * hull.edges.size();
}

std::size_t roomFor(const BodySource& body) {
    std::size_t room = kBodyRoom + 6 * (body.id.size() + body.name.size()) + kBondRoom * body.bonds.size();
    for (const Polytope& hull : body.hulls) room += roomFor(hull);
    return room;
}

void writeText(PackText& json, const std::string& text) {
    std::string quoted;
    appendJsonText(quoted, text);
    json.raw(quoted);
}

void writeVector(PackText& json, Vec3 vector) {
    json.raw('[');
    json.number(vector.x);
    json.raw(',');
    json.number(vector.y);
    json.raw(',');
    json.number(vector.z);
    json.raw(']');
}

void writeInertia(PackText& json, const Mat3& inertia, double density) {
    json.raw('[');
    for (int row = 0; row < 3; ++row) {
        if (row > 0) json.raw(',');
        writeVector(json, density * Vec3{inertia[0][row], inertia[1][row], inertia[2][row]});
    }
    json.raw(']');
}

void writePlane(PackText& json, const Plane& plane) {
    json.raw('[');
    json.number(plane.normal.x);
    json.raw(',');
    json.number(plane.normal.y);
    json.raw(',');
    json.number(plane.normal.z);
    json.raw(',');
    json.number(plane.offset);
    json.raw(']');
}

void writePair(PackText& json, std::uint32_t first, std::string_view sign, std::uint32_t second) {
    json.raw('[');
    json.index(first);
    json.raw(sign);
    json.index(second);
    json.raw(']');
}

/// The loops begin where the signed edges do, so that both forms run side by side.
void writeHull(PackText& json, const Polytope& hull) {
    const std::vector<std::vector<SignedEdge>> loops = signedEdgeLoops(hull);
    json.raw("{\"vertices\":");
    json.list(hull.vertices, [&](const Vec3& vertex) { writeVector(json, vertex); });
    json.raw(",\"edges\":");
    json.list(hull.edges, [&](const auto& edge) { writePair(json, edge[0], ",", edge[1]); });
    json.raw(",\"faces\":");
    json.list(loops, [&](const std::vector<SignedEdge>& loop) {
        json.list(loop, [&](SignedEdge step) { json.index(hull.edges[step.edge][step.sign > 0 ? 0 : 1]); });
    });
    json.raw(",\"signedEdges\":");
    json.list(loops, [&](const std::vector<SignedEdge>& loop) {
        json.list(loop, [&](SignedEdge step) { writePair(json, step.edge, step.sign > 0 ? "," : ",-", 1); });
    });
    json.raw(",\"planes\":");
    json.list(hull.planes, [&](const Plane& plane) { writePlane(json, plane); });
    json.raw('}');
}

void writeBody(PackText& json, const BodySource& body, double density) {
    json.raw("{\"id\":");
    writeText(json, body.id);
    json.raw(",\"name\":");
    writeText(json, body.name);
    json.raw(",\"parent\":");
    if (body.parent == kNone) {
        json.raw("null");
    } else {
        json.index(body.parent);
    }
    json.raw(",\"offset\":");
    writeVector(json, body.offset);
    json.raw(",\"volume\":");
    json.number(body.mass.volume);
    json.raw(",\"mass\":");
    json.number(density * body.mass.volume);
    json.raw(",\"centreOfMass\":");
    writeVector(json, {0.0, 0.0, 0.0});
    json.raw(",\"inertia\":");
    writeInertia(json, body.mass.inertia, density);
    json.raw(",\"neighbours\":");
    json.list(body.bonds, [&](const Bond& bond) {
        json.raw("{\"fragment\":");
        json.index(body.firstSibling + bond.fragment);
        json.raw(",\"area\":");
        json.number(bond.area);
        json.raw('}');
    });
    json.raw(",\"hulls\":");
    json.list(body.hulls, [&](const Polytope& hull) { writeHull(json, hull); });
    json.raw('}');
}

}  // namespace

TextBlock bodiesJson(std::span<const BodySource> bodies, double density) {
    std::size_t room = 0;
    for (const BodySource& body : bodies) room += roomFor(body) + 2;
    auto memory = std::make_unique_for_overwrite<char[]>(room);
    PackText json(memory.get());
    for (const BodySource& body : bodies) {
        if (&body != bodies.data()) json.raw(",\n");
        writeBody(json, body, density);
    }
    const auto size = static_cast<std::size_t>(json.end() - memory.get());
    RUBBLE_ASSERT(size <= room);
    return {std::move(memory), size};
}

}  // namespace rubble
