#include "core/io/json/VectorJson.h"
#include "core/io/pack/PackBondingJson.h"
#include "core/io/pack/PackFile.h"
#include "core/io/pack/PackFormat.h"

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

PackHull readHull(const JsonValue& value) {
    value.requireObject({"vertices", "edges", "faces", "signedEdges", "planes"});
    const auto readLoop = [](const JsonValue& loop) { return loop.list(readSignedEdge); };
    return {.polytope = {.vertices = value["vertices"].list(readVector),
                         .edges = value["edges"].list(readEdge),
                         .faces = value["faces"].list(readIndices),
                         .planes = value["planes"].list(readPlane)},
            .signedEdges = value["signedEdges"].list(readLoop)};
}

Mat3 readInertia(const JsonValue& value) {
    const std::vector<Vec3> rows = value.list(readVector);
    if (rows.size() == 3) return glm::transpose(Mat3(rows[0], rows[1], rows[2]));
    value.fail("expected an array of 3 rows");
    return Mat3{0.0};
}

FragmentContact readNeighbour(const JsonValue& value) {
    value.requireObject({"fragment", "area"});
    return {.fragment = value["fragment"].index(0, kNone - 1), .area = value["area"].number(above(0.0))};
}

PackBody readPackBody(const JsonValue& value) {
    value.requireObject(
        {"id", "name", "parent", "offset", "volume", "mass", "centreOfMass", "inertia", "neighbours", "hulls"},
        {"threshold", "gap", "lostMass"});
    const JsonValue threshold = value["threshold"], gap = value["gap"], lostMass = value["lostMass"];
    return {.id = value["id"].text(),
            .name = value["name"].text(),
            .parent = readOptionalIndex(value["parent"]),
            .offset = readVector(value["offset"]),
            .volume = value["volume"].number(above(0.0)),
            .mass = value["mass"].number(above(0.0)),
            .centreOfMass = readVector(value["centreOfMass"]),
            .inertia = readInertia(value["inertia"]),
            .neighbours = value["neighbours"].list(readNeighbour),
            .threshold = threshold.isPresent() ? std::optional(threshold.number(above(0.0))) : std::nullopt,
            .gap = gap.isPresent() ? gap.number(above(0.0)) : 0.0,
            .lostMass = lostMass.isPresent() ? lostMass.number(atLeast(0.0)) : 0.0,
            .hulls = value["hulls"].list(readHull)};
}

Colour readUnitColour(const JsonValue& value) {
    const auto [red, green, blue] = value.numbers<3>(between(0.0, 1.0));
    return {red, green, blue};
}

Material readPackMaterial(const JsonValue& value) {
    value.requireObject({"name", "density", "friction", "restitution", "outside", "inside"});
    return {.name = value["name"].text(),
            .density = value["density"].number(above(0.0)),
            .friction = value["friction"].number(atLeast(0.0)),
            .restitution = value["restitution"].number(between(0.0, 1.0)),
            .outside = readUnitColour(value["outside"]),
            .inside = readUnitColour(value["inside"])};
}

PackMeshFile readMesh(const JsonValue& value) {
    value.requireObject({"file", "bodies", "fragment", "place"});
    return {.name = value["file"].text(),
            .bodies = static_cast<PackMeshBodies>(value["bodies"].oneOf(kMeshBodies)),
            .fragment = readOptionalIndex(value["fragment"]),
            .place = static_cast<PartPlacement>(value["place"].oneOf(kMeshPlaces))};
}

/// Requires that the values of keys are the only words that this version supports.
void requireWords(const JsonValue& value, std::initializer_list<std::array<std::string_view, 2>> words) {
    for (const auto& [key, word] : words) {
        if (value[key].isPresent()) value[key].oneOf(std::array{word});
    }
}

Pack readPackVersion1(const JsonValue& root) {
    root.requireObject({"format", "version", "units", "axes", "asset", "hash", "threshold", "material", "meshes",
                        "whole", "fragments"},
                       {"checksum", "bonding"});
    const JsonValue checksum = root["checksum"], bonding = root["bonding"];
    root["units"].requireObject({"length", "mass", "time"});
    requireWords(root["units"], {{"length", "m"}, {"mass", "kg"}, {"time", "s"}});
    root["axes"].requireObject({"handedness", "up", "front"});
    requireWords(root["axes"], {{"handedness", "right"}, {"up", "y"}, {"front", "counter-clockwise"}});
    root["asset"].requireObject({"id", "name"}, {"gap"});
    const JsonValue gap = root["asset"]["gap"];
    return {.asset = root["asset"]["id"].index(),
            .name = root["asset"]["name"].text(),
            .gap = gap.isPresent() ? gap.number(above(0.0)) : 0.0,
            .hash = root["hash"].text(),
            .checksum = checksum.isPresent() ? checksum.text() : std::string(),
            .threshold = root["threshold"].number(above(0.0)),
            .material = readPackMaterial(root["material"]),
            .meshes = root["meshes"].list(readMesh),
            .whole = readPackBody(root["whole"]),
            .fragments = root["fragments"].list(readPackBody),
            .bonding = bonding.isPresent() ? std::optional(readPackBonding(bonding)) : std::nullopt};
}

}  // namespace

Result<Pack> readPack(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    const Result<std::uint32_t> version = versionOf(*document, kPackFormat);
    if (!version) return version.error();
    Pack pack = readPackVersion1(document->root());
    if (document->firstError()) return *document->firstError();
    return pack;
}

}  // namespace rubble
