#pragma once

#include "core/geometry/mesh/Mesh.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rubble {

/// An object of an OBJ file. `material` of a face is the index of its usemtl run.
struct ObjObject {
    std::string name;
    std::string group;
    std::vector<std::string> materials;  // in the order of their runs
    Mesh mesh;                           // indices relative to the object; faces after the first run are inside
};

/// Reads the OBJ files that Rubble writes, independently of the locale. Normals, which have seven decimals, are
/// normalized.
inline std::vector<ObjObject> readObj(const std::string& text) {
    const auto numberOf = [](const std::string& word) {
        double number = 0.0;
        std::from_chars(word.data(), word.data() + word.size(), number);
        return number;
    };
    std::vector<ObjObject> objects;
    std::uint32_t positions = 1, uvs = 1, normals = 1;  // of preceding objects
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword, a, b, c;
        words >> keyword;
        if (keyword == "o") {
            if (!objects.empty()) {
                positions += static_cast<std::uint32_t>(objects.back().mesh.positions.size());
                uvs += static_cast<std::uint32_t>(objects.back().mesh.uvs.size());
                normals += static_cast<std::uint32_t>(objects.back().mesh.normals.size());
            }
            words >> objects.emplace_back().name;
        }
        if (objects.empty()) continue;
        ObjObject& object = objects.back();
        Mesh& mesh = object.mesh;
        if (keyword == "g") words >> object.group;
        if (keyword == "usemtl") words >> object.materials.emplace_back();
        if (keyword == "v" && words >> a >> b >> c) mesh.positions.push_back({numberOf(a), numberOf(b), numberOf(c)});
        if (keyword == "vt" && words >> a >> b) mesh.uvs.push_back({numberOf(a), numberOf(b)});
        if (keyword == "vn" && words >> a >> b >> c) {
            mesh.normals.push_back(glm::normalize(Vec3{numberOf(a), numberOf(b), numberOf(c)}));
        }
        if (keyword != "f") continue;
        const auto run = static_cast<std::uint32_t>(object.materials.size() - 1);
        MeshFace face{static_cast<std::uint32_t>(mesh.corners.size()), 0, 0, run, FaceSide::Outside};
        for (std::string corner; words >> corner; ++face.cornerCount) {
            std::replace(corner.begin(), corner.end(), '/', ' ');
            std::istringstream indices(corner);
            std::uint32_t position = 0, uv = 0;
            indices >> position >> uv >> face.normal;
            mesh.corners.push_back({position - positions, uv - uvs});
            face.normal -= normals;
        }
        mesh.faces.push_back(face);
    }
    return objects;
}

}  // namespace rubble
