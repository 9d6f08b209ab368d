#include "viewport/scene/RenderScene.h"

#include "core/asset/project/FragmentColours.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rubble {
namespace {

/// Whether one of the sorted ids is that fragment of a body's instance, or of all instances of its asset.
bool hasFragment(const std::vector<PickId>& sorted, const PickId& body, std::uint32_t fragment) {
    const auto has = [&](Id instance) {
        return std::ranges::binary_search(sorted, PickId{body.asset, instance, fragment});
    };
    return !sorted.empty() && (has(body.instance) || has(0));
}

/// Whether one of the sorted ids matches a body.
bool isMarked(const std::vector<PickId>& sorted, const PickId& body) {
    return hasFragment(sorted, body, body.fragment) || hasFragment(sorted, body, kNone);
}

/// The bounding box of a body's local box at a pose.
Box3 placed(const Box3& box, const RenderPose& pose) {
    const glm::dmat3 rotation =
        glm::mat3_cast(Quat(glm::quat(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z)));
    const double scale = 1.0 - static_cast<double>(pose.position.w);
    const Vec3 half = 0.5 * scale * (box.max - box.min);
    const Vec3 centre = Vec3(pose.position) + scale * (rotation * box.centre());
    const Vec3 extent =
        half.x * glm::abs(rotation[0]) + half.y * glm::abs(rotation[1]) + half.z * glm::abs(rotation[2]);
    return {centre - extent, centre + extent};
}

/// Extends bounds by a visible body with a local box.
void includeBody(Box3& bounds, const RenderScene& scene, std::uint32_t body, const Box3& local,
                 std::span<const RenderPose> poses) {
    if ((scene.appearances[body].marks & kHidden) != 0) return;
    const Box3 box = placed(local, poses[body]);
    const Vec3 moved = scene.origin + explodeOffset(scene, body);
    bounds.include(Box3{box.min + moved, box.max + moved});
}

}  // namespace

RenderPose renderPose(const Pose& pose, Vec3 origin) {
    const glm::quat orientation(pose.orientation);
    return {glm::vec4(glm::vec3(pose.position - origin), 0.0f),
            {orientation.x, orientation.y, orientation.z, orientation.w}};
}

std::uint32_t packedSurface(const Colour& colour, double opacity) {
    return packed(colour) | (255 - static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0))))
                                << 24;
}

bool hasTransparentSurface(const RenderScene& scene) {
    return std::ranges::any_of(scene.appearances, [](const BodyAppearance& body) {
        return (body.marks & kHidden) == 0 && ((body.outside | body.inside) & kTransparencyBits) != 0;
    });
}

RenderPose interpolated(const RenderPose& from, const RenderPose& to, double fraction) {
    const auto t = static_cast<float>(fraction);
    const float sign = glm::dot(from.orientation, to.orientation) < 0.0f ? -1.0f : 1.0f;
    return {glm::mix(from.position, to.position, t),
            glm::normalize(glm::mix(sign * from.orientation, to.orientation, t))};
}

bool isMoving(const RenderScene& scene) {
    return !scene.particles.empty() || !scene.chips.empty() ||
           (!scene.previousPoses.empty() && scene.previousPoses != scene.poses);
}

RenderPose poseAt(const RenderScene& scene, std::uint32_t body, double stepFraction) {
    const RenderPose& now = scene.poses[body];
    return stepFraction >= 1.0 || scene.previousPoses.empty()
               ? now
               : interpolated(scene.previousPoses[body], now, stepFraction);
}

Vec3 explodeOffset(const RenderScene& scene, std::uint32_t body) {
    return scene.explodeOffsets.empty() ? Vec3(0.0) : scene.explodeFactor * Vec3(scene.explodeOffsets[body]);
}

void setMarks(RenderScene& scene, const SceneMarks& marks) {
    SceneMarks sorted = marks;
    scene.summary.reset();
    for (std::vector<PickId>* ids : {&sorted.hidden, &sorted.selected, &sorted.hovered}) std::ranges::sort(*ids);
    std::size_t first = 0;  // body of the instance
    for (std::size_t body = 0; body < scene.picks.size(); ++body) {
        const PickId& pick = scene.picks[body];
        if (std::tie(pick.asset, pick.instance) != std::tie(scene.picks[first].asset, scene.picks[first].instance)) {
            first = body;
        }
        scene.appearances[body].outline = static_cast<std::uint32_t>(first + 1);
        scene.appearances[body].marks = (isMarked(sorted.hidden, pick) ? kHidden : 0) |
                                        (isMarked(sorted.selected, pick) ? kSelected : 0) |
                                        (isMarked(sorted.hovered, pick) ? kHovered : 0);
    }
}

Box3 boundsAt(const RenderScene& scene, std::span<const RenderPose> poses, std::uint32_t marks) {
    Box3 bounds;
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            for (std::uint32_t solid = 0; solid < batch.geometry->solidCount(); ++solid) {
                const std::uint32_t body = first + solid;
                if (marks != 0 && (scene.appearances[body].marks & marks) == 0) continue;
                includeBody(bounds, scene, body, batch.geometry->boxes[solid], poses);
            }
        }
    }
    return bounds;
}

Box3 boundsOf(const RenderScene& scene, std::uint32_t marks) {
    if (marks == 0 && scene.summary) return scene.summary->bounds;
    Box3 bounds = boundsAt(scene, scene.poses, marks);
    if (!scene.previousPoses.empty()) bounds.include(boundsAt(scene, scene.previousPoses, marks));
    return bounds;
}

Box3 boundsOfBody(const RenderScene& scene, std::uint32_t body) {
    Box3 bounds;
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            if (body < first || body - first >= batch.geometry->solidCount()) continue;
            const Box3& box = batch.geometry->boxes[body - first];
            includeBody(bounds, scene, body, box, scene.poses);
            if (!scene.previousPoses.empty()) includeBody(bounds, scene, body, box, scene.previousPoses);
        }
    }
    return bounds;
}

SceneSummary summaryOf(const RenderScene& scene) {
    if (scene.summary) return *scene.summary;
    return {boundsOf(scene), boundsAt(scene, scene.poses), boundsOf(scene, kSelected), hasTransparentSurface(scene)};
}

}  // namespace rubble
