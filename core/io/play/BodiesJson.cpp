#include "core/io/play/BodiesJson.h"

#include "core/geometry/hull/ConvexHull.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/VectorJson.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace rubble {
namespace {

// In the order of their enumerators.
constexpr std::array<std::string_view, 3> kKinds{"static", "kinematic", "dynamic"};
// What other programs write for numbers that are not finite, which JSON does not have.
constexpr std::array<std::string_view, 5> kNotFinite{"NaN", "nan", "-Infinity", "Infinity", "inf"};

using Hulls = std::vector<std::vector<Vec3>>;

/// Puts NaN and infinity in quotes, so that reading them as numbers fails with their path.
std::string withNotFiniteQuoted(std::string_view json) {
    std::string text;
    bool isInString = false;
    for (std::size_t at = 0; at < json.size(); ++at) {
        if (json[at] == '"') isInString = !isInString;
        if (isInString && json[at] == '\\' && at + 1 < json.size()) text += json[at++];
        const auto word = std::ranges::find_if(
            kNotFinite, [&](std::string_view each) { return !isInString && json.substr(at).starts_with(each); });
        if (word == kNotFinite.end()) {
            text += json[at];
        } else {
            text.append("\"").append(*word).append("\"");
            at += word->size() - 1;
        }
    }
    return text;
}

Result<JsonDocument> parse(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (document || document.error().code != ErrorCode::BadInput) return document;
    Result<JsonDocument> quoted = JsonDocument::parse(withNotFiniteQuoted(json));
    return quoted ? std::move(quoted) : std::move(document);
}

/// The hulls of all bodies; equal lists of points share a shape.
class ShapeLibrary {
public:
    /// Returns the index of the shape of these points.
    Result<std::uint32_t> shapeOf(const Hulls& hulls) {
        const auto [place, isNew] =
            m_indices.try_emplace(flattened(hulls), static_cast<std::uint32_t>(m_shapes.size()));
        if (!isNew) return place->second;
        std::vector<Polytope> polytopes;
        for (std::size_t k = 0; k < hulls.size(); ++k) {
            Result<Polytope> polytope = convexHull(hulls[k]);
            if (!polytope) {
                return Error{polytope.error().code, "hull " + std::to_string(k) + ": " + polytope.error().message};
            }
            polytopes.push_back(std::move(*polytope));
        }
        m_shapes.push_back(std::move(polytopes));
        return place->second;
    }
    std::vector<std::vector<Polytope>> shapes() && { return std::move(m_shapes); }

private:
    static std::vector<double> flattened(const Hulls& hulls) {
        std::vector<double> numbers;
        for (const std::vector<Vec3>& hull : hulls) {
            numbers.push_back(static_cast<double>(hull.size()));
            for (const Vec3& point : hull) numbers.insert(numbers.end(), {point.x, point.y, point.z});
        }
        return numbers;
    }

    std::map<std::vector<double>, std::uint32_t> m_indices;
    std::vector<std::vector<Polytope>> m_shapes;
};

std::vector<Vec3> readPoints(const JsonValue& value) { return value.list(readVector); }

Pose readPose(const JsonValue& body) {
    Pose pose;
    if (body["position"].isPresent()) pose.position = readVector(body["position"]);
    if (body["orientation"].isPresent()) {
        const auto [w, x, y, z] = body["orientation"].numbers<4>();
        pose.orientation = Quat{w, x, y, z};
    }
    return pose;
}

/// Reads all members but the hulls.
SceneBody readSceneBody(const JsonValue& value) {
    SceneBody body;
    if (value.isObject() && value["name"].isPresent()) body.name = value["name"].text();
    value.requireObject({"name", "hulls"}, {"kind", "density", "friction", "restitution", "position", "orientation",
                                            "velocity", "angularVelocity"});
    if (!value.isObject()) return body;
    const auto readNumber = [&](const char* key, double& number) {
        if (value[key].isPresent()) number = value[key].number();
    };
    if (value["kind"].isPresent()) body.kind = static_cast<BodyKind>(value["kind"].oneOf(kKinds));
    readNumber("density", body.density);
    readNumber("friction", body.friction);
    readNumber("restitution", body.restitution);
    body.pose = readPose(value);
    if (value["velocity"].isPresent()) body.velocity = readVector(value["velocity"]);
    if (value["angularVelocity"].isPresent()) body.angularVelocity = readVector(value["angularVelocity"]);
    return body;
}

Error withBodyName(const SceneBody& body, const Error& error) {
    if (body.name.empty()) return error;
    return {error.code, "Body \"" + body.name + "\": " + error.message};
}

Result<BodyScene> readScene(JsonDocument& document) {
    const JsonValue root = document.root();
    if (root.isObject() && root["format"].isPresent()) {
        return Error{ErrorCode::Unsupported,
                     "The document has a format, such as a project, and is not a scene of bodies."};
    }
    root.requireObject({"bodies"}, {"gravity"});
    if (document.firstError()) return *document.firstError();
    BodyScene scene;
    if (root["gravity"].isPresent()) scene.gravity = readVector(root["gravity"]);
    ShapeLibrary shapes;
    for (const JsonValue value : root["bodies"].elements()) {
        SceneBody body = readSceneBody(value);
        const Hulls hulls = document.firstError() ? Hulls() : value["hulls"].list(readPoints);
        if (document.firstError()) return withBodyName(body, *document.firstError());
        const Result<std::uint32_t> shape = shapes.shapeOf(hulls);
        if (!shape) return withBodyName(body, shape.error());
        body.shape = *shape;
        scene.bodies.push_back(std::move(body));
    }
    if (document.firstError()) return *document.firstError();
    scene.shapes = std::move(shapes).shapes();
    return scene;
}

}  // namespace

Result<BodyScene> readBodyScene(std::string_view json) {
    Result<JsonDocument> document = parse(json);
    if (!document) return document.error();
    Result<BodyScene> scene = readScene(*document);
    if (!scene) return scene;
    if (const auto error = verifyBodyScene(*scene)) return Error{ErrorCode::BadInput, *error};
    return scene;
}

}  // namespace rubble
