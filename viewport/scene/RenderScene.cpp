#include "viewport/scene/RenderScene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {
namespace {

/// Whether one of some sorted marks stands for a body.
bool isMarked(const std::vector<PickId>& sorted, const PickId& body) {
    const auto has = [&](Id instance, std::uint32_t fragment) {
        return std::ranges::binary_search(sorted, PickId{body.asset, instance, fragment});
    };
    return !sorted.empty() &&
           (has(body.instance, body.fragment) || has(0, body.fragment) || has(body.instance, kNone) || has(0, kNone));
}

void include(Box3& bounds, const Box3& box, const DrawnPose& motion, const RenderScene& scene) {
    const Quat orientation(
        glm::quat(motion.orientation.w, motion.orientation.x, motion.orientation.y, motion.orientation.z));
    const Vec3 position = scene.origin + Vec3(motion.position) + scene.exploded * Vec3(motion.apart);
    const double scale = 1.0 - static_cast<double>(motion.position.w);
    for (int corner = 0; corner < 8; ++corner) bounds.include(position + orientation * (scale * box.corner(corner)));
}

}  // namespace

DrawnPose drawnPose(const Pose& pose, Vec3 origin) {
    const glm::quat orientation(pose.orientation);
    return {glm::vec4(glm::vec3(pose.position - origin), 0.0f),
            {orientation.x, orientation.y, orientation.z, orientation.w}};
}

DrawnPose between(const DrawnPose& from, const DrawnPose& to, double share) {
    const auto part = static_cast<float>(share);
    const float side = glm::dot(from.orientation, to.orientation) < 0.0f ? -1.0f : 1.0f;
    return {glm::mix(from.position, to.position, part),
            glm::normalize(glm::mix(side * from.orientation, to.orientation, part)), to.apart};
}

DrawnPose poseAt(const RenderScene& scene, std::uint32_t body, double moment) {
    const DrawnPose& now = scene.motions[body];
    return moment >= 1.0 || scene.earlier.empty() ? now : between(scene.earlier[body], now, moment);
}

void setMarks(RenderScene& scene, const SceneMarks& marks) {
    SceneMarks sorted = marks;
    for (std::vector<PickId>* ids : {&sorted.hidden, &sorted.selected, &sorted.hovered}) std::ranges::sort(*ids);
    for (std::size_t body = 0; body < scene.picks.size(); ++body) {
        const PickId& pick = scene.picks[body];
        scene.looks[body].marks = (isMarked(sorted.hidden, pick) ? kHidden : 0) |
                                  (isMarked(sorted.selected, pick) ? kSelected : 0) |
                                  (isMarked(sorted.hovered, pick) ? kHovered : 0);
    }
}

Box3 boundsOf(const RenderScene& scene, std::uint32_t marks) {
    Box3 bounds;
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            for (std::uint32_t piece = 0; piece < batch.geometry->pieceCount(); ++piece) {
                const std::uint32_t has = scene.looks[first + piece].marks;
                const bool isMeant = (has & kHidden) == 0 && (marks == 0 || (has & marks) != 0);
                if (!isMeant) continue;
                include(bounds, batch.geometry->boxes[piece], scene.motions[first + piece], scene);
                if (scene.earlier.empty()) continue;
                include(bounds, batch.geometry->boxes[piece], scene.earlier[first + piece], scene);
            }
        }
    }
    return bounds;
}

}  // namespace rubble
