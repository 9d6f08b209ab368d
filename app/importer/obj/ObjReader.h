#pragma once

#include "app/importer/files/MeshFiles.h"
#include "core/geometry/mesh/SourceScene.h"

#include <string_view>

namespace rubble {

/// Reads an OBJ file, its material files and their images. Numbers are read in double precision; polygons are
/// triangulated, points and lines ignored. A material file or an image that is not read becomes a note.
///
/// Errors: throws MeshError; those of readObjText(), and Limit above kMaxTriangles.
SourceScene readObj(std::string_view text, MeshFiles& files);

}  // namespace rubble
