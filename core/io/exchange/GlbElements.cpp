#include "core/io/exchange/GlbElements.h"

#include "core/io/exchange/GlbConstants.h"

namespace rubble {
namespace {

/// Writes the bounds of the positions as doubles: a reader that uses doubles would read a float's own shortest digits
/// as another number.
void writeBound(JsonWriter& json, std::string_view key, const std::array<float, 3>& bound) {
    json.numbers(key, {double{bound[0]}, double{bound[1]}, double{bound[2]}});
}

void writeTexture(JsonWriter& json, std::string_view key, std::uint64_t texture) {
    json.openObject(key);
    json.wholeNumber("index", texture);
    json.close();
}

/// Without factors: those of glTF are 1, also that of metalness.
void writeBakedMaterial(JsonWriter& json, std::uint64_t firstTexture) {
    json.openObject("pbrMetallicRoughness");
    writeTexture(json, "baseColorTexture", firstTexture);
    writeTexture(json, "metallicRoughnessTexture", firstTexture + 2);
    json.close();
    writeTexture(json, "normalTexture", firstTexture + 1);
}

}  // namespace

void writeGlbAsset(JsonWriter& json) {
    json.openObject("asset");
    json.text("version", "2.0");
    json.text("generator", "Rubble");
    json.close();
}

void writeGlbScene(JsonWriter& json, std::uint64_t nodeCount, std::string_view name) {
    json.wholeNumber("scene", std::uint64_t{0});
    json.openArray("scenes");
    json.openObject();
    if (!name.empty()) json.text("name", name);
    json.openArray("nodes");
    for (std::uint64_t node = 0; node < nodeCount; ++node) json.wholeNumber({}, node);
    json.close();
    json.close();
    json.close();
}

void writeGlbMaterial(JsonWriter& json, const MeshMaterial& material, std::uint64_t texture) {
    const Vec3 colour = linearColour(material.colour);
    const bool isTransparent = material.opacity < 1.0;
    json.openObject();
    json.text("name", material.name);
    if (material.isBaked) {
        writeBakedMaterial(json, texture);
        json.close();
        return;
    }
    json.openObject("pbrMetallicRoughness");
    json.numbers("baseColorFactor", {colour.x, colour.y, colour.z, material.opacity});
    json.wholeNumber("metallicFactor", std::uint64_t{0});
    json.number("roughnessFactor", material.roughness());
    if (material.isTextured) writeTexture(json, "baseColorTexture", texture);
    json.close();
    if (isTransparent) json.text("alphaMode", "BLEND");
    json.close();
}

void writeGlbMaterials(JsonWriter& json, const MeshMaterials& materials) {
    json.openArray("materials");
    const auto write = [&](const MeshMaterial& material) {
        writeGlbMaterial(json, material, material.isBaked && materials.image ? 1 : 0);
    };
    for (const MeshMaterial& material : materials.outside) write(material);
    write(materials.inside);
    json.close();
}

std::vector<GlbImage> glbImages(const MeshMaterials& materials) {
    std::vector<GlbImage> images;
    if (materials.image) images.push_back({materials.imageFile, materials.image});
    if (!materials.baked) return images;
    const auto& [colour, normal, surface, areBeside] = *materials.baked;
    for (const MeshImage* image : {&colour, &normal, &surface})
        images.push_back({image->name, image->image, areBeside});
    return images;
}

void writeGlbTextures(JsonWriter& json, std::span<const GlbImage> images, std::uint64_t firstView) {
    constexpr std::uint64_t kLinear = 9729, kLinearMipmapLinear = 9987, kRepeat = 10497;
    if (images.empty()) return;
    json.openArray("images");
    std::uint64_t view = firstView;
    for (const GlbImage& image : images) {
        json.openObject();
        json.text("name", image.name);
        json.text("mimeType", image.image->mediaType());
        image.isBeside ? json.text("uri", image.name) : json.wholeNumber("bufferView", view++);
        json.close();
    }
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
    for (std::size_t k = 0; k < images.size(); ++k) {
        json.openObject();
        json.wholeNumber("sampler", std::uint64_t{0});
        json.wholeNumber("source", std::uint64_t{k});
        json.close();
    }
    json.close();
}

void writeGlbPrimitive(JsonWriter& json, std::uint64_t accessor, std::uint64_t material, const GlbBuffer& buffer,
                       bool isBaked) {
    json.openObject();
    json.openObject("attributes");
    json.wholeNumber("POSITION", accessor);
    json.wholeNumber("NORMAL", accessor + 1);
    json.wholeNumber("TEXCOORD_0", accessor + 2);
    if (buffer.hasTangents() && isBaked) json.wholeNumber("TANGENT", accessor + 3);
    json.close();
    json.wholeNumber("indices", accessor + buffer.arrayCount() - 1);
    json.wholeNumber("material", material);
    json.close();
}

void openGlbAccessor(JsonWriter& json, std::uint64_t view, std::uint64_t offset, std::uint64_t component,
                     std::uint64_t count, const char* type) {
    json.openObject();
    json.wholeNumber("bufferView", view);
    json.wholeNumber("byteOffset", offset);
    json.wholeNumber("componentType", component);
    json.wholeNumber("count", count);
    json.text("type", type);
}

void writeGlbPositions(JsonWriter& json, std::uint64_t view, const GlbPrimitive& primitive) {
    openGlbAccessor(json, view, 12 * std::uint64_t{primitive.firstVertex}, gltf::kFloat, primitive.vertexCount, "VEC3");
    writeBound(json, "min", primitive.min);
    writeBound(json, "max", primitive.max);
    json.close();
}

void writeGlbIndices(JsonWriter& json, std::uint64_t view, const GlbPrimitive& primitive) {
    openGlbAccessor(json, view, 4 * std::uint64_t{primitive.firstIndex}, gltf::kUnsignedInt, primitive.indexCount,
                    "SCALAR");
    json.close();
}

void writeGlbAccessors(JsonWriter& json, const GlbPrimitive& primitive, const GlbBuffer& buffer) {
    const std::uint64_t vertex = primitive.firstVertex;
    writeGlbPositions(json, 0, primitive);
    openGlbAccessor(json, 1, 12 * vertex, gltf::kFloat, primitive.vertexCount, "VEC3");
    json.close();
    openGlbAccessor(json, 2, 8 * vertex, gltf::kFloat, primitive.vertexCount, "VEC2");
    json.close();
    if (buffer.hasTangents()) {
        openGlbAccessor(json, 3, 16 * vertex, gltf::kFloat, primitive.vertexCount, "VEC4");
        json.close();
    }
    writeGlbIndices(json, buffer.arrayCount() - 1, primitive);
}

GlbViews::GlbViews(JsonWriter& json) : m_json(json) { m_json.openArray("bufferViews"); }

void GlbViews::addArray(std::uint64_t count, std::uint64_t stride, std::uint64_t target) {
    m_json.openObject();
    m_json.wholeNumber("buffer", std::uint64_t{0});
    m_json.wholeNumber("byteOffset", m_offset);
    m_json.wholeNumber("byteLength", stride * count);
    if (target == gltf::kArrayBuffer) m_json.wholeNumber("byteStride", stride);
    m_json.wholeNumber("target", target);
    m_json.close();
    m_offset += stride * count;
}

void GlbViews::addArrays(const GlbBuffer& buffer) {
    addArray(buffer.vertexCount(), 12, gltf::kArrayBuffer);
    addArray(buffer.vertexCount(), 12, gltf::kArrayBuffer);
    addArray(buffer.vertexCount(), 8, gltf::kArrayBuffer);
    if (buffer.hasTangents()) addArray(buffer.vertexCount(), 16, gltf::kArrayBuffer);
    addArray(buffer.indexCount(), 4, gltf::kElementArrayBuffer);
    if (buffer.hulls().empty()) return;
    addArray(buffer.hullVertexCount(), 12, gltf::kArrayBuffer);
    addArray(buffer.hullIndexCount(), 4, gltf::kElementArrayBuffer);
}

void GlbViews::addBytes(std::uint64_t count) {
    m_json.openObject();
    m_json.wholeNumber("buffer", std::uint64_t{0});
    m_json.wholeNumber("byteOffset", m_offset);
    m_json.wholeNumber("byteLength", count);
    m_json.close();
    m_offset += count;
}

void GlbViews::end() {
    m_json.close();
    m_json.openArray("buffers");
    m_json.openObject();
    m_json.wholeNumber("byteLength", m_offset);
    m_json.close();
    m_json.close();
}

}  // namespace rubble
