#pragma once

#include "app/importer/files/MeshFiles.h"
#include "core/geometry/mesh/SourceScene.h"

namespace rubble {

/// Reads an FBX file and its images with assimp: an object for each node with triangles, in the unit of the file and
/// with y up. Bones, shape keys and animations become notes.
///
/// Errors: throws MeshError; Unsupported, with the library's reason, if it cannot be read or is older than version 7.1,
/// or needs a file that is not read; BadInput for indices of what does not exist; Limit above kMaxTriangles.
SourceScene readFbx(MeshFiles& files);

}  // namespace rubble
