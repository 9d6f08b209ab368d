#include "app/importer/gltf/GltfShapes.h"

#include "app/importer/files/MeshError.h"
#include "app/importer/files/Rounding.h"
#include "app/importer/gltf/Draco.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

using CornerIndices = std::array<std::uint32_t, 3>;

/// The triangles of a list, strip or fan.
std::vector<CornerIndices> trianglesOf(const std::vector<std::uint32_t>& indices, std::uint32_t mode) {
    constexpr std::uint32_t kList = 4, kStrip = 5, kFan = 6;
    std::vector<CornerIndices> triangles;
    if (mode == kList)
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    if (mode == kStrip || mode == kFan) {
        for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
            const std::uint32_t a = mode == kFan ? indices[0] : indices[i];
            CornerIndices triangle{a, indices[i + 1], indices[i + 2]};
            if (mode == kStrip && i % 2 == 1) std::swap(triangle[1], triangle[2]);
            const auto [x, y, z] = triangle;
            if (x != y && y != z && z != x) triangles.push_back(triangle);  // strips are joined by empty ones
        }
    }
    return triangles;
}

/// Texture coordinates as a material reads them, with v up.
Vec2 textureUv(Vec2 uv, const GltfMaterial* material) {
    if (material != nullptr) {
        const double c = std::cos(material->uvRotation), s = std::sin(material->uvRotation);
        uv *= material->uvScale;
        if (material->uvRotation != 0.0) uv = {c * uv.x + s * uv.y, c * uv.y - s * uv.x};
        uv += material->uvOffset;
    }
    return {uv.x, 1.0 - uv.y};
}

/// The points that triangles use, ascending.
std::vector<std::uint32_t> usedPoints(const std::vector<CornerIndices>& triangles) {
    std::vector<std::uint32_t> used;
    for (const CornerIndices& corners : triangles) used.insert(used.end(), corners.begin(), corners.end());
    std::ranges::sort(used);
    used.erase(std::ranges::unique(used).begin(), used.end());
    return used;
}

/// The step to which the positions of the points are rounded, in their own space.
double stepOf(const GltfNumbers& positions, const std::vector<std::uint32_t>& points) {
    if (positions.normalBits > 0) return normalizedStep(positions.numbers, positions.normalBits);
    if (positions.step > 0.0) return positions.step;
    RoundingMeter rounding;
    for (const std::uint32_t point : points) {
        const Vec3 position = positions.vec3(point);
        rounding.add({&position, 1});
    }
    return rounding.step();
}

}  // namespace

/// Where the numbers of a primitive are.
struct GltfShapes::Source {
    std::optional<DracoMesh> draco;
    std::vector<CornerIndices> triangles;
    const GltfNumbers* positions = nullptr;

    const GltfNumbers* other(const GltfPrimitive& primitive, const std::string& name, std::uint32_t components,
                             GltfAccessors& accessors) const {
        if (draco && draco->others.contains(name)) {
            const GltfNumbers& numbers = draco->others.find(name)->second;
            return numbers.components == components ? &numbers : nullptr;
        }
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return nullptr;
        const GltfNumbers& numbers = accessors.numbers(found->second, components);
        if (numbers.count() < positions->count()) failGltf("a primitive has fewer values in " + name + " than points");
        return &numbers;
    }
};

GltfShapes::Source GltfShapes::sourceOf(const GltfPrimitive& primitive) {
    Source source;
    std::vector<std::uint32_t> indices;
    if (primitive.draco) {
        source.draco = dracoDecoded(m_buffers.view(primitive.draco->view), primitive, m_document);
        if (!source.draco) failGltf("the bytes of a mesh that is compressed by Draco are damaged");
        source.triangles = trianglesOf(source.draco->indices, 4);
        return source;
    }
    const auto positions = primitive.attributes.find("POSITION");
    if (positions == primitive.attributes.end()) return source;
    source.positions = &m_accessors.numbers(positions->second, 3);
    if (primitive.indices) {
        indices = m_accessors.indices(*primitive.indices);
    } else {
        indices.resize(source.positions->count());
        for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
    }
    source.triangles = trianglesOf(indices, primitive.mode);
    return source;
}

void GltfShapes::addMesh(const GltfNode& node, const Mat4& toScene, SourceObject& object) {
    if (*node.mesh >= m_document.meshes.size())
        failGltf("a node refers to mesh " + std::to_string(*node.mesh) + " of " +
                 std::to_string(m_document.meshes.size()));
    const GltfMesh& mesh = m_document.meshes[*node.mesh];
    const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
    for (const GltfPrimitive& primitive : mesh.primitives) addPrimitive(primitive, weights, node, toScene, object);
}

std::vector<Mat4> GltfShapes::jointTransforms(std::uint32_t index) {
    if (index >= m_document.skins.size())
        failGltf("a node refers to skin " + std::to_string(index) + " of " + std::to_string(m_document.skins.size()));
    const GltfSkin& skin = m_document.skins[index];
    const GltfNumbers* inverses = nullptr;
    if (skin.inverseBindMatrices) inverses = &m_accessors.numbers(*skin.inverseBindMatrices, 16);
    if (inverses != nullptr && inverses->count() < skin.joints.size())
        failGltf("a skin has fewer matrices than joints");
    std::vector<Mat4> transforms;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        if (skin.joints[i] >= m_fromNodes.size())
            failGltf("a skin refers to node " + std::to_string(skin.joints[i]) + " of " +
                     std::to_string(m_fromNodes.size()));
        Mat4 inverse(1.0);
        for (int k = 0; inverses != nullptr && k < 16; ++k)
            inverse[k / 4][k % 4] = inverses->numbers[16 * i + static_cast<std::size_t>(k)];
        transforms.push_back(m_fromNodes[skin.joints[i]] * inverse);
    }
    return transforms;
}

