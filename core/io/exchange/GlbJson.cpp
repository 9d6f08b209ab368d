#include "core/io/exchange/GlbJson.h"

#include "core/io/exchange/GlbElements.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/json/VectorJson.h"

namespace rubble {
namespace {

/// The view of the first image, behind those of the arrays: of meshes, then positions and indices of hulls.
std::uint64_t imageView(const GlbBuffer& buffer) { return buffer.arrayCount() + (buffer.hulls().empty() ? 0 : 2); }

void writeNodes(JsonWriter& json, std::span<const MeshPart> parts, PartPlacement place) {
    writeGlbScene(json, parts.size());
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

void writeMeshes(JsonWriter& json, std::span<const MeshPart> parts,
                 std::span<const std::vector<GlbPrimitive>> primitives, const GlbBuffer& buffer,
                 const MeshMaterials& materials, const GlbPhysics* physics) {
    json.openArray("meshes");
    std::uint64_t accessor = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        json.openObject();
        json.text("name", parts[k].name);
        json.openArray("primitives");
        for (const GlbPrimitive& primitive : primitives[k]) {
            const bool isInside = primitive.material == GlbBuffer::kInside;
            const MeshMaterial& material = isInside ? materials.inside : materials.outside[primitive.material];
            writeGlbPrimitive(json, accessor, isInside ? materials.outside.size() : primitive.material, buffer,
                              material.isBaked);
            accessor += buffer.arrayCount();
        }
        json.close();
        json.close();
    }
    if (physics != nullptr) writeHullMeshes(json, parts, *physics, accessor);
    json.close();
}

}  // namespace

std::string glbJson(std::span<const MeshPart> parts, std::span<const std::vector<GlbPrimitive>> primitives,
                    const GlbBuffer& buffer, const MeshMaterials& materials, PartPlacement place,
                    const GlbPhysics* physics) {
    JsonWriter json(JsonLayout::Compact, 1024 + 1500 * parts.size());
    json.openObject();
    writeGlbAsset(json);
    if (physics != nullptr && physics->form == GlbBodyForm::Extensions)
        writePhysicsExtensions(json, *physics, parts.size());
    if (physics != nullptr) writePhysicsNodes(json, parts, place, *physics);
    if (physics == nullptr) writeNodes(json, parts, place);
    writeMeshes(json, parts, primitives, buffer, materials, physics);
    writeGlbMaterials(json, materials);
    const std::vector<GlbImage> images = glbImages(materials);
    writeGlbTextures(json, images, imageView(buffer));
    json.openArray("accessors");
    for (const std::vector<GlbPrimitive>& part : primitives) {
        for (const GlbPrimitive& primitive : part) writeGlbAccessors(json, primitive, buffer);
    }
    for (const GlbPrimitive& hull : buffer.hulls()) {
        writeGlbPositions(json, buffer.arrayCount(), hull);
        writeGlbIndices(json, buffer.arrayCount() + 1, hull);
    }
    json.close();
    GlbViews views(json);
    views.addArrays(buffer);
    for (const GlbImage& image : images) {
        if (!image.isBeside) views.addBytes(image.image->bytes().size());
    }
    views.end();
    json.close();
    return std::move(json).contents();
}

}  // namespace rubble
