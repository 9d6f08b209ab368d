#pragma once

#include "core/base/Result.h"
#include "core/geometry/Vec.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A material as a mesh file names it.
struct SourceMaterial {
    std::string name;            // empty where the file has none
    Vec3 colour{0.8, 0.8, 0.8};  // sRGB, each in [0, 1]
    bool operator==(const SourceMaterial&) const = default;
};

/// A triangle of a mesh file.
struct SourceTriangle {
    std::array<std::uint32_t, 3> points{};  // counter-clockwise from outside, as the file has it
    std::array<Vec2, 3> uvs{};              // v up; zero where the object has none
    std::uint32_t material = 0;
    bool operator==(const SourceTriangle&) const = default;
};

/// An object of a mesh file, where it stands in the file's scene.
struct SourceObject {
    std::string name;  // empty where the file has none
    bool hasUvs = false;
    std::vector<Vec3> points;  // in the file's unit and axes; finite
    std::vector<SourceTriangle> triangles;
    bool operator==(const SourceObject&) const = default;
};

/// All that is taken from a mesh file.
struct SourceScene {
    double metresPerUnit = 0.0;  // 0 where the file does not say
    std::vector<SourceMaterial> materials;
    std::vector<SourceObject> objects;  // each with a triangle at least
    bool operator==(const SourceScene&) const = default;
};

/// The scene in bytes, as the program that reads mesh files hands it to the one that asked for it: little-endian, texts
/// and lists after their lengths. Both are always of one version.
std::string sourceSceneBytes(const SourceScene& scene);

/// Reads them back, trusting nothing.
///
/// Errors: BadInput where they are cut short, too long, or hold an index out of range, a number that is not finite or a
/// text that is not UTF-8.
Result<SourceScene> readSourceScene(std::string_view bytes);

}  // namespace rubble
