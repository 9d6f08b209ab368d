#pragma once

#include "core/base/Result.h"
#include "core/base/image/EncodedImage.h"
#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// An image that materials of a mesh file refer to.
struct SourceImage {
    std::string name;  // of its file, without folders; with the suffix of its type
    EncodedImage image;
    bool operator==(const SourceImage&) const = default;
};

/// A material of a mesh file.
struct SourceMaterial {
    std::string name;                    // empty if the file has none
    Vec3 colour{0.8, 0.8, 0.8};          // sRGB, each in [0, 1]
    std::optional<std::uint32_t> image;  // of the base colour; index into SourceScene::images
    bool operator==(const SourceMaterial&) const = default;
};

/// A triangle of a mesh file.
struct SourceTriangle {
    std::array<std::uint32_t, 3> points{};  // counter-clockwise from outside
    std::array<Vec2, 3> uvs{};              // v up; zero if the object has none
    std::uint32_t material = 0;
    bool operator==(const SourceTriangle&) const = default;
};

/// An object of a mesh file, in the coordinates of the file's scene.
struct SourceObject {
    std::string name;  // empty if the file has none
    bool hasUvs = false;
    std::vector<Vec3> points;  // in the file's unit and axes; finite
    std::vector<SourceTriangle> triangles;
    std::vector<Pose> copies;  // motions that take the object to the other places where it stands
    double rounding = 0.0;     // in the file's unit: the most by which the file's numbers displace a point; 0: unknown
    bool operator==(const SourceObject&) const = default;
};

/// The imported contents of a mesh file.
struct SourceScene {
    double metresPerUnit = 0.0;  // 0 if the file does not say
    std::vector<SourceMaterial> materials;
    std::vector<SourceObject> objects;  // each with at least one triangle
    std::vector<std::string> notes;     // sentences: what was not read
    std::vector<SourceImage> images;
    bool operator==(const SourceScene&) const = default;
};

/// The maximum number of triangles of all objects; more would exceed the importer's memory limit.
inline constexpr std::size_t kMaxTriangles = 2'000'000;
/// The maximum number of copies of an object.
inline constexpr std::size_t kMaxCopies = 10'000;
/// The maximum number of notes; the last one says how many are left out.
inline constexpr std::size_t kMaxNotes = 1000;

/// Serializes a scene, to pass it from the importer process to its parent: little-endian, with lengths before texts and
/// lists. Both programs always have the same version.
std::string sourceSceneBytes(const SourceScene& scene);

/// Deserializes a scene from untrusted bytes.
///
/// Errors: BadInput for truncated or excess bytes, an index out of range, a number that is not finite, text that is
/// not UTF-8, an image that EncodedImage rejects, a rotation that is not a unit quaternion, or more than kMaxTriangles,
/// kMaxCopies or kMaxNotes. Memory is a few times that of the bytes at most.
Result<SourceScene> readSourceScene(std::string_view bytes);

}  // namespace rubble
