#pragma once

#include "core/geometry/mesh/SourceScene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

inline constexpr std::uint32_t kNoUv = 0xffffffffu;

struct ObjCorner {
    std::uint32_t point = 0;
    std::uint32_t uv = kNoUv;
};

struct ObjFace {
    std::uint32_t firstCorner = 0;
    std::uint32_t size = 0;  // corners, >= 3
    std::uint32_t part = 0;
    std::uint32_t material = 0;
};

/// Faces that belong together: those of an object, or of a group in a file without objects.
struct ObjPart {
    std::string name;  // empty for faces before the first one
};

/// The content of an OBJ file, as it is written.
struct ObjContent {
    std::vector<Vec3> points;
    std::vector<Vec2> uvs;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<ObjPart> parts;
    bool hasObjects = false;                 // parts are objects, not groups
    std::vector<std::string> materials;      // names; the first is empty
    std::vector<std::string> materialFiles;  // as the file names them
    bool lacksUvs = false;                   // a face refers to texture coordinates that are missing
    bool hasCurves = false;                  // free-form curves or surfaces, which are not read
};

/// Reads the text of an OBJ file: points, texture coordinates, faces, objects, groups and materials. Each "o" begins an
/// object with the rest of the line as its name, also where the name is repeated; groups count where there is no "o",
/// and one of the same name goes on. Lines may end with a backslash to go on in the next one.
/// Texture coordinates that are missing are left out.
///
/// Errors: throws MeshError with the line if a number or a face is invalid or refers to a missing point.
/// Source: Alias|Wavefront, "Object Files (.obj)", 1995.
ObjContent readObjText(std::string_view text);

/// A texture of the base colour, map_Kd.
struct ObjTexture {
    std::string file;            // as the material file names it; empty: none
    bool isTransformed = false;  // moved, scaled or made turbulent by options, which are not read
};

/// Reads the colours and the textures of a material file, Kd and map_Kd, of the materials with the given names; those
/// of other materials stay as they are. A material with a texture alone is white. `textures`: one per material.
void readMaterialFile(std::string_view text, std::vector<SourceMaterial>& materials, std::vector<ObjTexture>& textures);

}  // namespace rubble
