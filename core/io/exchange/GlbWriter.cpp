#include "core/io/exchange/GlbWriter.h"

#include "core/base/Assert.h"
#include "core/io/exchange/GlbContainer.h"
#include "core/io/exchange/GlbElements.h"
#include "core/io/exchange/GlbJson.h"

#include <limits>

namespace rubble {
namespace {

constexpr std::size_t kVertexSize = 48;  // bytes: position, normal, texture coordinates, tangent
constexpr std::size_t kIndexSize = 4;
constexpr std::size_t kJsonSize = 1000;  // bytes: an upper bound for a node or the accessors of a primitive

/// Returns an upper bound for the size of the bodies and their hulls.
std::size_t maxPhysicsSize(const GlbPhysics& physics) {
    std::size_t size = 0;
    for (const GlbBody& body : physics.bodies) {
        size += 2 * kJsonSize;
        for (const PackHull& hull : body.body.hulls) {
            const Polytope& polytope = hull.polytope;
            // A triangle for each corner of a face but two, and a corner for each end of an edge.
            size += 2 * kJsonSize + 12 * polytope.vertices.size() + 3 * kIndexSize * 2 * polytope.edges.size();
        }
    }
    return size;
}

/// The size of the images that are parts of a file.
std::size_t imageBytes(std::span<const GlbImage> images) {
    std::size_t bytes = 0;
    for (const GlbImage& image : images) bytes += image.isBeside ? 0 : image.image->bytes().size();
    return bytes;
}

/// Returns an upper bound for the size of a file with these parts.
std::size_t maxFileSize(std::span<const MeshPart> parts, const MeshMaterials& materials, const GlbPhysics* physics) {
    std::size_t size = physics == nullptr ? 0 : maxPhysicsSize(*physics);
    size += imageBytes(glbImages(materials));
    for (const MeshPart& part : parts) {
        size += (materials.outside.size() + 2) * kJsonSize;
        for (const MeshFace& face : part.mesh.faces) {
            // Triangulated around a new vertex in the middle.
            size += (face.cornerCount + 1) * kVertexSize + 3 * face.cornerCount * kIndexSize;
        }
    }
    return size;
}

}  // namespace

Result<std::string> glbFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlacement place,
                            const GlbPhysics* physics) {
    RUBBLE_ASSERT(!parts.empty());
    if (maxFileSize(parts, materials, physics) > std::numeric_limits<std::uint32_t>::max()) {
        return Error{ErrorCode::Limit,
                     std::to_string(parts.size()) +
                         " bodies exceed 4 GiB, the maximum of a GLB file; export one file per fragment."};
    }
    GlbBuffer buffer(materials.baked ? GlbBuffer::Tangents::OfMeshes : GlbBuffer::Tangents::None);
    std::vector<std::vector<GlbPrimitive>> primitives;
    for (const MeshPart& part : parts) primitives.push_back(buffer.add(part.mesh));
    if (physics != nullptr) {
        for (const GlbBody& body : physics->bodies) {
            for (const PackHull& hull : body.body.hulls) buffer.addHull(hull.polytope);
        }
    }
    std::string json = glbJson(parts, primitives, buffer, materials, place, physics);
    std::string binary;
    const std::vector<GlbImage> images = glbImages(materials);
    binary.reserve(buffer.size() + imageBytes(images) + 3);
    buffer.appendTo(binary);
    for (const GlbImage& image : images) {
        if (!image.isBeside) binary += image.image->bytes();
    }
    return glbContainer(std::move(json), std::move(binary));
}

}  // namespace rubble
