#include "viewport/scene/BodiesWithin.h"

#include <glm/vec4.hpp>

#include <optional>

namespace rubble {
namespace {

/// Where a point of the world is seen, in pixels; nothing where it lies behind the eye.
std::optional<Vec2> pixelOf(Vec3 point, const CameraMatrices& matrices, PictureSize size) {
    const glm::dvec4 clip = matrices.projection * (matrices.view * glm::dvec4(point, 1.0));
    if (clip.w <= 0.0) return std::nullopt;
    return Vec2(size.width * (0.5 + 0.5 * clip.x / clip.w), size.height * (0.5 - 0.5 * clip.y / clip.w));
}

bool isWithin(Vec2 pixel, const Box2& box) {
    return pixel.x >= box.min.x && pixel.x <= box.max.x && pixel.y >= box.min.y && pixel.y <= box.max.y;
}

/// The middle of a body's box, relative to the scene's origin.
Vec3 middleOf(const DrawnPose& motion, const Box3& box) {
    const Quat turn(glm::quat(motion.orientation.w, motion.orientation.x, motion.orientation.y, motion.orientation.z));
    return Vec3(motion.position) + (1.0 - static_cast<double>(motion.position.w)) * (turn * box.centre());
}

}  // namespace

std::vector<std::uint32_t> bodiesWithin(const RenderScene& scene, const Camera& camera, PictureSize size,
                                        const Box2& pixels, double moment) {
    const CameraMatrices matrices = matricesOf(camera, size, scene.origin, boundsOf(scene));
    std::vector<std::uint32_t> bodies;
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            for (std::uint32_t piece = 0; piece < batch.geometry->pieceCount(); ++piece) {
                const std::uint32_t body = first + piece;
                if ((scene.looks[body].marks & kHidden) != 0) continue;
                const Vec3 middle =
                    movedApart(scene, body) + middleOf(poseAt(scene, body, moment), batch.geometry->boxes[piece]);
                const std::optional<Vec2> pixel = pixelOf(middle, matrices, size);
                if (pixel && isWithin(*pixel, pixels)) bodies.push_back(body);
            }
        }
    }
    return bodies;
}

}  // namespace rubble
