#include "core/io/exchange/GlbWriter.h"

#include "core/base/Assert.h"
#include "core/io/exchange/GlbJson.h"

#include <limits>

namespace rubble {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t kGlbVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004e4942;  // "BIN"
constexpr std::size_t kVertexSize = 32;             // bytes: position, normal, texture coordinates
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

/// Returns an upper bound for the size of a file with these parts.
std::size_t maxFileSize(std::span<const MeshPart> parts, const MeshMaterials& materials, const GlbPhysics* physics) {
    std::size_t size = physics == nullptr ? 0 : maxPhysicsSize(*physics);
    size += materials.image ? materials.image->bytes().size() : 0;
    for (const MeshPart& part : parts) {
        size += (materials.outside.size() + 2) * kJsonSize;
        for (const MeshFace& face : part.mesh.faces) {
            // Triangulated around a new vertex in the middle.
            size += (face.cornerCount + 1) * kVertexSize + 3 * face.cornerCount * kIndexSize;
        }
    }
    return size;
}

void appendWord(std::string& bytes, std::size_t number) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 255);
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
    GlbBuffer buffer;
    std::vector<std::vector<GlbPrimitive>> primitives;
    for (const MeshPart& part : parts) primitives.push_back(buffer.add(part.mesh));
    if (physics != nullptr) {
        for (const GlbBody& body : physics->bodies) {
            for (const PackHull& hull : body.body.hulls) buffer.addHull(hull.polytope);
        }
    }
    std::string json = glbJson(parts, primitives, buffer, materials, place, physics);
    json.resize((json.size() + 3) / 4 * 4, ' ');

    const std::string_view image = materials.image ? std::string_view(materials.image->bytes()) : std::string_view();
    const std::size_t binarySize = (buffer.size() + image.size() + 3) / 4 * 4;
    std::string bytes;
    bytes.reserve(28 + json.size() + binarySize);
    appendWord(bytes, kMagic);
    appendWord(bytes, kGlbVersion);
    appendWord(bytes, 28 + json.size() + binarySize);
    appendWord(bytes, json.size());
    appendWord(bytes, kJsonChunk);
    bytes += json;
    appendWord(bytes, binarySize);
    appendWord(bytes, kBinaryChunk);
    buffer.appendTo(bytes);
    bytes += image;
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    return bytes;
}

}  // namespace rubble
