#include "core/io/exchange/GlbJson.h"

#include "core/io/exchange/GlbConstants.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/json/VectorJson.h"

namespace rubble {
namespace {

// Views of hulls, behind those of the four arrays of meshes.
constexpr std::uint64_t kHullPositionView = 4;
constexpr std::uint64_t kHullIndexView = 5;

/// The view of the image, behind those of the arrays.
std::uint64_t imageView(const GlbBuffer& buffer) { return buffer.hulls().empty() ? 4 : 6; }

void writeNodes(JsonWriter& json, std::span<const MeshPart> parts, PartPlacement place) {
    json.wholeNumber("scene", std::uint64_t{0});
    json.openArray("scenes");
    json.openObject();
    json.openArray("nodes");
    for (std::size_t node = 0; node < parts.size(); ++node) json.wholeNumber({}, std::uint64_t{node});
    json.close();
    json.close();
    json.close();
    json.openArray("nodes");
    std::uint64_t mesh = 0;
    for (const MeshPart& part : parts) {
        json.openObject();
        json.text("name", part.name);
        json.wholeNumber("mesh", mesh++);
        if (place == PartPlacement::Assembled) writeVector(json, "translation", part.offset);
        json.close();
    }
    json.close();
}

/// Writes a primitive, whose four accessors start at `accessor`.
void writePrimitive(JsonWriter& json, const GlbPrimitive& primitive, std::uint64_t accessor, std::size_t inside) {
    json.openObject();
    json.openObject("attributes");
    json.wholeNumber("POSITION", accessor);
    json.wholeNumber("NORMAL", accessor + 1);
    json.wholeNumber("TEXCOORD_0", accessor + 2);
    json.close();
    json.wholeNumber("indices", accessor + 3);
    const bool isInside = primitive.material == GlbBuffer::kInside;
    json.wholeNumber("material", std::uint64_t{isInside ? inside : primitive.material});
    json.close();
}

void writeMeshes(JsonWriter& json, std::span<const MeshPart> parts,
                 std::span<const std::vector<GlbPrimitive>> primitives, const MeshMaterials& materials,
                 const GlbPhysics* physics) {
    json.openArray("meshes");
    std::uint64_t accessor = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        json.openObject();
        json.text("name", parts[k].name);
        json.openArray("primitives");
        for (const GlbPrimitive& primitive : primitives[k]) {
            writePrimitive(json, primitive, accessor, materials.outside.size());
            accessor += 4;
        }
        json.close();
        json.close();
    }
    if (physics != nullptr) writeHullMeshes(json, parts, *physics, accessor);
    json.close();
}

void writeGlbMaterial(JsonWriter& json, const MeshMaterial& material) {
    const Vec3 colour = linearColour(material.colour);
    const bool isTransparent = material.opacity < 1.0;
    json.openObject();
    json.text("name", material.name);
    json.openObject("pbrMetallicRoughness");
    json.numbers("baseColorFactor", {colour.x, colour.y, colour.z, material.opacity});
    json.wholeNumber("metallicFactor", std::uint64_t{0});
    json.number("roughnessFactor", material.roughness());
    if (material.isTextured) {
        json.openObject("baseColorTexture");
        json.wholeNumber("index", std::uint64_t{0});
        json.close();
    }
    json.close();
    if (isTransparent) json.text("alphaMode", "BLEND");
    json.close();
}

void openAccessor(JsonWriter& json, std::uint64_t view, std::uint64_t offset, std::uint64_t component,
                  std::uint64_t count, const char* type) {
    json.openObject();
    json.wholeNumber("bufferView", view);
    json.wholeNumber("byteOffset", offset);
    json.wholeNumber("componentType", component);
    json.wholeNumber("count", count);
    json.text("type", type);
}

/// Writes the bounds of the positions as doubles: a reader that uses doubles would read a float's own shortest digits
/// as another number.
void writeBound(JsonWriter& json, std::string_view key, const std::array<float, 3>& bound) {
    json.numbers(key, {double{bound[0]}, double{bound[1]}, double{bound[2]}});
}

void writePositions(JsonWriter& json, std::uint64_t view, const GlbPrimitive& primitive) {
    openAccessor(json, view, 12 * std::uint64_t{primitive.firstVertex}, gltf::kFloat, primitive.vertexCount, "VEC3");
    writeBound(json, "min", primitive.min);
    writeBound(json, "max", primitive.max);
    json.close();
}

void writeIndices(JsonWriter& json, std::uint64_t view, const GlbPrimitive& primitive) {
    openAccessor(json, view, 4 * std::uint64_t{primitive.firstIndex}, gltf::kUnsignedInt, primitive.indexCount,
                 "SCALAR");
    json.close();
}

/// Writes the four accessors of a primitive, in the order of the buffer's arrays.
void writeAccessors(JsonWriter& json, const GlbPrimitive& primitive) {
    const std::uint64_t vertex = primitive.firstVertex;
    writePositions(json, 0, primitive);
    openAccessor(json, 1, 12 * vertex, gltf::kFloat, primitive.vertexCount, "VEC3");
    json.close();
    openAccessor(json, 2, 8 * vertex, gltf::kFloat, primitive.vertexCount, "VEC2");
    json.close();
    writeIndices(json, 3, primitive);
}

/// Writes a view of `count` elements of `stride` bytes that starts at `offset`, and moves `offset` to its end.
void writeView(JsonWriter& json, std::uint64_t& offset, std::uint64_t count, std::uint64_t stride,
               std::uint64_t target) {
    json.openObject();
    json.wholeNumber("buffer", std::uint64_t{0});
    json.wholeNumber("byteOffset", offset);
    json.wholeNumber("byteLength", stride * count);
    if (target == gltf::kArrayBuffer) json.wholeNumber("byteStride", stride);
    json.wholeNumber("target", target);
    json.close();
    offset += stride * count;
}

void writeBuffer(JsonWriter& json, const GlbBuffer& buffer, const EncodedImage* image) {
    json.openArray("bufferViews");
    std::uint64_t offset = 0;
    writeView(json, offset, buffer.vertexCount(), 12, gltf::kArrayBuffer);
    writeView(json, offset, buffer.vertexCount(), 12, gltf::kArrayBuffer);
    writeView(json, offset, buffer.vertexCount(), 8, gltf::kArrayBuffer);
    writeView(json, offset, buffer.indexCount(), 4, gltf::kElementArrayBuffer);
    if (!buffer.hulls().empty()) {
        writeView(json, offset, buffer.hullVertexCount(), 12, gltf::kArrayBuffer);
        writeView(json, offset, buffer.hullIndexCount(), 4, gltf::kElementArrayBuffer);
    }
    const std::size_t imageSize = image == nullptr ? 0 : image->bytes().size();
    if (image != nullptr) {
        json.openObject();
        json.wholeNumber("buffer", std::uint64_t{0});
        json.wholeNumber("byteOffset", offset);
        json.wholeNumber("byteLength", std::uint64_t{imageSize});
        json.close();
    }
    json.close();
    json.openArray("buffers");
    json.openObject();
    json.wholeNumber("byteLength", std::uint64_t{buffer.size() + imageSize});
    json.close();
    json.close();
}

}  // namespace

