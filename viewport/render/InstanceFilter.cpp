#include "viewport/render/InstanceFilter.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace rubble {
namespace {

constexpr float kNearest = 1e-3f;  // m, of what is around the eye

glm::vec3 pointAt(const RenderPose& pose, glm::vec3 local) {
    const glm::quat rotation(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
    return glm::vec3(pose.position) + rotation * ((1.0f - pose.position.w) * local);
}

}  // namespace

InstanceFilter::InstanceFilter(const RenderScene& scene, const InstanceView& view) : m_scene(scene), m_view(view) {
    const glm::mat4 rows = glm::transpose(view.clipFromScene);
    m_planes = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]};
    for (glm::vec4& plane : m_planes) plane /= std::max(glm::length(glm::vec3(plane)), 1e-20f);
}

InstanceFilter::Sphere InstanceFilter::sphereOf(std::uint32_t body, const Box3& box) const {
    const glm::vec3 middle(box.centre());
    const auto radius = static_cast<float>(0.5 * box.diagonal());
    const glm::vec3 now = pointAt(m_scene.poses[body], middle);
    if (m_scene.previousPoses.empty()) return {now, radius};
    const glm::vec3 before = pointAt(m_scene.previousPoses[body], middle);
    return {0.5f * (now + before), radius + 0.5f * glm::distance(now, before)};
}

bool InstanceFilter::isSeen(const Sphere& sphere) const {
    return std::ranges::all_of(m_planes, [&](const glm::vec4& plane) {
        return glm::dot(glm::vec3(plane), sphere.centre) + plane.w > -sphere.radius;
    });
}

double InstanceFilter::pixelsOf(double size, const Sphere& sphere) const {
    const float distance = glm::distance(glm::vec3(m_view.eye), sphere.centre) - sphere.radius;
    return size *
           static_cast<double>(m_view.pixelsOfMetre / (m_view.eye.w > 0.5f ? std::max(distance, kNearest) : 1.0f));
}

}  // namespace rubble
