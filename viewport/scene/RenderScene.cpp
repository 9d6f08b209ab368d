#include "viewport/scene/RenderScene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

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

/// A box that is turned and moved with a body.
Box3 placed(const Box3& box, const DrawnPose& pose) {
    const glm::dmat3 turn =
        glm::mat3_cast(Quat(glm::quat(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z)));
    const double scale = 1.0 - static_cast<double>(pose.position.w);
    const Vec3 half = 0.5 * scale * (box.max - box.min);
    const Vec3 centre = Vec3(pose.position) + scale * (turn * box.centre());
    const Vec3 reach = half.x * glm::abs(turn[0]) + half.y * glm::abs(turn[1]) + half.z * glm::abs(turn[2]);
    return {centre - reach, centre + reach};
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
            glm::normalize(glm::mix(side * from.orientation, to.orientation, part))};
}

DrawnPose poseAt(const RenderScene& scene, std::uint32_t body, double moment) {
    const DrawnPose& now = scene.motions[body];
    return moment >= 1.0 || scene.earlier.empty() ? now : between(scene.earlier[body], now, moment);
}

Vec3 movedApart(const RenderScene& scene, std::uint32_t body) {
    return scene.apart.empty() ? Vec3(0.0) : scene.exploded * Vec3(scene.apart[body]);
}

void setMarks(RenderScene& scene, const SceneMarks& marks) {
    SceneMarks sorted = marks;
    scene.summary.reset();
    for (std::vector<PickId>* ids : {&sorted.hidden, &sorted.selected, &sorted.hovered}) std::ranges::sort(*ids);
    for (std::size_t body = 0; body < scene.picks.size(); ++body) {
        const PickId& pick = scene.picks[body];
        scene.looks[body].marks = (isMarked(sorted.hidden, pick) ? kHidden : 0) |
                                  (isMarked(sorted.selected, pick) ? kSelected : 0) |
                                  (isMarked(sorted.hovered, pick) ? kHovered : 0);
    }
}

Box3 boundsAt(const RenderScene& scene, std::span<const DrawnPose> poses, std::uint32_t marks) {
    Box3 bounds;
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            for (std::uint32_t piece = 0; piece < batch.geometry->pieceCount(); ++piece) {
                const std::uint32_t body = first + piece, has = scene.looks[body].marks;
                if ((has & kHidden) != 0 || (marks != 0 && (has & marks) == 0)) continue;
                const Box3 box = placed(batch.geometry->boxes[piece], poses[body]);
                const Vec3 moved = scene.origin + movedApart(scene, body);
                bounds.include(Box3{box.min + moved, box.max + moved});
            }
        }
    }
    return bounds;
}

Box3 boundsOf(const RenderScene& scene, std::uint32_t marks) {
    if (marks == 0 && scene.summary) return scene.summary->bounds;
    Box3 bounds = boundsAt(scene, scene.motions, marks);
    if (!scene.earlier.empty()) bounds.include(boundsAt(scene, scene.earlier, marks));
    return bounds;
}

SceneSummary summaryOf(const RenderScene& scene) {
    if (scene.summary) return *scene.summary;
    const auto isSelected = [](const BodyLook& look) { return (look.marks & kSelected) != 0; };
    return {boundsOf(scene), std::ranges::any_of(scene.looks, isSelected)};
}

}  // namespace rubble
