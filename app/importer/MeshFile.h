#pragma once

#include "app/importer/files/MeshFiles.h"
#include "core/base/Result.h"
#include "core/geometry/mesh/SourceScene.h"

#include <string>

namespace rubble {

/// Reads an OBJ, glTF, GLB, FBX, STL or PLY file, recognized by its content or, where that is of no format for certain,
/// by its suffix: a SourceObject, transformed, for each object or node with triangles. Polygons are triangulated,
/// points and lines ignored. Single-precision numbers are read as their shortest decimals, so that 0.3 is 0.3. The unit
/// is that of the file; FBX files are rotated y up. Files outside the mesh's folder are not read; if the mesh can be
/// read without them, they become notes.
///
/// Errors, with the file's name: Unsupported if the file has another format, a version or an extension that is not
/// read, or needs a file that is not read, and, with the library's reason, if an FBX file is damaged; BadInput, with
/// the place, if a file of another format is damaged, and for invalid indices and numbers; Degenerate if
/// it has no triangles or all of its objects are hidden; Limit above kMaxTriangles, and as readGltf(); Io if it cannot
/// be opened.
Result<SourceScene> readMeshFile(MeshPlace place, FileLog log = FileLog::Off);

}  // namespace rubble
