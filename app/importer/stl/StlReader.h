#pragma once

#include "core/geometry/mesh/SourceScene.h"

#include <string_view>

namespace rubble {

/// Returns whether bytes are an STL file: text that begins with "solid" in any case, or as many bytes as the number of
/// triangles in a binary header asks for.
bool isStl(std::string_view bytes);

/// Reads an STL file as text, each solid an object, or binary, one object. Keywords may have any case, and lines may be
/// empty. Bytes behind the last triangle of a binary file become a note. Normals, which follow from the corners, and
/// colours are ignored.
///
/// Errors: throws MeshError; BadInput if it is truncated or has no triangles, with the line of text that is invalid;
/// Limit above kMaxTriangles.
/// Source: 3D Systems, "StereoLithography Interface Specification", 1989.
SourceScene readStl(std::string_view bytes);

}  // namespace rubble
