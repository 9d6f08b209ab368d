#include "viewport/scene/ProblemCamera.h"

#include "viewport/scene/SurfacePicking.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

constexpr int kAzimuths = 12;
constexpr double kElevations[] = {20.0, 50.0, 80.0, -20.0, -50.0, -80.0};  // degrees
constexpr double kLift = 1e-3;          // of the framed diagonal, by which lines of sight start above the surface
constexpr double kInsideSight = 0.3;    // how much it counts that the camera sees a point from within a mesh
constexpr double kGoodEnough = 0.75;    // of the best score, for which the camera does not move
constexpr std::size_t kMaxPoints = 12;  // that are looked at
constexpr std::size_t kMaxTests = 60'000'000;  // of lines of sight with triangles, about half a second

bool contains(const Box3& box, Vec3 point) {
    return glm::all(glm::greaterThanEqual(point, box.min)) && glm::all(glm::lessThanEqual(point, box.max));
}

bool overlap(const Box3& a, const Box3& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

/// At least the place of a problem, and at most `count` points that are marked in the box to frame, evenly spread.
std::vector<Vec3> markedPoints(const MeshProblem& problem, const Box3& framed, std::size_t count) {
    std::vector<Vec3> all;
    for (const auto& [a, b, c] : problem.triangles) all.push_back((a + b + c) / 3.0);
    for (const auto& [from, to] : problem.edges) all.push_back((from + to) / 2.0);
    std::erase_if(all, [&](Vec3 point) { return !contains(framed, point); });
    if (all.empty()) all.push_back(problem.place);
    std::vector<Vec3> points;
    const std::size_t taken = std::min(count, all.size());
    for (std::size_t k = 0; k < taken; ++k) points.push_back(all[k * all.size() / taken]);
    return points;
}

/// The mean normal of the triangles that are in a box or near it, of length 1; zero if there are none.
Vec3 meanNormal(const SourceModel& model, const Box3& box) {
    const SceneGeometry& geometry = *model.geometry;
    Vec3 sum(0.0);
    for (std::size_t k = 0; k < geometry.indices.size(); k += 3) {
        const SceneVertex& first = geometry.vertices[geometry.indices[k]];
        if (first.side == VertexSide::Inside) continue;  // the back of a triangle
        Box3 bounds;
        for (std::size_t corner = k; corner < k + 3; ++corner)
            bounds.include(model.origin + Vec3(geometry.vertices[geometry.indices[corner]].position));
        if (overlap(bounds, box)) sum += Vec3(first.normal);
    }
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : Vec3(0.0);
}

/// How well directions show the place of a problem.
class Sight {
public:
    Sight(const MeshProblem& problem, const SourceModel& model, double fieldOfView) : m_scene(importScene(model, {})) {
        const Box3 framed = surroundingsOf(problem, model);
        const std::size_t directions = 1 + kAzimuths * std::size(kElevations);
        const std::size_t triangles = std::max<std::size_t>(1, model.geometry->indices.size() / 3);
        const std::size_t affordable = kMaxTests / directions / triangles;
        m_points = markedPoints(problem, framed, std::clamp<std::size_t>(affordable, 1, kMaxPoints));
        m_normal = meanNormal(model, framed);
        m_lift = kLift * framed.diagonal();
        m_eyeDistance = framed.diagonal() / 2.0 / std::sin(fieldOfView / 2.0);
    }

    /// From 0, if a camera sees no marked point along its axis, to 2, if it sees all from straight above. The mesh may
    /// be inside out: what is seen is seen from outside.
    double score(const Camera& camera) const {
        const Vec3 back = axesOf(camera).back;
        double seen = 0.0;
        for (const Vec3 point : m_points) {
            const Vec3 from = point + m_lift * back;
            const auto hit = surfaceHit(m_scene, {from, back});
            seen += !hit ? 1.0 : glm::distance(hit->point, from) > m_eyeDistance ? kInsideSight : 0.0;
        }
        return seen / static_cast<double>(m_points.size()) * (1.0 + std::abs(glm::dot(m_normal, back)));
    }

private:
    RenderScene m_scene;
    std::vector<Vec3> m_points;
    Vec3 m_normal{0.0};
    double m_lift = 0.0;         // m
    double m_eyeDistance = 0.0;  // m, once the place is framed
};

}  // namespace

Camera facing(const MeshProblem& problem, const SourceModel& model, Camera camera) {
    const Sight sight(problem, model, camera.fieldOfView);
    const double present = sight.score(camera);
    Camera best = camera;
    double bestScore = present;
    for (const double elevation : kElevations) {
        for (int k = 0; k < kAzimuths; ++k) {
            Camera candidate = camera;
            candidate.azimuth += 2.0 * std::numbers::pi * k / kAzimuths;
            candidate.elevation = glm::radians(elevation);
            const double score = sight.score(candidate);
            if (!(score > bestScore)) continue;
            best = candidate;
            bestScore = score;
        }
    }
    return present < kGoodEnough * bestScore ? best : camera;
}

}  // namespace rubble
