#include "viewport/scene/BodiesWithin.h"

#include <glm/vec4.hpp>

#include <optional>

namespace rubble {
namespace {

/// Projects a point of the scene to pixels; nothing if it lies behind the camera.
std::optional<Vec2> pixelOf(Vec3 point, const CameraMatrices& matrices, ImageSize size) {
    const glm::dvec4 clip = matrices.projection * (matrices.view * glm::dvec4(point, 1.0));
    if (clip.w <= 0.0) return std::nullopt;
    return Vec2(size.width * (0.5 + 0.5 * clip.x / clip.w), size.height * (0.5 - 0.5 * clip.y / clip.w));
}

bool isWithin(Vec2 pixel, const Box2& box) {
    return pixel.x >= box.min.x && pixel.x <= box.max.x && pixel.y >= box.min.y && pixel.y <= box.max.y;
}

/// The centre of a body's box, relative to the scene's origin.
Vec3 centreOf(const RenderPose& pose, const Box3& box) {
    const Quat rotation(glm::quat(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z));
    return Vec3(pose.position) + (1.0 - static_cast<double>(pose.position.w)) * (rotation * box.centre());
}

}  // namespace

std::vector<std::uint32_t> bodiesWithin(const RenderScene& scene, const Camera& camera, ImageSize size,
                                        const Box2& pixels, double stepFraction) {
    const CameraMatrices matrices = matricesOf(camera, size, scene.origin, boundsOf(scene));
    std::vector<std::uint32_t> bodies;
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            for (std::uint32_t solid = 0; solid < batch.geometry->solidCount(); ++solid) {
                const std::uint32_t body = first + solid;
                if ((scene.appearances[body].marks & kHidden) != 0) continue;
                const Vec3 centre = explodeOffset(scene, body) +
                                    centreOf(poseAt(scene, body, stepFraction), batch.geometry->boxes[solid]);
                const std::optional<Vec2> pixel = pixelOf(centre, matrices, size);
                if (pixel && isWithin(*pixel, pixels)) bodies.push_back(body);
            }
        }
    }
    return bodies;
}

}  // namespace rubble
