#pragma once

#include "core/geometry/mesh/SourceScene.h"

#include <string_view>

namespace rubble {

/// Reads a PLY file, text or binary, as one object: points, texture coordinates of vertices and of corners, polygons
/// and triangle strips; other elements and properties are skipped. Points have one material, which is white.
///
/// Errors: throws MeshError; BadInput with the element that is damaged; Limit above kMaxTriangles.
/// Source: Turk, "The PLY Polygon File Format", 1994.
SourceScene readPly(std::string_view bytes);

}  // namespace rubble
