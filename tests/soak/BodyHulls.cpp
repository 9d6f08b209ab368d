#include "tests/soak/BodyHulls.h"

#include "core/geometry/hull/HullOverlap.h"

#include <algorithm>

namespace rubble::soak {
namespace {

bool isApart(const Box3& a, const Box3& b) {
    return glm::any(glm::lessThan(a.max, b.min)) || glm::any(glm::lessThan(b.max, a.min));
}

bool contains(const Polytope& hull, Vec3 point) {
    return std::ranges::all_of(hull.planes,
                               [&](const Plane& plane) { return glm::dot(plane.normal, point) <= plane.offset; });
}

/// The part of a segment deeper than `depth` in a hull, as fractions.
/// Source: Cyrus, Beck 1978.
std::pair<double, double> clipped(const Polytope& hull, Vec3 from, Vec3 to, double depth) {
    double enter = 0.0, leave = 1.0;
    for (const Plane& plane : hull.planes) {
        const double start = glm::dot(plane.normal, from) - plane.offset + depth;
        const double end = glm::dot(plane.normal, to) - plane.offset + depth;
        if (start > 0.0 && end > 0.0) return {1.0, 0.0};
        if (start > 0.0) enter = std::max(enter, start / (start - end));
        if (end > 0.0) leave = std::min(leave, start / (start - end));
    }
    return {enter, leave};
}

Vec3 inFrame(const Pose& pose, Vec3 point) { return glm::conjugate(pose.orientation) * (point - pose.position); }

/// Whether a face of the first shows that the second overlaps it by no more than `depth`, m.
bool isAbove(const Polytope& first, const Pose& firstPose, const Polytope& second, const Pose& secondPose,
             double depth) {
    std::vector<Vec3> points;
    for (const Vec3& vertex : second.vertices)
        points.push_back(inFrame(firstPose, secondPose.position + secondPose.orientation * vertex));
    return std::ranges::any_of(first.planes, [&](const Plane& plane) {
        return std::ranges::all_of(
            points, [&](const Vec3& point) { return glm::dot(plane.normal, point) >= plane.offset - depth; });
    });
}

/// Quicker than their overlap, which takes all pairs of edges.
bool isShallow(const Polytope& first, const Pose& firstPose, const Polytope& second, const Pose& secondPose,
               double depth) {
    return isAbove(first, firstPose, second, secondPose, depth) || isAbove(second, secondPose, first, firstPose, depth);
}

}  // namespace

BodyHulls::Posed BodyHulls::of(const BodyFacts& facts) {
    Known& known = m_known[facts.body.number];
    if (known.hulls.empty() || known.nodes != facts.body.nodes.size() || known.fragment != facts.body.fragment) {
        known = {facts.body.nodes.size(), facts.body.fragment, hullsOf(facts.body)};
    }
    Posed posed{&known.hulls, facts.state.pose, {}};
    for (const Polytope& hull : known.hulls) {
        for (const Vec3& vertex : hull.vertices)
            posed.box.include(posed.pose.position + posed.pose.orientation * vertex);
    }
    return posed;
}

void BodyHulls::keepOnly(const Moment& moment) {
    std::erase_if(m_known, [&](const auto& entry) { return moment.find(entry.first) == nullptr; });
}

double overlapDepth(const BodyHulls::Posed& first, const BodyHulls::Posed& second, double least) {
    if (isApart(first.box, second.box)) return 0.0;
    double depth = least;
    for (const Polytope& one : *first.hulls) {
        for (const Polytope& other : *second.hulls) {
            if (isShallow(one, first.pose, other, second.pose, depth)) continue;
            depth = std::max(depth, hullOverlap(one, first.pose, other, second.pose).depth);
        }
    }
    return depth > least ? depth : 0.0;
}

bool contains(const BodyHulls::Posed& body, Vec3 point) {
    const Vec3 local = inFrame(body.pose, point);
    return std::ranges::any_of(*body.hulls, [&](const Polytope& hull) { return contains(hull, local); });
}

double lengthThrough(const BodyHulls::Posed& body, Vec3 from, Vec3 to, double depth) {
    const Vec3 start = inFrame(body.pose, from), end = inFrame(body.pose, to);
    double length = 0.0;
    for (const Polytope& hull : *body.hulls) {
        const auto [enter, leave] = clipped(hull, start, end, depth);
        if (enter > 0.0 && leave < 1.0 && leave > enter) length += (leave - enter) * glm::distance(start, end);
    }
    return length;
}

}  // namespace rubble::soak
