#pragma once

#include "core/io/exchange/GlbBuffer.h"
#include "core/io/exchange/MeshPart.h"
#include "core/io/json/JsonWriter.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

/// Elements of the JSON chunk of a GLB file, which several kinds of files have.
namespace rubble {

/// Writes the member "asset".
void writeGlbAsset(JsonWriter& json);

/// Writes the members "scene" and "scenes": one with all nodes below `nodeCount`. Without a name if it is empty.
void writeGlbScene(JsonWriter& json, std::uint64_t nodeCount, std::string_view name = {});

/// Writes a material, with a texture if it is textured, and with this and the next two if it is baked.
void writeGlbMaterial(JsonWriter& json, const MeshMaterial& material, std::uint64_t texture = 0);
/// Writes the member "materials": the outside ones, then the inside.
void writeGlbMaterials(JsonWriter& json, const MeshMaterials& materials);

/// An image of a GLB file.
struct GlbImage {
    std::string name;
    std::shared_ptr<const EncodedImage> image;
    bool isBeside = false;  // a file of that name beside it, and not a part of it
};
/// The image of materials, if they have one, and then those that are baked: of colours, normals, and roughness.
std::vector<GlbImage> glbImages(const MeshMaterials& materials);
/// Writes the members "images", "samplers" and "textures": one that repeats each image. The views of those that are
/// parts of the file follow each other from `firstView` on. Without images, writes nothing.
void writeGlbTextures(JsonWriter& json, std::span<const GlbImage> images, std::uint64_t firstView);

/// Writes a primitive, whose accessors, as many as the buffer has arrays, start at `accessor`. `isBaked`: its tangents
/// are those of its texture coordinates.
void writeGlbPrimitive(JsonWriter& json, std::uint64_t accessor, std::uint64_t material, const GlbBuffer& buffer,
                       bool isBaked);
/// Writes the accessors of a primitive, in the order of the buffer's arrays.
void writeGlbAccessors(JsonWriter& json, const GlbPrimitive& primitive, const GlbBuffer& buffer);
/// Writes the accessor of positions or indices of a primitive in a view.
void writeGlbPositions(JsonWriter& json, std::uint64_t view, const GlbPrimitive& primitive);
void writeGlbIndices(JsonWriter& json, std::uint64_t view, const GlbPrimitive& primitive);
/// Begins an accessor; close() ends it.
void openGlbAccessor(JsonWriter& json, std::uint64_t view, std::uint64_t offset, std::uint64_t component,
                     std::uint64_t count, const char* type);

/// Writes "bufferViews" and "buffers", of the one buffer that a file has: first the arrays of meshes.
class GlbViews {
public:
    explicit GlbViews(JsonWriter& json);
    /// The views of the arrays of `buffer`, in their order.
    void addArrays(const GlbBuffer& buffer);
    /// A view that no vertices or indices are in.
    void addBytes(std::uint64_t count);
    void end();

private:
    void addArray(std::uint64_t count, std::uint64_t stride, std::uint64_t target);

    JsonWriter& m_json;
    std::uint64_t m_offset = 0;
};

}  // namespace rubble
