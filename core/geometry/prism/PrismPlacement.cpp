#include "core/geometry/prism/PrismPlacement.h"

#include "core/geometry/polygon/OutlineCleaning.h"
#include "core/geometry/polygon/PolygonFaults.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// The inverse of the power of ten that numbers are rounded to, at most a hundredth of the tolerance.
double decimalsOf(double tolerance) {
    double decimals = 1.0;
    while (decimals * tolerance < 100.0) decimals *= 10.0;
    return decimals;
}

/// Rounds; never returns -0.
double rounded(double value, double decimals) { return std::round(value * decimals) / decimals + 0.0; }

/// The direction of the outline's longest edge; nothing if an edge is along x or y.
std::optional<Vec2> longestEdge(const Polygon& outline, double tolerance) {
    std::optional<Vec2> longest;
    for (std::size_t i = 0; i < outline.outer.size(); ++i) {
        const Vec2 edge = outline.outer[(i + 1) % outline.outer.size()] - outline.outer[i];
        if (std::min(std::abs(edge.x), std::abs(edge.y)) <= tolerance) return std::nullopt;
        if (!longest || glm::length(edge) > glm::length(*longest) + tolerance) longest = edge;
    }
    return longest;
}

/// The frame rotated about its z by at most 45 degrees, so that the direction is along its x or y.
ViewFrame rotatedTo(ViewFrame frame, Vec2 direction) {
    direction = glm::normalize(direction);
    if (std::abs(direction.y) > std::abs(direction.x)) direction = -perpendicular(direction);
    if (direction.x < 0.0) direction = -direction;
    const Vec3 x = direction.x * frame.x + direction.y * frame.y;
    frame.y = glm::normalize(direction.x * frame.y - direction.y * frame.x);
    frame.x = glm::normalize(x);
    return frame;
}

/// Moves the centre of the outline's bounding box to the origin, and rounds.
void moveToOrigin(Polygon& outline, Vec2 middle, double decimals) {
    const auto move = [&](Ring& ring) {
        for (Vec2& corner : ring)
            corner = {rounded(corner.x - middle.x, decimals), rounded(corner.y - middle.y, decimals)};
    };
    move(outline.outer);
    for (Ring& hole : outline.holes) move(hole);
}

}  // namespace

std::optional<ViewFrame> frameAlongEdge(const ViewFrame& frame, const Polygon& outline, double tolerance) {
    const std::optional<Vec2> edge = longestEdge(outline, tolerance);
    if (!edge) return std::nullopt;
    return rotatedTo(frame, *edge);
}

Result<PrismFit> placedPrism(const AxisView& view, Polygon outline, double tolerance) {
    const double decimals = decimalsOf(tolerance);
    const Box2 box = boundsOf(outline.outer);
    const Vec2 middle = box.min + box.size() / 2.0;
    moveToOrigin(outline, middle, decimals);
    Result<Polygon> checked = validated(fromSmallestCorners(std::move(outline)));
    if (!checked) return checked.error();

    const ViewFrame& frame = view.frame;
    const double height = view.bottom + view.depth() / 2.0;
    const Vec3 position = frame.origin + middle.x * frame.x + middle.y * frame.y + height * frame.z;
    PrismFit prism{.outline = std::move(*checked), .depth = rounded(view.depth(), decimals), .axis = frame.z};
    prism.pose.orientation = glm::normalize(glm::quat_cast(Mat3(frame.x, frame.y, frame.z)));
    for (int k = 0; k < 3; ++k) prism.pose.position[k] = rounded(position[k], decimals);
    return prism;
}

}  // namespace rubble
