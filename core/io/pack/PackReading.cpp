#include "core/geometry/hull/PolytopeTopology.h"
#include "core/io/json/VectorJson.h"
#include "core/io/pack/PackFile.h"
#include "core/io/pack/PackFormat.h"
#include "core/io/pack/PackHeaderJson.h"

namespace rubble {
namespace {

/// Reads an index; null becomes kNone.
std::uint32_t readOptionalIndex(const JsonValue& value) { return value.isNull() ? kNone : value.index(0, kNone - 1); }

std::vector<std::uint32_t> readIndices(const JsonValue& value) {
    return value.list([](const JsonValue& element) { return element.index(); });
}

std::array<std::uint32_t, 2> readEdge(const JsonValue& value) {
    const std::vector<std::uint32_t> ends = readIndices(value);
    if (ends.size() == 2) return {ends[0], ends[1]};
    value.fail("expected an array of 2 vertices");
    return {};
}

SignedEdge readSignedEdge(const JsonValue& value) {
    const JsonElements elements = value.elements();
    if (elements.size() != 2) value.fail("expected an array of an edge and a sign");
    auto element = elements.begin();
    const std::uint32_t edge = (*element).index();
    if (elements.size() == 2) ++element;
    const double sign = (*element).number();
    if (sign != 1.0 && sign != -1.0) (*element).fail("expected 1 or -1");
    return {edge, sign > 0.0 ? 1 : -1};
}

Plane readPlane(const JsonValue& value) {
    const auto [x, y, z, offset] = value.numbers<4>();
    return {{x, y, z}, offset};
}

/// Adds what follows from the faces; what they are faulty for is left to verifyPack().
void deriveTopology(PackHull& hull) {
    std::optional<Polytope> derived = polytopeOf(hull.polytope.vertices, hull.polytope.faces);
    if (!derived) return;
    hull.polytope = std::move(*derived);
    hull.signedEdges = signedEdgeLoops(hull.polytope);
}

PackHull readHull(const JsonValue& value) {
    value.requireKeys({"vertices", "faces"});
    const JsonValue edges = value["edges"], planes = value["planes"], inset = value["inset"];
    const JsonValue signedEdges = value["signedEdges"];
    const auto readLoop = [](const JsonValue& loop) { return loop.list(readSignedEdge); };
    PackHull hull;
    hull.polytope.vertices = value["vertices"].list(readVector);
    hull.polytope.faces = value["faces"].list(readIndices);
    if (edges.isPresent()) hull.polytope.edges = edges.list(readEdge);
    if (planes.isPresent()) hull.polytope.planes = planes.list(readPlane);
    if (signedEdges.isPresent()) hull.signedEdges = signedEdges.list(readLoop);
    if (inset.isPresent()) hull.inset = inset.number(above(0.0));
    const int derived = edges.isPresent() + planes.isPresent() + signedEdges.isPresent();
    if (derived == 0) deriveTopology(hull);
    if (derived == 1 || derived == 2) value.fail("expected edges, signed edges and planes, or none of them");
    return hull;
}

Mat3 readInertia(const JsonValue& value) {
    const std::vector<Vec3> rows = value.list(readVector);
    if (rows.size() == 3) return glm::transpose(Mat3(rows[0], rows[1], rows[2]));
    value.fail("expected an array of 3 rows");
    return Mat3{0.0};
}

PrincipalInertia readPrincipal(const JsonValue& value) {
    value.requireKeys({"moments", "rotation"});
    const auto [x, y, z, w] = value["rotation"].numbers<4>();
    return {readVector(value["moments"]), Quat(w, x, y, z)};
}

PackBounds readBounds(const JsonValue& value) {
    value.requireKeys({"min", "max", "radius", "thinnest"});
    return {.min = readVector(value["min"]),
            .max = readVector(value["max"]),
            .radius = value["radius"].number(above(0.0)),
            .thinnest = value["thinnest"].number(above(0.0))};
}

PackNeighbour readNeighbour(const JsonValue& value) {
    value.requireKeys({"fragment", "area"});
    const JsonValue centroid = value["centroid"], normal = value["normal"];
    PackNeighbour neighbour{.fragment = value["fragment"].index(0, kNone - 1),
                            .area = value["area"].number(above(0.0))};
    if (centroid.isPresent()) neighbour.centroid = readVector(centroid);
    if (normal.isPresent()) neighbour.normal = readVector(normal);
    return neighbour;
}

PackBody readPackBody(const JsonValue& value, std::uint32_t version) {
    value.requireKeys(
        {"id", "name", "parent", "offset", "volume", "mass", "centreOfMass", "inertia", "neighbours", "hulls"});
    const JsonValue threshold = value["threshold"], gap = value["gap"], lostMass = value["lostMass"];
    PackBody body{.id = value["id"].text(),
                  .name = value["name"].text(),
                  .parent = readOptionalIndex(value["parent"]),
                  .offset = readVector(value["offset"]),
                  .volume = value["volume"].number(above(0.0)),
                  .mass = value["mass"].number(above(0.0)),
                  .centreOfMass = readVector(value["centreOfMass"]),
                  .inertia = readInertia(value["inertia"]),
                  .neighbours = value["neighbours"].list(readNeighbour),
                  .gap = gap.isPresent() ? gap.number(above(0.0)) : 0.0,
                  .lostMass = lostMass.isPresent() ? lostMass.number(atLeast(0.0)) : 0.0,
                  .hulls = value["hulls"].list(readHull)};
    if (threshold.isPresent()) body.threshold = threshold.number(above(0.0));
    if (version < 2) return body;
    value.requireKeys({"level", "childCount", "principal", "bounds"});
    const JsonValue firstChild = value["firstChild"];
    body.level = value["level"].index();
    body.childCount = value["childCount"].index();
    if (firstChild.isPresent()) body.firstChild = firstChild.index(0, kNone - 1);
    body.principal = readPrincipal(value["principal"]);
    body.bounds = readBounds(value["bounds"]);
    return body;
}

}  // namespace

Result<Pack> readPack(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    const Result<std::uint32_t> version = versionOf(*document, kPackFormat);
    if (!version) return version.error();
    const JsonValue root = document->root();
    Pack pack = readPackHeader(root, *version);
    root.requireKeys({"whole", "fragments"});
    const auto readBody = [&](const JsonValue& value) { return readPackBody(value, *version); };
    pack.whole = readBody(root["whole"]);
    pack.fragments = root["fragments"].list(readBody);
    if (document->firstError()) return *document->firstError();
    return pack;
}

}  // namespace rubble