/// What moves the points of a primitive, before its node does: targets of morphing and joints of a skin.
struct GltfShapes::Deformation {
    std::vector<std::pair<const GltfNumbers*, double>> morphs;                  // with their weights
    std::vector<Mat4> joints;                                                   // to the scene
    std::vector<std::pair<const GltfNumbers*, const GltfNumbers*>> influences;  // joints of points, and weights

    Vec3 morphed(Vec3 position, std::size_t point) const {
        for (const auto& [target, weight] : morphs) position += weight * target->vec3(point);
        return position;
    }
    /// The step of positions together with those of the targets.
    double morphedStep(double step) const {
        for (const auto& [target, weight] : morphs) step += std::abs(weight) * target->step;
        return step;
    }
    /// That of the node where no joint moves the point.
    Mat4 transformAt(std::size_t point, const Mat4& toScene) const {
        Mat4 sum(0.0);
        double total = 0.0;
        for (const auto& [of, by] : influences) {
            for (std::size_t k = 4 * point; k < 4 * point + 4; ++k) {
                const double weight = by->numbers[k];
                if (!(weight > 0.0)) continue;
                if (!(of->numbers[k] < static_cast<double>(joints.size())))
                    failGltf("a point refers to a missing joint");
                sum += weight * joints[static_cast<std::size_t>(of->numbers[k])];
                total += weight;
            }
        }
        return total > 0.0 ? sum / total : toScene;
    }
};

GltfShapes::Deformation GltfShapes::deformationOf(const GltfPrimitive& primitive, const Source& source,
                                                  const std::vector<double>& weights, const GltfNode& node) {
    Deformation deformation;
    for (std::size_t i = 0; i < primitive.targets.size() && i < weights.size(); ++i) {
        const auto found = primitive.targets[i].find("POSITION");
        if (found == primitive.targets[i].end() || weights[i] == 0.0) continue;
        const GltfNumbers& target = m_accessors.numbers(found->second, 3);
        if (target.count() < source.positions->count()) failGltf("a morph target has too few points");
        deformation.morphs.emplace_back(&target, weights[i]);
    }
    if (!node.skin) return deformation;
    deformation.joints = jointTransforms(*node.skin);
    for (const char* set : {"0", "1"}) {
        const GltfNumbers* of = source.other(primitive, std::string("JOINTS_") + set, 4, m_accessors);
        const GltfNumbers* by = source.other(primitive, std::string("WEIGHTS_") + set, 4, m_accessors);
        if (of != nullptr && by != nullptr) deformation.influences.emplace_back(of, by);
    }
    return deformation;
}

/// The material of a primitive; null if it has none.
const GltfMaterial* GltfShapes::materialOf(const GltfPrimitive& primitive) const {
    if (!primitive.material) return nullptr;
    if (*primitive.material >= m_document.materials.size())
        throw MeshError(ErrorCode::BadInput, "refers to material " + std::to_string(*primitive.material) + " of " +
                                                 std::to_string(m_document.materials.size()));
    return &m_document.materials[*primitive.material];
}

void GltfShapes::addPrimitive(const GltfPrimitive& primitive, const std::vector<double>& weights, const GltfNode& node,
                              const Mat4& toScene, SourceObject& object) {
    Source source = sourceOf(primitive);
    if (source.draco) source.positions = &source.draco->positions;
    if (source.triangles.empty()) return;
    m_triangles += source.triangles.size();
    if (m_triangles > kMaxTriangles)
        throw MeshError(ErrorCode::Limit, "contains more than " + std::to_string(kMaxTriangles) + " triangles");
    const std::vector<std::uint32_t> used = usedPoints(source.triangles);
    if (used.back() >= source.positions->count())
        throw MeshError(ErrorCode::BadInput, "has a face that refers to point " + std::to_string(used.back()) + " of " +
                                                 std::to_string(source.positions->count()));
    const Deformation deformation = deformationOf(primitive, source, weights, node);
    const auto first = static_cast<std::uint32_t>(object.points.size());
    const double step = deformation.morphedStep(stepOf(*source.positions, used));
    for (const std::uint32_t point : used) {
        const Vec3 position = deformation.morphed(source.positions->vec3(point), point);
        const Mat4 transform = deformation.transformAt(point, toScene);
        object.points.push_back(Vec3(transform * glm::dvec4(position, 1.0)));
        object.rounding = std::max(object.rounding, displacementBy(step, transform));
    }
    const GltfMaterial* material = materialOf(primitive);
    const std::string uvSet = "TEXCOORD_" + std::to_string(material == nullptr ? 0 : material->uvSet);
    const GltfNumbers* uvs = source.other(primitive, uvSet, 2, m_accessors);
    object.hasUvs |= uvs != nullptr;
    const bool isMirrored = deformation.influences.empty() && glm::determinant(Mat3(toScene)) < 0.0;
    for (const CornerIndices& corners : source.triangles) {
        SourceTriangle& triangle = object.triangles.emplace_back();
        triangle.material = primitive.material.value_or(static_cast<std::uint32_t>(m_document.materials.size()));
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t point = corners[isMirrored ? 2 - k : k];
            const auto at = std::ranges::lower_bound(used, point) - used.begin();
            triangle.points[k] = first + static_cast<std::uint32_t>(at);
            if (uvs != nullptr) triangle.uvs[k] = textureUv(uvs->vec2(point), material);
        }
    }
}

}  // namespace rubble
