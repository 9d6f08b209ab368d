#pragma once

#include "core/geometry/predicates/Vec.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

// A glTF 2.0 document as the JSON text has it, without what is not read: normals, cameras and lights. Links are
// indices; none is checked yet but that it is a number.

using GltfIndex = std::optional<std::uint32_t>;

struct GltfBuffer {
    std::optional<std::string> uri;  // none: the binary chunk of a GLB file
    std::uint64_t size = 0;          // bytes
};

/// How the bytes of a view are compressed: EXT_meshopt_compression.
struct GltfMeshopt {
    std::uint32_t buffer = 0;
    std::uint64_t offset = 0, size = 0;
    std::uint32_t stride = 0, count = 0;
    std::string mode, filter;
};

struct GltfView {
    std::uint32_t buffer = 0;
    std::uint64_t offset = 0, size = 0;
    std::uint32_t stride = 0;  // 0: values follow each other
    std::optional<GltfMeshopt> meshopt;
};

/// Values that replace some of an accessor's.
struct GltfSparse {
    std::uint32_t count = 0;
    std::uint32_t indicesView = 0, indicesType = 0, valuesView = 0;
    std::uint64_t indicesOffset = 0, valuesOffset = 0;
};

struct GltfAccessor {
    GltfIndex view;  // none: zeros
    std::uint64_t offset = 0;
    std::uint32_t componentType = 0;  // 5120 to 5126
    std::uint32_t components = 0;     // 1 to 16
    std::uint32_t count = 0;
    bool isNormalized = false;
    std::optional<GltfSparse> sparse;
};

using GltfAttributes = std::map<std::string, std::uint32_t, std::less<>>;  // accessors, or ids of Draco's attributes

/// KHR_draco_mesh_compression
struct GltfDraco {
    std::uint32_t view = 0;
    GltfAttributes attributes;
};

struct GltfPrimitive {
    GltfAttributes attributes;
    GltfIndex indices, material;
    std::uint32_t mode = 4;
    std::vector<GltfAttributes> targets;  // of a morph
    std::optional<GltfDraco> draco;
};

struct GltfMesh {
    std::string name;
    std::vector<GltfPrimitive> primitives;
    std::vector<double> weights;
};

struct GltfNode {
    std::string name;
    GltfIndex mesh, skin;
    std::vector<std::uint32_t> children;
    glm::dmat4 fromNode{1.0};
    std::vector<double> weights;
    GltfAttributes instances;  // EXT_mesh_gpu_instancing
    bool isVisible = true;     // KHR_node_visibility: else it is hidden with its children
};

struct GltfSkin {
    std::vector<std::uint32_t> joints;
    GltfIndex inverseBindMatrices;
};

struct GltfImage {
    std::string name;
    std::optional<std::string> uri;
    GltfIndex view;
};

struct GltfMaterial {
    std::string name;
    Vec3 colour{1.0};   // linear
    GltfIndex texture;  // of the base colour
    // How texture coordinates are read: those of a set, transformed (KHR_texture_transform).
    std::uint32_t uvSet = 0;
    Vec2 uvOffset{0.0}, uvScale{1.0};
    double uvRotation = 0.0;  // radians, counter-clockwise
};

struct GltfDocument {
    std::vector<GltfBuffer> buffers;
    std::vector<GltfView> views;
    std::vector<GltfAccessor> accessors;
    std::vector<GltfMesh> meshes;
    std::vector<GltfNode> nodes;
    std::vector<GltfSkin> skins;
    std::vector<GltfMaterial> materials;
    std::vector<GltfIndex> textures;  // the image of each; none: in a format of an extension
    std::vector<GltfImage> images;
    std::vector<std::uint32_t> roots;  // of the scene that is shown
    std::size_t sceneCount = 0;
    bool hasAnimations = false;
};

/// Reads the JSON text of a glTF 2.0 file.
///
/// Errors: throws MeshError; BadInput with the path of an invalid value, Unsupported for another version or a required
/// extension that is not known and may change shapes, with its name.
/// Source: Khronos, "glTF 2.0 Specification", 2021.
GltfDocument readGltfDocument(std::string_view json);

}  // namespace rubble
