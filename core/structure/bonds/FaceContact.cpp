#include "core/structure/bonds/FaceContact.h"

#include "core/geometry/polygon/AreaMoments.h"
#include "core/geometry/polygon/HalfPlaneClip.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rubble {
namespace {

/// Coordinates in a plane, counter-clockwise seen from where the normal points.
struct PlaneFrame {
    Vec3 origin{0.0};
    Vec3 normal{0.0};
    Vec3 along{0.0};
    Vec3 across{0.0};

    PlaneFrame(Vec3 at, Vec3 up) : origin(at), normal(up) {
        // Of the axes the one that is farthest from the normal.
        Vec3 axis{1.0, 0.0, 0.0};
        if (std::abs(up.y) < std::abs(up.x) && std::abs(up.y) <= std::abs(up.z))
            axis = {0.0, 1.0, 0.0};
        else if (std::abs(up.z) < std::abs(up.x))
            axis = {0.0, 0.0, 1.0};
        along = glm::normalize(glm::cross(axis, up));
        across = glm::cross(up, along);
    }
    Vec2 project(Vec3 point) const { return {glm::dot(point - origin, along), glm::dot(point - origin, across)}; }
    Vec3 point(Vec2 at) const { return origin + at.x * along + at.y * across; }
};

/// A face of a polytope.
struct FaceOf {
    const Polytope& polytope;
    std::size_t face;

    Vec3 normal() const { return polytope.planes[face].normal; }
    Ring projected(const PlaneFrame& frame) const {
        Ring ring;
        for (const std::uint32_t vertex : polytope.faces[face])
            ring.push_back(frame.project(polytope.vertices[vertex]));
        return ring;
    }
    /// How far the face is from a point along a direction, m.
    double heightAt(Vec3 point, Vec3 direction) const {
        return (polytope.planes[face].offset - glm::dot(normal(), point)) / glm::dot(normal(), direction);
    }
    /// The depth of the polytope behind the face, m.
    double depth() const {
        double least = std::numeric_limits<double>::max();
        for (const Vec3& vertex : polytope.vertices) least = std::min(least, glm::dot(normal(), vertex));
        return polytope.planes[face].offset - least;
    }
};

/// The common area of two convex counter-clockwise rings.
Ring overlapOf(Ring ring, const Ring& by) {
    Ring clipped;
    for (std::size_t k = 0; k < by.size() && !ring.empty(); ++k) {
        const Vec2 from = by[k], to = by[k + 1 < by.size() ? k + 1 : 0];
        const Vec2 outwards = -perpendicular(to - from);
        clipByHalfPlane(ring, {outwards, glm::dot(outwards, from)}, clipped);
        std::swap(ring, clipped);
    }
    return ring;
}

std::optional<FaceContact> contactOfFaces(const FaceOf& first, const FaceOf& second, double tolerance) {
    const Vec3 normal = glm::normalize(first.normal() - second.normal());
    const PlaneFrame frame(first.polytope.vertices[first.polytope.faces[first.face][0]], normal);
    Ring ofSecond = second.projected(frame);
    std::ranges::reverse(ofSecond);  // it faces the other way
    const AreaMoments moments = momentsOf({overlapOf(first.projected(frame), ofSecond), {}});
    if (!(moments.area > 0.0)) return std::nullopt;
    const Vec3 middle = frame.point(moments.centre);
    const double below = first.heightAt(middle, normal), above = second.heightAt(middle, normal);
    const double gap = above - below;
    if (!(std::abs(gap) <= tolerance)) return std::nullopt;
    if (gap < 0.0 && -gap > std::min(first.depth(), second.depth()) / 2.0) return std::nullopt;
    const Mat3 mixed = glm::outerProduct(frame.along, frame.across);
    return FaceContact{moments.area, middle + (below + above) / 2.0 * normal, normal,
                       moments.xx * glm::outerProduct(frame.along, frame.along) +
                           moments.xy * (mixed + glm::transpose(mixed)) +
                           moments.yy * glm::outerProduct(frame.across, frame.across)};
}

}  // namespace

std::optional<FaceContact> faceContact(const Polytope& first, const Polytope& second, double tolerance,
                                       double leastArea) {
    std::vector<FaceContact> contacts;
    for (std::size_t i = 0; i < first.faces.size(); ++i) {
        for (std::size_t j = 0; j < second.faces.size(); ++j) {
            if (-glm::dot(first.planes[i].normal, second.planes[j].normal) < kMinFacing) continue;
            if (const auto contact = contactOfFaces({first, i}, {second, j}, tolerance)) contacts.push_back(*contact);
        }
    }
    const std::optional<FaceContact> contact = combinedContact(contacts);
    return contact && contact->area >= leastArea ? contact : std::nullopt;
}

std::optional<FaceContact> combinedContact(std::span<const FaceContact> contacts) {
    constexpr double kVanished = 1e-9;  // of the area
    if (contacts.empty()) return std::nullopt;
    if (contacts.size() == 1) return contacts[0];
    FaceContact sum;
    const Vec3 origin = contacts[0].centroid;  // keeps the digits of the centroid
    Vec3 first{0.0}, normal{0.0};
    for (const FaceContact& contact : contacts) {
        sum.area += contact.area;
        first += contact.area * (contact.centroid - origin);
        normal += contact.area * contact.normal;
    }
    sum.centroid = origin + first / sum.area;
    sum.normal = glm::length(normal) > kVanished * sum.area ? glm::normalize(normal) : contacts[0].normal;
    for (const FaceContact& contact : contacts) {
        const Vec3 arm = contact.centroid - sum.centroid;
        sum.moments += contact.moments + contact.area * glm::outerProduct(arm, arm);
    }
    return sum;
}

}  // namespace rubble
