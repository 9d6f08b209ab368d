#pragma once

#include "core/base/Result.h"
#include "core/geometry/mesh/SourceScene.h"

#include <string>

namespace rubble {

/// Reads an OBJ, glTF, GLB, FBX, STL or PLY file, recognized by its suffix or, failing that, by its content: a
/// SourceObject, transformed, for each node with triangles. Polygons are triangulated, points and lines ignored.
/// Single-precision numbers are read as their shortest decimals, so that 0.3 is 0.3. The unit is that of the file; FBX
/// files are rotated y up.
///
/// Errors: Unsupported if the file has another format or is damaged, with the library's reason; Degenerate if it has no
/// triangles; BadInput for invalid indices and numbers; Limit above kMaxTriangles.
Result<SourceScene> readMeshFile(const std::string& path);

/// The maximum number of triangles; more would exceed the importer's memory limit.
inline constexpr std::size_t kMaxTriangles = 2'000'000;

}  // namespace rubble
