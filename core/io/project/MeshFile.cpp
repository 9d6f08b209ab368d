#include "core/io/project/MeshFile.h"

#include "core/base/MessageText.h"
#include "core/geometry/mesh/MeshHash.h"
#include "core/io/system/Compression.h"
#include "core/io/system/OpenFile.h"

#include <sys/stat.h>

#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <vector>

namespace rubble {
namespace {

constexpr std::string_view kMeshMagic = "RBLMESH\n";

/// What a mesh file starts with.
struct MeshHeader {
    std::array<char, 8> magic{};
    std::uint32_t version = kMeshFileVersion;
    std::uint32_t points = 0;
    std::uint32_t triangles = 0;
    std::uint32_t packedBytes = 0;  // after the header
    ContentHash hash;
};
using PointList = std::vector<Vec3>;
using TriangleList = std::vector<std::array<std::uint32_t, 3>>;

// Numbers are little-endian in files, and side by side, as they are in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(MeshHeader) == 40 && std::is_trivially_copyable_v<MeshHeader>);
constexpr std::size_t kPointBytes = sizeof(PointList::value_type), kTriangleBytes = sizeof(TriangleList::value_type);
static_assert(kPointBytes == 3 * sizeof(double) && kTriangleBytes == 3 * sizeof(std::uint32_t));
static_assert(kMaxMeshFilePoints * kPointBytes + kMaxMeshFileTriangles * kTriangleBytes < (std::size_t{1} << 31));

MeshHeader headerOf(const ClosedMesh& mesh) {
    MeshHeader header{.points = static_cast<std::uint32_t>(mesh.mesh.points.size()),
                      .triangles = static_cast<std::uint32_t>(mesh.mesh.triangles.size()),
                      .hash = mesh.hash};
    std::ranges::copy(kMeshMagic, header.magic.begin());
    return header;
}

Error unreadableMesh(const std::string& what) {
    return {ErrorCode::BadInput, "The mesh cannot be read: " + what + "; restore the file from a copy of the project."};
}

/// Reads and checks everything before the compressed bytes.
Result<MeshHeader> readHeader(std::string_view bytes, const ContentHash& hash) {
    if (!bytes.starts_with(kMeshMagic)) return unreadableMesh("the file is not a mesh of Rubble");
    if (bytes.size() < sizeof(MeshHeader)) return unreadableMesh("it is cut off");
    MeshHeader header;
    std::memcpy(&header, bytes.data(), sizeof(header));
    if (header.version == 0 || header.version > kMeshFileVersion) {
        return Error{ErrorCode::Unsupported, "The mesh has version " + std::to_string(header.version) +
                                                 ", but this program reads versions up to " +
                                                 std::to_string(kMeshFileVersion) + "; open it with a newer one."};
    }
    if (header.hash != hash)
        return unreadableMesh("it is another one, of the hash " + header.hash.hex() + " instead of " + hash.hex());
    if (const Status fits = checkMeshSize(header.points, header.triangles); !fits) return fits.error();
    const std::size_t packed = bytes.size() - sizeof(header);
    if (packed < header.packedBytes) return unreadableMesh("it is cut off");
    if (packed > header.packedBytes) return unreadableMesh("bytes follow its end");
    return header;
}

}  // namespace

Status checkMeshSize(std::size_t points, std::size_t triangles) {
    const auto tooMany = [](std::size_t count, const char* what, std::size_t most) {
        return Error{ErrorCode::Limit, "The mesh has " + std::to_string(count) + " " + what + ", but at most " +
                                           std::to_string(most) + " are kept in a file; simplify it."};
    };
    if (triangles > kMaxMeshFileTriangles) return tooMany(triangles, "triangles", kMaxMeshFileTriangles);
    if (points > kMaxMeshFilePoints) return tooMany(points, "points", kMaxMeshFilePoints);
    return success();
}

std::string meshBytes(const ClosedMesh& mesh) {
    const PointList& points = mesh.mesh.points;
    const TriangleList& triangles = mesh.mesh.triangles;
    std::string content(points.size() * kPointBytes + triangles.size() * kTriangleBytes, '\0');
    std::memcpy(content.data(), points.data(), points.size() * kPointBytes);
    std::memcpy(content.data() + points.size() * kPointBytes, triangles.data(), triangles.size() * kTriangleBytes);
    const std::string packed = compressed(content);
    MeshHeader header = headerOf(mesh);
    header.packedBytes = static_cast<std::uint32_t>(packed.size());
    std::string bytes(sizeof(header), '\0');
    std::memcpy(bytes.data(), &header, sizeof(header));
    return bytes + packed;
}

Result<std::shared_ptr<const ClosedMesh>> readMeshBytes(std::string_view bytes, const ContentHash& hash) {
    const Result<MeshHeader> header = readHeader(bytes, hash);
    if (!header) return header.error();
    const std::size_t pointBytes = header->points * kPointBytes, triangleBytes = header->triangles * kTriangleBytes;
    const Result<std::string> content = uncompressed(bytes.substr(sizeof(MeshHeader)), pointBytes + triangleBytes);
    if (!content) return unreadableMesh(content.error().message);
    TriangleMesh mesh{.points = PointList(header->points), .triangles = TriangleList(header->triangles)};
    std::memcpy(mesh.points.data(), content->data(), pointBytes);
    std::memcpy(mesh.triangles.data(), content->data() + pointBytes, triangleBytes);
    if (hashOf(mesh) != hash) return unreadableMesh("its bytes were changed");
    return closedMesh(std::move(mesh));
}

bool isMeshFileOf(const std::filesystem::path& path, const ClosedMesh& mesh) {
    const OpenFile file(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    struct stat status {};
    MeshHeader header;
    if (!file.isOpen() || ::fstat(file.descriptor(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
    if (::pread(file.descriptor(), &header, sizeof(header), 0) != ssize_t{sizeof(header)}) return false;
    const MeshHeader expected = headerOf(mesh);
    return header.magic == expected.magic && header.version == expected.version && header.hash == expected.hash &&
           header.points == expected.points && header.triangles == expected.triangles &&
           static_cast<std::uint64_t>(status.st_size) == sizeof(header) + header.packedBytes;
}

}  // namespace rubble
