#include "core/physics/queries/BlastPressure.h"
#include "core/physics/queries/VisibleFaces.h"
#include "core/physics/state/WorldState.h"
#include "core/physics/world/World.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kTouchDistance = 1e-3;  // m: the accuracy of hulls, see makeHull()
constexpr double kStandOff = 0.1;        // m: of a blast from the body it was in

/// A hull in world space.
struct WorldHull {
    const Hull* hull;
    Mat3 rotation;
    Vec3 centre;  // of the hull's origin

    Vec3 toLocal(Vec3 point) const { return glm::transpose(rotation) * (point - centre); }
    double height(std::size_t face, Vec3 local) const {
        const HullPlane& plane = hull->planes[face];
        return glm::dot(toDouble(plane.normal), local) - static_cast<double>(plane.offset);
    }
    bool contains(Vec3 point) const {
        const Vec3 local = toLocal(point);
        for (std::size_t face = 0; face < hull->planes.size(); ++face) {
            if (height(face, local) > kTouchDistance) return false;
        }
        return true;
    }
};

/// The hulls that contain a point or are within kTouchDistance of it.
std::vector<WorldHull> hullsAt(const WorldState& state, Vec3 point) {
    std::vector<WorldHull> found;
    for (std::uint32_t body = 1; body < state.bodies.size(); ++body) {
        const Shape* shape = state.bodies[body].shape.get();
        if (shape == nullptr) continue;
        const Vec3 centre = toDouble(state.poses[body].centre);
        if (glm::distance(centre, point) > static_cast<double>(shape->boundingRadius) + kTouchDistance) continue;
        const Mat3 rotation = glm::mat3_cast(glm::normalize(toDouble(state.poses[body].rotation)));
        for (const PlacedHull& hull : shape->hulls) {
            const WorldHull placed{hull.hull, rotation, centre + rotation * toDouble(hull.offset)};
            if (placed.contains(point)) found.push_back(placed);
        }
    }
    return found;
}

/// A place off a face of a hull that contains a point.
struct StandOff {
    double depth = 0.0;  // m: of the point below the face
    Vec3 place;
};

std::vector<StandOff> standOffs(const std::vector<WorldHull>& hulls, Vec3 point) {
    std::vector<StandOff> places;
    for (const WorldHull& placed : hulls) {
        const Vec3 local = placed.toLocal(point);
        for (std::size_t face = 0; face < placed.hull->planes.size(); ++face) {
            const double depth = -placed.height(face, local);
            const Vec3 normal = placed.rotation * toDouble(placed.hull->planes[face].normal);
            places.push_back({depth, point + (depth + kStandOff) * normal});
        }
    }
    std::ranges::stable_sort(places, {}, &StandOff::depth);
    return places;
}

}  // namespace

Vec3 World::blastOrigin(Vec3 point) const {
    const std::vector<StandOff> places = standOffs(hullsAt(*m_state, point), point);
    if (places.empty()) return point;
    const auto isFree = [&](const StandOff& standOff) { return hullsAt(*m_state, standOff.place).empty(); };
    auto best = std::ranges::find_if(places, isFree);
    if (best == places.end()) return places.front().place;
    const Vec3 down = gravity() == Vec3(0.0) ? Vec3(0.0, -1.0, 0.0) : gravity();
    const double most = best->depth + kTouchDistance;
    for (auto other = best + 1; other != places.end() && other->depth <= most; ++other) {
        const bool isLower = glm::dot(other->place - best->place, down) > 0.0;
        if (isLower && isFree(*other)) best = other;
    }
    return best->place;
}

std::vector<BlastImpulse> World::blast(Vec3 point, double radius, double impulse) const {
    std::vector<BlastImpulse> impulses;
    if (!(radius > 0.0)) return impulses;
    const BlastPressure pressure{impulse, radius};
    std::uint32_t current = 0;
    BlastSum sum;
    const auto finishBody = [&] {
        const double length = glm::length(sum.impulse);
        if (length > 0.0) {
            const Vec3 direction = sum.impulse / length;
            const double distance = glm::dot(direction, sum.weightedPoint) / sum.size;
            impulses.push_back({m_state->idOf(current), point + distance * direction, sum.impulse});
        }
        sum = {};
    };
    visitVisibleFaces(*m_state, point, radius, [&](std::uint32_t body, const FacePolygon& part) {
        if (body != current) finishBody();
        current = body;
        addBlastOn(part, pressure, sum);
    });
    finishBody();
    return impulses;
}

}  // namespace rubble