void writeGlbAsset(JsonWriter& json) {
    json.openObject("asset");
    json.text("version", "2.0");
    json.text("generator", "Rubble");
    json.close();
}

void writeGlbMaterials(JsonWriter& json, const MeshMaterials& materials) {
    json.openArray("materials");
    for (const MeshMaterial& material : materials.outside) writeGlbMaterial(json, material);
    writeGlbMaterial(json, materials.inside);
    json.close();
}

void writeGlbTexture(JsonWriter& json, const MeshMaterials& materials, std::uint64_t view) {
    constexpr std::uint64_t kLinear = 9729, kLinearMipmapLinear = 9987, kRepeat = 10497;
    json.openArray("images");
    json.openObject();
    json.text("name", materials.imageFile);
    json.text("mimeType", materials.image->mediaType());
    json.wholeNumber("bufferView", view);
    json.close();
    json.close();
    json.openArray("samplers");
    json.openObject();
    json.wholeNumber("magFilter", kLinear);
    json.wholeNumber("minFilter", kLinearMipmapLinear);
    json.wholeNumber("wrapS", kRepeat);
    json.wholeNumber("wrapT", kRepeat);
    json.close();
    json.close();
    json.openArray("textures");
    json.openObject();
    json.wholeNumber("sampler", std::uint64_t{0});
    json.wholeNumber("source", std::uint64_t{0});
    json.close();
    json.close();
}

std::string glbJson(std::span<const MeshPart> parts, std::span<const std::vector<GlbPrimitive>> primitives,
                    const GlbBuffer& buffer, const MeshMaterials& materials, PartPlacement place,
                    const GlbPhysics* physics) {
    JsonWriter json(JsonLayout::Compact, 1024 + 1500 * parts.size());
    json.openObject();
    writeGlbAsset(json);
    if (physics != nullptr) writePhysicsExtensions(json, *physics, parts.size());
    if (physics != nullptr) writePhysicsNodes(json, parts, place, *physics);
    if (physics == nullptr) writeNodes(json, parts, place);
    writeMeshes(json, parts, primitives, materials, physics);
    writeGlbMaterials(json, materials);
    if (materials.image) writeGlbTexture(json, materials, imageView(buffer));
    json.openArray("accessors");
    for (const std::vector<GlbPrimitive>& part : primitives) {
        for (const GlbPrimitive& primitive : part) writeAccessors(json, primitive);
    }
    for (const GlbPrimitive& hull : buffer.hulls()) {
        writePositions(json, kHullPositionView, hull);
        writeIndices(json, kHullIndexView, hull);
    }
    json.close();
    writeBuffer(json, buffer, materials.image.get());
    json.close();
    return std::move(json).contents();
}

}  // namespace rubble
