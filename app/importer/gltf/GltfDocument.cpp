#include "app/importer/gltf/GltfDocument.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/files/MeshError.h"
#include "core/base/MessageText.h"
#include "core/base/Utf8.h"
#include "core/io/json/JsonDocument.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>

namespace rubble {
namespace {

std::string withoutStop(std::string sentence) {
    if (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

std::uint32_t numberOr(JsonValue value, std::uint32_t missing) { return value.isPresent() ? value.index() : missing; }
std::uint64_t sizeOr(JsonValue value, std::uint64_t missing) {
    return value.isPresent() ? value.wholeNumber() : missing;
}
GltfIndex indexOf(JsonValue value) { return value.isPresent() ? GltfIndex(value.index()) : std::nullopt; }
std::string textOr(JsonValue value, const char* missing) { return value.isPresent() ? value.text() : missing; }
std::string nameOf(JsonValue value) { return lineOf(textOr(value["name"], "")); }

/// The value of a path of keys; absent if one of them is.
JsonValue at(JsonValue value, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        if (value.isPresent()) value = value[key];
    return value;
}
JsonValue extensionOf(JsonValue owner, const char* name) { return at(owner, {"extensions", name}); }

/// A key that is required: missing is an error at its owner.
JsonValue required(JsonValue owner, const char* key) {
    const JsonValue value = owner[key];
    if (!value.isPresent()) owner.fail("the key \"" + std::string(key) + "\" is missing");
    return value;
}
std::uint32_t requiredIndex(JsonValue owner, const char* key) {
    const JsonValue value = required(owner, key);
    return value.isPresent() ? value.index() : 0;
}

template <class Read>
auto listOf(JsonValue value, Read read) {
    using List = decltype(value.list(read));
    return value.isPresent() ? value.list(read) : List();
}

GltfBuffer bufferOf(JsonValue value) {
    GltfBuffer buffer{.uri = std::nullopt, .size = sizeOr(value["byteLength"], 0)};
    if (value["uri"].isPresent()) buffer.uri = value["uri"].text();
    return buffer;
}

GltfView viewOf(JsonValue value) {
    GltfView view{.buffer = requiredIndex(value, "buffer"),
                  .offset = sizeOr(value["byteOffset"], 0),
                  .size = sizeOr(required(value, "byteLength"), 0),
                  .stride = numberOr(value["byteStride"], 0)};
    const JsonValue packed = extensionOf(value, "EXT_meshopt_compression");
    if (packed.isPresent())
        view.meshopt = GltfMeshopt{.buffer = requiredIndex(packed, "buffer"),
                                   .offset = sizeOr(packed["byteOffset"], 0),
                                   .size = sizeOr(packed["byteLength"], 0),
                                   .stride = requiredIndex(packed, "byteStride"),
                                   .count = requiredIndex(packed, "count"),
                                   .mode = textOr(packed["mode"], ""),
                                   .filter = textOr(packed["filter"], "NONE")};
    return view;
}

std::uint32_t componentsOf(JsonValue type) {
    constexpr std::array<std::string_view, 7> kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    constexpr std::array<std::uint32_t, 7> kComponents = {1, 2, 3, 4, 4, 9, 16};
    return type.isPresent() ? kComponents[type.oneOf(kTypes)] : 1;
}

GltfSparse sparseOf(JsonValue value) {
    const JsonValue indices = required(value, "indices"), values = required(value, "values");
    if (!indices.isPresent() || !values.isPresent()) return {};
    return {.count = requiredIndex(value, "count"),
            .indicesView = requiredIndex(indices, "bufferView"),
            .indicesType = requiredIndex(indices, "componentType"),
            .valuesView = requiredIndex(values, "bufferView"),
            .indicesOffset = sizeOr(indices["byteOffset"], 0),
            .valuesOffset = sizeOr(values["byteOffset"], 0)};
}

GltfAccessor accessorOf(JsonValue value) {
    GltfAccessor accessor{.view = indexOf(value["bufferView"]),
                          .offset = sizeOr(value["byteOffset"], 0),
                          .componentType = requiredIndex(value, "componentType"),
                          .components = componentsOf(required(value, "type")),
                          .count = requiredIndex(value, "count")};
    if (value["normalized"].isPresent()) accessor.isNormalized = value["normalized"].boolean();
    if (value["sparse"].isPresent()) accessor.sparse = sparseOf(value["sparse"]);
    return accessor;
}

GltfAttributes attributesOf(JsonValue value) {
    GltfAttributes attributes;
    constexpr std::array kKeys = {"POSITION", "TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2",  "TEXCOORD_3", "JOINTS_0",
                                  "JOINTS_1", "WEIGHTS_0",  "WEIGHTS_1",  "TRANSLATION", "ROTATION",   "SCALE"};
    if (!value.isPresent()) return attributes;
    for (const char* key : kKeys)
        if (value[key].isPresent()) attributes.emplace(key, value[key].index());
    return attributes;
}

GltfPrimitive primitiveOf(JsonValue value) {
    GltfPrimitive primitive{.attributes = attributesOf(value["attributes"]),
                            .indices = indexOf(value["indices"]),
                            .material = indexOf(value["material"]),
                            .mode = numberOr(value["mode"], 4)};
    primitive.targets = listOf(value["targets"], attributesOf);
    const JsonValue draco = extensionOf(value, "KHR_draco_mesh_compression");
    if (draco.isPresent())
        primitive.draco = GltfDraco{requiredIndex(draco, "bufferView"), attributesOf(draco["attributes"])};
    return primitive;
}

double numberIn(JsonValue value) { return value.number(); }

GltfMesh meshOf(JsonValue value) {
    return {.name = nameOf(value),
            .primitives = listOf(value["primitives"], primitiveOf),
            .weights = listOf(value["weights"], numberIn)};
}

glm::dmat4 transformOf(JsonValue node) {
    glm::dmat4 matrix(1.0);
    if (node["matrix"].isPresent()) {
        const auto numbers = node["matrix"].numbers<16>();
        for (int k = 0; k < 16; ++k) matrix[k / 4][k % 4] = numbers[static_cast<std::size_t>(k)];
        return matrix;
    }
    if (node["rotation"].isPresent()) {
        const auto [x, y, z, w] = node["rotation"].numbers<4>();
        const glm::dquat rotation(w, x, y, z);
        if (glm::length(rotation) > 0.0) matrix = glm::mat4_cast(glm::normalize(rotation));
    }
    if (node["scale"].isPresent()) {
        const auto scale = node["scale"].numbers<3>();
        for (int k = 0; k < 3; ++k) matrix[k] *= scale[static_cast<std::size_t>(k)];
    }
    if (node["translation"].isPresent()) {
        const auto [x, y, z] = node["translation"].numbers<3>();
        matrix[3] = {x, y, z, 1.0};
    }
    return matrix;
}

std::uint32_t indexIn(JsonValue value) { return value.index(); }

bool isVisible(JsonValue visibility) {
    const JsonValue visible = at(visibility, {"visible"});
    return !visible.isPresent() || visible.boolean();
}

GltfNode nodeOf(JsonValue value) {
    return {.name = nameOf(value),
            .mesh = indexOf(value["mesh"]),
            .skin = indexOf(value["skin"]),
            .children = listOf(value["children"], indexIn),
            .fromNode = transformOf(value),
            .weights = listOf(value["weights"], numberIn),
            .instances = attributesOf(at(extensionOf(value, "EXT_mesh_gpu_instancing"), {"attributes"})),
            .isVisible = isVisible(extensionOf(value, "KHR_node_visibility"))};
}

GltfSkin skinOf(JsonValue value) {
    return {.joints = listOf(value["joints"], indexIn), .inverseBindMatrices = indexOf(value["inverseBindMatrices"])};
}

GltfMaterial materialOf(JsonValue value) {
    GltfMaterial material{.name = nameOf(value)};
    const JsonValue metallic = value["pbrMetallicRoughness"];
    const JsonValue glossy = extensionOf(value, "KHR_materials_pbrSpecularGlossiness");
    const JsonValue colour = glossy.isPresent() ? glossy["diffuseFactor"] : at(metallic, {"baseColorFactor"});
    if (colour.isPresent()) {
        const auto numbers = colour.numbers<4>();
        for (int k = 0; k < 3; ++k) material.colour[k] = std::clamp(numbers[static_cast<std::size_t>(k)], 0.0, 1.0);
    }
    const JsonValue texture = glossy.isPresent() ? glossy["diffuseTexture"] : at(metallic, {"baseColorTexture"});
    if (!texture.isPresent()) return material;
    material.texture = indexOf(texture["index"]);
    material.uvSet = numberOr(texture["texCoord"], 0);
    const JsonValue transform = extensionOf(texture, "KHR_texture_transform");
    if (!transform.isPresent()) return material;
    material.uvSet = numberOr(transform["texCoord"], material.uvSet);
    if (transform["offset"].isPresent()) material.uvOffset = transform["offset"].point();
    if (transform["scale"].isPresent()) material.uvScale = transform["scale"].point();
    if (transform["rotation"].isPresent()) material.uvRotation = transform["rotation"].number();
    return material;
}

GltfIndex imageOfTexture(JsonValue value) { return indexOf(value["source"]); }

GltfImage imageOf(JsonValue value) {
    GltfImage image{.name = nameOf(value), .uri = std::nullopt, .view = indexOf(value["bufferView"])};
    if (value["uri"].isPresent()) image.uri = value["uri"].text();
    return image;
}

/// Returns whether an extension is read, or changes only what is not read.
bool isSupported(const std::string& extension) {
    constexpr std::array kRead = {"KHR_mesh_quantization",   "KHR_texture_transform",      "EXT_mesh_gpu_instancing",
                                  "EXT_meshopt_compression", "KHR_draco_mesh_compression", "KHR_node_visibility"};
    constexpr std::array kHarmless = {"KHR_materials_", "KHR_texture_", "EXT_texture_",  "MSFT_texture_",
                                      "KHR_lights_",    "KHR_xmp",      "KHR_technique", "KHR_animation_pointer"};
    const auto begins = [&](const char* start) { return extension.starts_with(start); };
    return std::ranges::find(kRead, extension) != kRead.end() || std::ranges::any_of(kHarmless, begins);
}

void checkHeader(JsonValue root) {
    const JsonValue version = at(root, {"asset", "version"});
    const std::string text = version.isPresent() ? version.text() : "2.0";
    if (!text.starts_with("2."))
        throw MeshError(ErrorCode::Unsupported,
                        "has version " + quotedName(excerptOf(text)) + " of glTF; export it as glTF 2.0");
    if (!root["extensionsRequired"].isPresent()) return;
    for (const JsonValue extension : root["extensionsRequired"].elements())
        if (const std::string name = extension.text(); !isSupported(name) && !name.empty())
            throw MeshError(ErrorCode::Unsupported,
                            "requires the glTF extension " + quotedName(name) + ", which is not supported");
}

/// The nodes of the scene that is shown; without scenes, all that are no children.
std::vector<std::uint32_t> rootsOf(JsonValue root, GltfDocument& document) {
    const auto scenes = listOf(root["scenes"], [](JsonValue scene) { return listOf(scene["nodes"], indexIn); });
    document.sceneCount = scenes.size();
    if (!scenes.empty()) {
        const std::uint32_t shown = numberOr(root["scene"], 0);
        if (shown < scenes.size()) return scenes[shown];
        root["scene"].fail("refers to scene " + std::to_string(shown) + " of " + std::to_string(scenes.size()));
        return {};
    }
    std::vector<bool> isChild(document.nodes.size(), false);
    for (const GltfNode& node : document.nodes)
        for (const std::uint32_t child : node.children)
            if (child < isChild.size()) isChild[child] = true;
    std::vector<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < isChild.size(); ++i)
        if (!isChild[i]) roots.push_back(i);
    return roots;
}

}  // namespace

GltfDocument readGltfDocument(std::string_view json) {
    // Latin-1 is not JSON, but is found.
    Result<JsonDocument> parsed = isUtf8(json) ? JsonDocument::parse(json) : JsonDocument::parse(lineOf(json));
    if (!parsed) throw MeshError(parsed.error().code, "cannot be read as glTF: " + withoutStop(parsed.error().message));
    const JsonValue root = parsed->root();
    checkHeader(root);
    GltfDocument document;
    document.buffers = listOf(root["buffers"], bufferOf);
    document.views = listOf(root["bufferViews"], viewOf);
    document.accessors = listOf(root["accessors"], accessorOf);
    document.meshes = listOf(root["meshes"], meshOf);
    document.nodes = listOf(root["nodes"], nodeOf);
    document.skins = listOf(root["skins"], skinOf);
    document.materials = listOf(root["materials"], materialOf);
    document.textures = listOf(root["textures"], imageOfTexture);
    document.images = listOf(root["images"], imageOf);
    document.roots = rootsOf(root, document);
    document.hasAnimations = root["animations"].isPresent() && root["animations"].elements().size() > 0;
    if (parsed->firstError())
        throw MeshError(ErrorCode::BadInput, "cannot be read as glTF: " + withoutStop(parsed->firstError()->message));
    return document;
}

}  // namespace rubble
