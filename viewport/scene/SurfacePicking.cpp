#include "viewport/scene/SurfacePicking.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace rubble {
namespace {

constexpr std::array<std::uint8_t, 2> kMiddleOfFace{128, 128};  // see SceneVertex::across
constexpr double kSamePixel = 0.5;

/// The transform between a body's frame and the world, as it is drawn.
class BodyFrame {
public:
    BodyFrame(const RenderScene& scene, std::uint32_t body, double stepFraction = 1.0) {
        const RenderPose pose = poseAt(scene, body, stepFraction);
        m_rotation = Quat(glm::quat(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z));
        m_scale = 1.0 - static_cast<double>(pose.position.w);
        m_position = scene.origin + Vec3(pose.position) + explodeOffset(scene, body);
    }
    bool isPoint() const { return !(m_scale > 0.0); }
    Vec3 world(Vec3 local) const { return m_position + m_scale * (m_rotation * local); }
    Vec3 worldNormal(Vec3 local) const { return m_rotation * local; }
    /// The ray in the body's frame: its distances times scale() are distances in the world.
    Ray local(const Ray& ray) const {
        const Quat back = glm::conjugate(m_rotation);
        return {(back * (ray.from - m_position)) / m_scale, back * ray.direction};
    }
    double scale() const { return m_scale; }

private:
    Quat m_rotation;
    double m_scale = 1.0;
    Vec3 m_position{0.0, 0.0, 0.0};
};

/// The distance along a ray to a box, 0 from inside; infinite if it misses.
double distanceTo(const Ray& ray, const Box3& box) {
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.min[axis] - ray.from[axis]) / ray.direction[axis];
        const double b = (box.max[axis] - ray.from[axis]) / ray.direction[axis];
        if (std::isnan(a) || std::isnan(b)) continue;  // within the plane of a side
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

/// The distance along a ray to the front of a triangle; infinite if it misses.
double distanceTo(const Ray& ray, Vec3 a, Vec3 b, Vec3 c) {
    constexpr double kMissed = std::numeric_limits<double>::infinity();
    const Vec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    if (!(determinant > 0.0)) return kMissed;
    const Vec3 from = ray.from - a;
    const double u = glm::dot(from, p);
    const Vec3 q = glm::cross(from, ab);
    const double v = glm::dot(ray.direction, q), distance = glm::dot(ac, q) / determinant;
    const bool isInside = u >= 0.0 && v >= 0.0 && u + v <= determinant && distance >= 0.0;
    return isInside ? distance : kMissed;
}

/// A body whose box a ray meets.
struct Candidate {
    const SceneGeometry* geometry = nullptr;
    std::uint32_t body = 0, solid = 0;
    Ray ray;                // in the body's frame
    double scale = 1.0;     // distances in the world ÷ those in the body's frame
    double distance = 0.0;  // of its box, m, in the world
};

std::vector<Candidate> candidates(const RenderScene& scene, const Ray& ray, double stepFraction) {
    std::vector<Candidate> found;
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            for (std::uint32_t solid = 0; solid < batch.geometry->solidCount(); ++solid) {
                const std::uint32_t body = first + solid;
                if ((scene.appearances[body].marks & kHidden) != 0) continue;
                const BodyFrame frame(scene, body, stepFraction);
                if (frame.isPoint()) continue;
                const Ray local = frame.local(ray);
                const double distance = frame.scale() * distanceTo(local, batch.geometry->boxes[solid]);
                if (std::isfinite(distance))
                    found.push_back({batch.geometry.get(), body, solid, local, frame.scale(), distance});
            }
        }
    }
    return found;
}

/// The distance to the front of a solid, in its frame; infinite if the ray misses it.
double distanceTo(const Ray& ray, const SceneGeometry& geometry, std::uint32_t solid) {
    double nearest = std::numeric_limits<double>::infinity();
    const TriangleRange range = geometry.indicesOf(solid);
    const auto corner = [&](std::size_t k) { return Vec3(geometry.vertices[geometry.indices[k]].position); };
    for (std::size_t k = range.begin; k < range.end; k += 3)
        nearest = std::min(nearest, distanceTo(ray, corner(k), corner(k + 1), corner(k + 2)));
    return nearest;
}

}  // namespace

std::optional<SurfaceHit> surfaceHit(const RenderScene& scene, const Ray& ray, double stepFraction) {
    std::vector<Candidate> all = candidates(scene, ray, stepFraction);
    std::ranges::sort(all, [](const Candidate& a, const Candidate& b) {
        return std::tie(a.distance, a.body) < std::tie(b.distance, b.body);
    });
    std::optional<SurfaceHit> found;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : all) {
        if (candidate.distance >= nearest) break;
        const double distance = candidate.scale * distanceTo(candidate.ray, *candidate.geometry, candidate.solid);
        if (!(distance < nearest)) continue;
        nearest = distance;
        found = {candidate.body, ray.at(distance)};
    }
    return found;
}

std::optional<Vec3> cornerNear(const RenderScene& scene, std::uint32_t body, const Camera& camera, ImageSize size,
                               Vec2 pixel, double radius) {
    std::optional<Vec3> found;
    double nearest = radius, depth = std::numeric_limits<double>::infinity();
    const Vec3 back = axesOf(camera).back, eye = eyeOf(camera);
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            if (body < first || body >= first + batch.geometry->solidCount()) continue;
            const BodyFrame frame(scene, body);
            const TriangleRange range = batch.geometry->indicesOf(body - first);
            for (std::size_t k = range.begin; k < range.end; ++k) {
                const SceneVertex& vertex = batch.geometry->vertices[batch.geometry->indices[k]];
                if (vertex.across == kMiddleOfFace) continue;
                const Vec3 point = frame.world(Vec3(vertex.position));
                const Vec3 towardsEye = camera.projection == Projection::Orthographic ? back : eye - point;
                if (glm::dot(frame.worldNormal(Vec3(vertex.normal)), towardsEye) <= 0.0) continue;
                const std::optional<Vec2> seen = pixelOf(camera, point, size);
                if (!seen) continue;
                const double apart = glm::distance(*seen, pixel), far = -glm::dot(point, back);
                const bool isNearer = apart < nearest - kSamePixel || (apart <= nearest + kSamePixel && far < depth);
                if (apart > radius || !isNearer) continue;
                nearest = std::min(apart, nearest);
                depth = far;
                found = point;
            }
        }
    }
    return found;
}

}  // namespace rubble
