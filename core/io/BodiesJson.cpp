#include "core/io/BodiesJson.h"

#include "core/geometry/ConvexHull.h"
#include "core/io/JsonReading.h"
#include "core/io/SceneJson.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace rubble {
namespace {

// In the order of their enumerators.
constexpr std::array<std::string_view, 3> kKinds{"static", "kinematic", "dynamic"};
// What other programs write for numbers that JSON does not have.
constexpr std::array<std::string_view, 5> kNoNumbers{"NaN", "nan", "-Infinity", "Infinity", "inf"};

using Hulls = std::vector<std::vector<Vec3>>;

/// The text with NaN and its like in quotes, so that the place where they stand can be told.
std::string withNoNumbersQuoted(std::string_view json) {
    std::string text;
    bool isInText = false;
    for (std::size_t at = 0; at < json.size(); ++at) {
        if (json[at] == '"') isInText = !isInText;
        if (isInText && json[at] == '\\' && at + 1 < json.size()) text += json[at++];
        const auto word = std::ranges::find_if(
            kNoNumbers, [&](std::string_view each) { return !isInText && json.substr(at).starts_with(each); });
        if (word == kNoNumbers.end()) {
            text += json[at];
        } else {
            text.append("\"").append(*word).append("\"");
            at += word->size() - 1;
        }
    }
    return text;
}

Result<JsonDocument> parsed(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (document || document.error().code != ErrorCode::BadInput) return document;
    Result<JsonDocument> quoted = JsonDocument::parse(withNoNumbersQuoted(json));
    return quoted ? std::move(quoted) : std::move(document);
}

/// The polytopes of all bodies, each list of points once.
class ShapeLibrary {
public:
    /// The index of the shape around these points.
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
    std::vector<std::vector<Polytope>> taken() && { return std::move(m_shapes); }

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

std::vector<Vec3> readPoints(const JsonValue& value) { return value.listOf(readVector); }

Pose readPose(const JsonValue& body) {
    Pose pose;
    if (body["position"].isPresent()) pose.position = readVector(body["position"]);
    if (body["orientation"].isPresent()) {
        const auto [w, x, y, z] = body["orientation"].numbers<4>();
        pose.orientation = Quat{w, x, y, z};
    }
    return pose;
}

/// All but the shape.
SceneBody readBody(const JsonValue& value) {
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

Error about(const SceneBody& body, const Error& error) {
    if (body.name.empty()) return error;
    return {error.code, "Body \"" + body.name + "\": " + error.message};
}

Result<BodyScene> readScene(JsonDocument& document) {
    const JsonValue root = document.root();
    if (root.isObject() && root["format"].isPresent()) {
        return Error{ErrorCode::Unsupported,
                     "The document is a project, or another file with a format, not plain bodies."};
    }
    root.requireObject({"bodies"}, {"gravity"});
    if (document.fault()) return *document.fault();
    BodyScene scene;
    if (root["gravity"].isPresent()) scene.gravity = readVector(root["gravity"]);
    ShapeLibrary shapes;
    for (const JsonValue value : root["bodies"].elements()) {
        SceneBody body = readBody(value);
        const Hulls hulls = document.fault() ? Hulls() : value["hulls"].listOf(readPoints);
        if (document.fault()) return about(body, *document.fault());
        const Result<std::uint32_t> shape = shapes.shapeOf(hulls);
        if (!shape) return about(body, shape.error());
        body.shape = *shape;
        scene.bodies.push_back(std::move(body));
    }
    if (document.fault()) return *document.fault();
    scene.shapes = std::move(shapes).taken();
    return scene;
}

}  // namespace

Result<BodyScene> readBodyScene(std::string_view json) {
    Result<JsonDocument> document = parsed(json);
    if (!document) return document.error();
    Result<BodyScene> scene = readScene(*document);
    if (!scene) return scene;
    if (const auto fault = verifyBodyScene(*scene)) return Error{ErrorCode::BadInput, *fault};
    return scene;
}

}  // namespace rubble
