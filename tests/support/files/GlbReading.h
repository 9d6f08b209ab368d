#pragma once

#include "core/geometry/mesh/Mesh.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace rubble {

/// The two chunks of a GLB file.
struct Glb {
    nlohmann::json json;
    std::string binary;
};

inline std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

/// Parses a GLB file; fails on a wrong magic number, version, length, padding or type of chunk.
inline std::string openGlb(const std::string& bytes, Glb& glb) {
    if (bytes.size() < 20 || bytes.substr(0, 4) != "glTF" || wordAt(bytes, 4) != 2) return "header";
    if (wordAt(bytes, 8) != bytes.size() || bytes.size() % 4 != 0) return "length of the file";
    const std::size_t jsonSize = wordAt(bytes, 12);
    if (bytes.substr(16, 4) != "JSON" || jsonSize % 4 != 0 || 28 + jsonSize > bytes.size()) return "chunk of JSON";
    glb.json = nlohmann::json::parse(bytes.substr(20, jsonSize), nullptr, false);
    if (glb.json.is_discarded()) return "JSON";
    const std::size_t binary = 20 + jsonSize;
    if (bytes.substr(binary + 4, 4) != std::string("BIN\0", 4)) return "binary chunk";
    if (binary + 8 + wordAt(bytes, binary) != bytes.size()) return "length of the binary chunk";
    glb.binary = bytes.substr(binary + 8);
    return {};
}

/// The elements of an accessor.
template <class T>
std::vector<T> numbersOf(const Glb& glb, const nlohmann::json& accessor) {
    static const std::map<std::string, std::size_t> kComponents{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
    const nlohmann::json& view = glb.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t at = view["byteOffset"].get<std::size_t>() + accessor["byteOffset"].get<std::size_t>();
    std::vector<T> numbers(accessor["count"].get<std::size_t>() * kComponents.at(accessor["type"]));
    std::memcpy(numbers.data(), glb.binary.data() + at, numbers.size() * sizeof(T));
    return numbers;
}

/// The mesh of a node in its own frame, with vertices welded by position; `material` of a face is the primitive's.
inline Mesh meshOfNode(const Glb& glb, const nlohmann::json& node) {
    Mesh mesh;
    std::map<std::tuple<float, float, float>, std::uint32_t> known;
    for (const nlohmann::json& primitive : glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"]) {
        const auto accessorOf = [&](const nlohmann::json& index) {
            return glb.json["accessors"][index.get<std::size_t>()];
        };
        const nlohmann::json& attributes = primitive["attributes"];
        const auto positions = numbersOf<float>(glb, accessorOf(attributes["POSITION"]));
        const auto normals = numbersOf<float>(glb, accessorOf(attributes["NORMAL"]));
        const auto uvs = numbersOf<float>(glb, accessorOf(attributes["TEXCOORD_0"]));
        const auto indices = numbersOf<std::uint32_t>(glb, accessorOf(primitive["indices"]));
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const float* p = &positions[3 * indices[i]];
            const float* n = &normals[3 * indices[i]];
            const auto [place, isNew] =
                known.try_emplace({p[0], p[1], p[2]}, static_cast<std::uint32_t>(mesh.positions.size()));
            if (isNew) mesh.positions.push_back({p[0], p[1], p[2]});
            if (i % 3 == 0) {
                mesh.faces.push_back({static_cast<std::uint32_t>(mesh.corners.size()), 3,
                                      static_cast<std::uint32_t>(mesh.normals.size()),
                                      primitive["material"].get<std::uint32_t>(), FaceSide::Outside});
                mesh.normals.push_back(glm::normalize(Vec3{n[0], n[1], n[2]}));
            }
            mesh.corners.push_back({place->second, static_cast<std::uint32_t>(mesh.uvs.size())});
            mesh.uvs.push_back({uvs[2 * indices[i]], uvs[2 * indices[i] + 1]});
        }
    }
    return mesh;
}

}  // namespace rubble
