#pragma once

#include "app/importer/gltf/GltfNodes.h"
#include "core/geometry/mesh/SourceScene.h"

namespace rubble {

/// Adds the triangles of meshes to objects.
class GltfShapes {
public:
    GltfShapes(const GltfDocument& document, GltfBuffers& buffers, GltfAccessors& accessors,
               const std::vector<Mat4>& fromNodes)
        : m_document(document), m_buffers(buffers), m_accessors(accessors), m_fromNodes(fromNodes) {}

    /// Adds a node's mesh, morphed, and skinned or else transformed.
    ///
    /// Errors: throws MeshError.
    void addMesh(const GltfNode& node, const Mat4& toScene, SourceObject& object);

private:
    struct Source;
    struct Deformation;

    Source sourceOf(const GltfPrimitive& primitive);
    void addPrimitive(const GltfPrimitive& primitive, const std::vector<double>& weights, const GltfNode& node,
                      const Mat4& toScene, SourceObject& object);
    Deformation deformationOf(const GltfPrimitive& primitive, const Source& source, const std::vector<double>& weights,
                              const GltfNode& node);
    const GltfMaterial* materialOf(const GltfPrimitive& primitive) const;
    std::vector<Mat4> jointTransforms(std::uint32_t skin);

    const GltfDocument& m_document;
    GltfBuffers& m_buffers;
    GltfAccessors& m_accessors;
    const std::vector<Mat4>& m_fromNodes;
    std::size_t m_triangles = 0;
};

}  // namespace rubble
