#pragma once

#include "app/importer/gltf/GltfAccessors.h"

namespace rubble {

using Mat4 = glm::dmat4;

/// The parent of each node.
///
/// Errors: throws MeshError if a node has two.
std::vector<GltfIndex> nodeParents(const GltfDocument& document);

/// The transform of each node to the scene.
///
/// Errors: throws MeshError if nodes are their own parents.
std::vector<Mat4> sceneTransforms(const GltfDocument& document, const std::vector<GltfIndex>& parents);

/// Nodes, each before its children, in the order of the file.
struct SceneNodes {
    std::vector<std::uint32_t> visible;
    std::vector<std::uint32_t> hidden;  // by themselves, or with a parent
};

/// The nodes of the shown scene.
SceneNodes nodesOfScene(const GltfDocument& document);

/// The transforms of a node's instances to the scene; its own if it has no instances.
///
/// Errors: throws MeshError; those of GltfAccessors, Limit above kMaxCopies.
std::vector<Mat4> instanceTransforms(const GltfNode& node, const Mat4& fromNode, GltfAccessors& accessors);

/// Returns the motion that takes what one transform places to what another does, if it is rigid.
std::optional<Pose> rigidMotion(const Mat4& from, const Mat4& to);

}  // namespace rubble
