#pragma once

#include "core/base/Result.h"
#include "core/geometry/mesh/ClosedMesh.h"
#include "core/geometry/mesh/SourceScene.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace rubble {

/// A mesh file holds one closed mesh, compressed. All fields are described in docs/formats/project.md.
inline constexpr std::uint32_t kMeshFileVersion = 1;
/// The most triangles and points of a mesh that is written or read: as many as an import gives.
inline constexpr std::size_t kMaxMeshFileTriangles = kMaxTriangles;
inline constexpr std::size_t kMaxMeshFilePoints = 3 * kMaxMeshFileTriangles;

/// Whether a mesh is small enough to be read again.
///
/// Errors: Limit above kMaxMeshFileTriangles or kMaxMeshFilePoints.
Status checkMeshSize(std::size_t points, std::size_t triangles);

/// A mesh as the bytes of a file. Meshes of the same hash give the same bytes, as far as zlib does. checkMeshSize()
/// must accept it.
std::string meshBytes(const ClosedMesh& mesh);

/// Reads what meshBytes() wrote, bit for bit, and judges it again: see closedMesh(). `hash` is that of the mesh asked
/// for.
///
/// Errors: BadInput for other bytes, changed ones, or those of another mesh; Unsupported for a newer version; those of
/// checkMeshSize(); Degenerate for a mesh that cannot be cut as it is.
Result<std::shared_ptr<const ClosedMesh>> readMeshBytes(std::string_view bytes, const ContentHash& hash);

/// Whether a file holds a mesh by its header and its size: what is compressed is not read.
bool isMeshFileOf(const std::filesystem::path& path, const ClosedMesh& mesh);

}  // namespace rubble
