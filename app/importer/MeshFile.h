#pragma once

#include "app/importer/files/MeshFiles.h"
#include "core/base/Result.h"
#include "core/geometry/mesh/SourceScene.h"

#include <string>

namespace rubble {

/// Reads an OBJ, glTF, GLB, FBX, STL or PLY file, recognized by its suffix or, failing that, by its content: a
/// SourceObject, transformed, for each node with triangles. Polygons are triangulated, points and lines ignored.
/// Single-precision numbers are read as their shortest decimals, so that 0.3 is 0.3. The unit is that of the file; FBX
/// files are rotated y up. Files outside the mesh's folder are not read; if the mesh can be read without them, they
/// become notes.
///
/// Errors: Unsupported, with the library's reason, if the file has another format, is damaged or needs a file outside
/// its folder; Degenerate if it has no triangles; BadInput for invalid indices and numbers; Limit above kMaxTriangles.
Result<SourceScene> readMeshFile(MeshPlace place, FileLog log = FileLog::Off);

}  // namespace rubble
