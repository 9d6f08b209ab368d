#include "core/geometry/PrismFinder.h"

#include "core/geometry/AxisView.h"
#include "core/geometry/OutlineCleaning.h"
#include "core/geometry/PrismAxes.h"
#include "core/geometry/PrismFault.h"
#include "core/geometry/PrismPlacing.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

namespace rubble {
namespace {

int worldAxis(AxisChoice choice) { return static_cast<int>(choice) - static_cast<int>(AxisChoice::X); }

std::size_t cornersOf(const std::vector<Ring>& rings) {
    return std::accumulate(rings.begin(), rings.end(), std::size_t{0},
                           [](std::size_t sum, const Ring& ring) { return sum + ring.size(); });
}

std::size_t cornersOf(const Polygon& polygon) { return polygon.outer.size() + cornersOf(polygon.holes); }

/// What came of looking along an axis.
struct Attempt {
    Vec3 axis;
    Result<FoundPrism> prism;
    int caps = 0;            // ends of the axis with a flat face
    double misplaced = 0.0;  // m; how far some face would have to move to be part of a cap or a side
};

/// The farthest that a point lies from the surface of the prism with an outline, those within the caps apart.
double deviationFrom(const AxisView& view, const Polygon& outline, double tolerance) {
    double farthest = 0.0;
    for (const Vec3 point : view.points) {
        const double fromCap = std::min(std::abs(point.z - view.top), std::abs(point.z - view.bottom));
        farthest =
            std::max(farthest, fromCap <= tolerance ? fromCap : distanceFromBoundary(outline, {point.x, point.y}));
    }
    return farthest;
}

/// The prism in a view where nothing leans.
Result<FoundPrism> prismIn(const AxisView& view, const TriangleMesh& mesh, double tolerance) {
    const std::vector<Ring> rings = boundaryOf(view, mesh, FaceLie::Top);
    const Result<Polygon> outline = outlineOf(rings, tolerance);
    if (!outline) return outline.error();
    std::vector<Ring> bottomRings = boundaryOf(view, mesh, FaceLie::Bottom);
    for (Ring& ring : bottomRings) std::ranges::reverse(ring);
    const Result<Polygon> bottom = outlineOf(bottomRings, tolerance);
    if (!bottom) return bottom.error();
    if (distanceBetween(*outline, *bottom) > 4.0 * tolerance)
        return Error{ErrorCode::Degenerate, prismFault(view, mesh, tolerance)};
    const double deviation = deviationFrom(view, *outline, tolerance);
    if (deviation > 4.0 * tolerance)
        return Error{ErrorCode::Degenerate, "The sides bulge by " + lengthText(deviation) + " between the caps."};

    if (const std::optional<ViewFrame> frame = frameAlongEdge(view.frame, *outline, tolerance))
        return prismIn(viewedAlong(mesh, *frame, tolerance), mesh, tolerance);
    Result<FoundPrism> prism = placedPrism(view, *outline, tolerance);
    if (!prism) return prism;
    prism->deviation =
        std::max({deviation, distanceFromBoundary(*outline, rings), distanceFromBoundary(*outline, bottomRings)});
    prism->straightCorners = cornersOf(rings) - cornersOf(*outline);
    return prism;
}

/// How far a face that leans or lies between the caps would have to move to be part of one, or of a side.
double misplacement(const AxisView& view, const TriangleMesh& mesh) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (view.lies[i] != FaceLie::Leaning && view.lies[i] != FaceLie::Between) continue;
        double fromTop = 0.0, fromBottom = 0.0;
        for (const std::uint32_t corner : mesh.triangles[i]) {
            fromTop = std::max(fromTop, view.top - view.points[corner].z);
            fromBottom = std::max(fromBottom, view.points[corner].z - view.bottom);
        }
        farthest = std::max(farthest, std::min({fromTop, fromBottom, widthSeen(view, mesh, i)}));
    }
    return farthest;
}

Attempt attempt(const TriangleMesh& mesh, Vec3 axis, double tolerance) {
    const AxisView view = viewedAlong(mesh, frameAlong(axis, boundsOf(mesh).centre()), tolerance);
    const bool isStraight = !view.has(FaceLie::Leaning) && !view.has(FaceLie::Between);
    Attempt result{axis, Error{}, view.has(FaceLie::Top) + view.has(FaceLie::Bottom), misplacement(view, mesh)};
    if (result.caps == 2 && isStraight) {
        result.prism = prismIn(view, mesh, tolerance);
    } else {
        result.prism = Error{ErrorCode::Degenerate, prismFault(view, mesh, tolerance)};
    }
    return result;
}

/// z before x before y before all others.
int rankOf(Vec3 axis) {
    if (axis.z == 1.0) return 0;
    if (axis.x == 1.0) return 1;
    return axis.y == 1.0 ? 2 : 3;
}

/// How well an axis answers to what was chosen: the smaller, the better.
double distanceFromChoice(Vec3 axis, AxisChoice choice) {
    return choice == AxisChoice::Thinnest ? 0.0 : 1.0 - std::abs(axis[worldAxis(choice)]);
}

/// An axis nearer to the one chosen than to the other two.
bool answers(Vec3 axis, AxisChoice choice) {
    if (choice == AxisChoice::Thinnest) return true;
    const Vec3 size = glm::abs(axis);
    return size[worldAxis(choice)] >= std::max({size.x, size.y, size.z}) - 1e-9;
}

/// The fault along the axis that comes nearest: the most caps, along the world's axes, the least misplaced.
Error nearestFault(const TriangleMesh& mesh, AxisChoice choice, double tolerance) {
    std::optional<Attempt> best;
    const auto isWorlds = [](const Attempt& found) { return rankOf(found.axis) < 3; };
    for (const Vec3 axis : arguableAxes(mesh, tolerance)) {
        if (!answers(axis, choice)) continue;
        Attempt found = attempt(mesh, axis, tolerance);
        const auto key = [&](const Attempt& of) {
            return std::tuple(-of.caps, !isWorlds(of), of.misplaced, rankOf(of.axis));
        };
        if (!found.prism && (!best || key(found) < key(*best))) best = std::move(found);
    }
    return best ? best->prism.error() : Error{ErrorCode::Degenerate, "The mesh has no flat cap."};
}

}  // namespace

Result<FoundPrism> findPrism(const TriangleMesh& solid, AxisChoice choice, double tolerance) {
    std::vector<Attempt> found;
    for (const Vec3 axis : possibleAxes(solid, tolerance)) {
        Attempt result = attempt(solid, axis, tolerance);
        if (result.prism) found.push_back(std::move(result));
    }
    std::optional<std::size_t> best;
    const auto isBetter = [&](const Attempt& a, const Attempt& b) {
        const double nearer = distanceFromChoice(a.axis, choice) - distanceFromChoice(b.axis, choice);
        if (nearer != 0.0) return nearer < 0.0;
        const double thinner = a.prism->depth - b.prism->depth;
        return std::abs(thinner) > tolerance ? thinner < 0.0 : rankOf(a.axis) < rankOf(b.axis);
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (answers(found[i].axis, choice) && (!best || isBetter(found[i], found[*best]))) best = i;
    }
    if (!best) return nearestFault(solid, choice, tolerance);
    FoundPrism prism = *found[*best].prism;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (i != *best) prism.otherAxes.push_back(found[i].axis);
    return prism;
}

}  // namespace rubble
