#include "app/importer/gltf/GltfNodes.h"

#include "app/importer/files/MeshError.h"
#include "core/geometry/mesh/SourceScene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

Mat4 transformOf(Vec3 translation, Quat rotation, Vec3 scale) {
    Mat4 matrix = glm::mat4_cast(rotation);
    for (int k = 0; k < 3; ++k) matrix[k] *= scale[k];
    matrix[3] = glm::dvec4(translation, 1.0);
    return matrix;
}

}  // namespace

std::vector<GltfIndex> nodeParents(const GltfDocument& document) {
    std::vector<GltfIndex> parents(document.nodes.size());
    for (std::uint32_t i = 0; i < parents.size(); ++i) {
        for (const std::uint32_t child : document.nodes[i].children) {
            if (child >= parents.size())
                failGltf("nodes[" + std::to_string(i) + "] refers to node " + std::to_string(child) + " of " +
                         std::to_string(parents.size()));
            if (parents[child]) failGltf("nodes[" + std::to_string(child) + "] has two parents");
            parents[child] = i;
        }
    }
    return parents;
}

std::vector<Mat4> sceneTransforms(const GltfDocument& document, const std::vector<GltfIndex>& parents) {
    std::vector<Mat4> transforms(parents.size(), Mat4(1.0));
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < parents.size(); ++i)
        if (!parents[i]) open.push_back(i);
    std::size_t done = 0;
    for (; !open.empty(); ++done) {
        const std::uint32_t node = open.back();
        open.pop_back();
        const Mat4& own = document.nodes[node].fromNode;
        transforms[node] = parents[node] ? transforms[*parents[node]] * own : own;
        const auto& children = document.nodes[node].children;
        open.insert(open.end(), children.begin(), children.end());
    }
    if (done < parents.size()) failGltf("its nodes are their own parents");
    return transforms;
}

SceneNodes nodesOfScene(const GltfDocument& document) {
    SceneNodes nodes;
    std::vector<std::uint32_t> open(document.roots.rbegin(), document.roots.rend());
    std::vector<bool> isKnown(document.nodes.size(), false), isHidden(document.nodes.size(), false);
    while (!open.empty()) {
        const std::uint32_t node = open.back();
        open.pop_back();
        if (node >= document.nodes.size())
            failGltf("its scene refers to node " + std::to_string(node) + " of " +
                     std::to_string(document.nodes.size()));
        if (isKnown[node]) continue;
        isKnown[node] = true;
        if (!document.nodes[node].isVisible) isHidden[node] = true;
        (isHidden[node] ? nodes.hidden : nodes.visible).push_back(node);
        const auto& children = document.nodes[node].children;
        for (const std::uint32_t child : children)
            if (isHidden[node] && child < isHidden.size()) isHidden[child] = true;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return nodes;
}

std::vector<Mat4> instanceTransforms(const GltfNode& node, const Mat4& fromNode, GltfAccessors& accessors) {
    const auto numbers = [&](const char* name, std::uint32_t components) {
        const auto found = node.instances.find(name);
        return found == node.instances.end() ? nullptr : &accessors.numbers(found->second, components);
    };
    const GltfNumbers* translations = numbers("TRANSLATION", 3);
    const GltfNumbers* rotations = numbers("ROTATION", 4);
    const GltfNumbers* scales = numbers("SCALE", 3);
    std::optional<std::size_t> count;
    for (const GltfNumbers* values : {translations, rotations, scales}) {
        if (values == nullptr) continue;
        if (count.value_or(values->count()) != values->count())
            failGltf("the instances of a node have unequal attributes");
        count = values->count();
    }
    if (!count) return {fromNode};
    if (*count > kMaxCopies)
        throw MeshError(ErrorCode::Limit, "places a mesh more than " + std::to_string(kMaxCopies) + " times");
    std::vector<Mat4> transforms;
    for (std::size_t i = 0; i < *count; ++i) {
        Quat rotation(1.0, 0.0, 0.0, 0.0);
        if (rotations != nullptr) {
            const double* r = &rotations->numbers[4 * i];
            if (const Quat given(r[3], r[0], r[1], r[2]); glm::length(given) > 0.0) rotation = glm::normalize(given);
        }
        const Vec3 translation = translations == nullptr ? Vec3(0.0) : translations->vec3(i);
        const Vec3 scale = scales == nullptr ? Vec3(1.0) : scales->vec3(i);
        transforms.push_back(fromNode * transformOf(translation, rotation, scale));
    }
    return transforms;
}

std::optional<Pose> rigidMotion(const Mat4& from, const Mat4& to) {
    constexpr double kTolerance = 1e-6;  // of lengths, above the error of rotations in single precision
    if (!(std::abs(glm::determinant(Mat3(from))) > 0.0)) return std::nullopt;
    const Mat4 motion = to * glm::inverse(from);
    const Mat3 rotation(motion);
    const Mat3 product = glm::transpose(rotation) * rotation;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(product[i][k] - (i == k ? 1.0 : 0.0)) <= kTolerance)) return std::nullopt;
    if (glm::determinant(rotation) < 0.0) return std::nullopt;
    return Pose{Vec3(motion[3]), glm::normalize(glm::quat_cast(rotation))};
}

}  // namespace rubble
