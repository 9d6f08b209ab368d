#pragma once

#include "core/base/Result.h"
#include "core/geometry/SourceScene.h"

#include <string>

namespace rubble {

/// Reads an OBJ, glTF, GLB, FBX, STL or PLY file, known by its ending and else by its content: a SourceObject for each
/// node with triangles, where its node's transforms put it, n-gons cut into triangles, points and lines left out.
/// Numbers of single precision become their shortest decimals, so that 0.3 is 0.3. A file's own unit is told; FBX
/// says its up axis and is turned y up.
///
/// Errors: Unsupported where the file is of no such kind or is damaged, with the reader's reason; Degenerate
/// where it holds no triangle; BadInput where an index or a number is wrong; Limit above kMostTriangles.
Result<SourceScene> readMeshFile(const std::string& path);

/// More would not fit into the memory that the program is given.
inline constexpr std::size_t kMostTriangles = 2'000'000;

}  // namespace rubble
