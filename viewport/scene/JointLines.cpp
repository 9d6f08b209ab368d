#include "viewport/scene/JointLines.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr float kJointRadius = 1.3f;                          // points
constexpr glm::vec4 kJointColour{0.10f, 0.62f, 0.95f, 1.0f};  // sRGB: unlike the bonds within an instance

Vec3 perpendicularTo(Vec3 normal) {
    const Vec3 axis = std::abs(normal.x) < 0.5 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    return glm::normalize(glm::cross(normal, axis));
}

}  // namespace

std::array<Vec3, 4> jointCorners(const MortarJoint& joint) {
    const Vec3 u = perpendicularTo(joint.normal), v = glm::cross(joint.normal, u);
    const double uu = glm::dot(u, joint.moments * u), vv = glm::dot(v, joint.moments * v);
    const double uv = glm::dot(u, joint.moments * v);
    const double angle = 0.5 * std::atan2(2.0 * uv, uu - vv);
    const double mean = 0.5 * (uu + vv), spread = std::hypot(0.5 * (uu - vv), uv);
    const auto halfLength = [&](double moment) {  // area * length² / 12 = moment
        return std::sqrt(3.0 * std::max(moment, 0.0) / joint.area);
    };
    const Vec3 along = halfLength(mean + spread) * (std::cos(angle) * u + std::sin(angle) * v);
    const Vec3 across = halfLength(mean - spread) * (std::cos(angle) * v - std::sin(angle) * u);
    const Vec3 centre = joint.centroid;
    return {centre - along - across, centre + along - across, centre + along + across, centre - along + across};
}

void addJointLines(RenderScene& scene, std::span<const MortarJoint> joints) {
    const auto inScene = [&](Vec3 point) { return glm::vec3(point - scene.origin); };
    for (const MortarJoint& joint : joints) {
        const std::array<Vec3, 4> corners = jointCorners(joint);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec3 &from = corners[k], &to = corners[(k + 1) % corners.size()];
            scene.lines.push_back({glm::vec4(inScene(from), kJointRadius), glm::vec4(inScene(to), 0.0f), kJointColour});
        }
    }
}

}  // namespace rubble
