#include "core/geometry/prism/PrismFit.h"

#include "core/geometry/mesh/SolidMesh.h"
#include "core/geometry/polygon/BoundaryDistance.h"
#include "core/geometry/polygon/OutlineCleaning.h"
#include "core/geometry/prism/AxisView.h"
#include "core/geometry/prism/PrismAxes.h"
#include "core/geometry/prism/PrismPlacement.h"
#include "core/geometry/prism/PrismRejection.h"
#include "core/geometry/prism/RoundedPrism.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

namespace rubble {
namespace {

int worldAxis(PrismAxis requested) { return static_cast<int>(requested) - static_cast<int>(PrismAxis::X); }

std::size_t cornerCount(const std::vector<Ring>& rings) {
    return std::accumulate(rings.begin(), rings.end(), std::size_t{0},
                           [](std::size_t sum, const Ring& ring) { return sum + ring.size(); });
}

std::size_t cornerCount(const Polygon& polygon) { return polygon.outer.size() + cornerCount(polygon.holes); }

/// The result of fitting a prism along an axis.
struct Attempt {
    Vec3 axis;
    Result<PrismFit> prism;
    int caps = 0;            // number of flat caps
    double misplaced = 0.0;  // m: the distance of some face from a cap or side
};

/// The largest distance of a point from the surface of the prism; for points on a cap, from the cap.
double deviationFrom(const AxisView& view, const Polygon& outline, double tolerance) {
    const BoundaryDistance boundary(outline);
    double farthest = 0.0;
    for (const Vec3 point : view.points) {
        const double fromCap = std::min(std::abs(point.z - view.top), std::abs(point.z - view.bottom));
        farthest = std::max(farthest, fromCap <= tolerance ? fromCap : boundary.of({point.x, point.y}));
    }
    return farthest;
}

/// How exactly a mesh has to be a prism.
struct Accuracy {
    double tolerance = 0.0;  // m
    double rounding = 0.0;   // m: the largest displacement of a point by rounding; 0: that is within the tolerance
    /// The height within which the points of a cap lie and the width within which a face is a side, m. Two points are
    /// at most two roundings apart, and the axis is not exact.
    double flatness() const { return std::max(tolerance, 3.0 * rounding); }
    double maxDeviation() const { return rounding > 0.0 ? std::max(2.0 * rounding, tolerance) : 4.0 * tolerance; }
};

double areaOf(const std::vector<Ring>& rings) {
    return std::accumulate(rings.begin(), rings.end(), 0.0,
                           [](double sum, const Ring& ring) { return sum + signedArea(ring); });
}

/// The outline of the caps. That of rounded ones lies between both, without corners that their rounding made out of
/// straight lines; all corners are kept if the area depends on them.
Result<Polygon> outlineOfCaps(const std::vector<Ring>& top, const std::vector<Ring>& bottom, const Accuracy& accuracy) {
    constexpr double kMaxAreaChange = 2e-4;
    if (!(accuracy.rounding > 0.0)) return outlineOf(top, accuracy.tolerance);
    const std::vector<Ring> middle = ringsBetween(top, bottom, accuracy.flatness());
    const double whole = areaOf(middle);
    const Result<Polygon> simple = outlineOf(middle, std::max(accuracy.rounding, accuracy.tolerance));
    if (simple && std::abs(area(*simple) - whole) <= kMaxAreaChange * whole) return simple;
    return outlineOf(middle, std::min(accuracy.rounding, accuracy.tolerance));
}

/// The view with the depth with which an outline encloses the volume of the mesh.
AxisView withVolumeOf(const TriangleMesh& mesh, AxisView view, const Polygon& outline) {
    const double middle = view.bottom + view.depth() / 2.0, depth = signedVolume(mesh) / area(outline);
    view.bottom = middle - depth / 2.0;
    view.top = middle + depth / 2.0;
    return view;
}

/// The prism of a view without oblique faces.
Result<PrismFit> prismIn(const AxisView& view, const TriangleMesh& mesh, const Accuracy& accuracy) {
    const std::vector<Ring> rings = boundaryOf(view, mesh, FaceOrientation::Top);
    std::vector<Ring> bottomRings = boundaryOf(view, mesh, FaceOrientation::Bottom);
    for (Ring& ring : bottomRings) std::ranges::reverse(ring);
    const Result<Polygon> outline = outlineOfCaps(rings, bottomRings, accuracy);
    if (!outline) return outline.error();
    const Result<Polygon> bottom = outlineOf(bottomRings, accuracy.tolerance);
    if (!bottom) return bottom.error();
    if (distanceBetween(*outline, *bottom) > accuracy.maxDeviation())
        return Error{ErrorCode::Degenerate, prismRejection(view, mesh, accuracy.tolerance)};
    const double deviation = deviationFrom(view, *outline, accuracy.flatness());
    if (deviation > accuracy.maxDeviation())
        return Error{ErrorCode::Degenerate, "The sides bulge by " + lengthText(deviation) + " between the caps."};

    if (const std::optional<ViewFrame> frame = frameAlongEdge(view.frame, *outline, accuracy.tolerance))
        return prismIn(viewAlong(mesh, *frame, accuracy.flatness()), mesh, accuracy);
    Result<PrismFit> prism =
        placedPrism(accuracy.rounding > 0.0 ? withVolumeOf(mesh, view, *outline) : view, *outline, accuracy.tolerance);
    if (!prism) return prism;
    const BoundaryDistance boundary(*outline);
    prism->deviation = std::max({deviation, boundary.largestOf(rings), boundary.largestOf(bottomRings)});
    prism->collinearCorners = cornerCount(rings) - cornerCount(*outline);
    return prism;
}

/// The largest distance of an oblique or intermediate face from a cap or side.
double misplacement(const AxisView& view, const TriangleMesh& mesh) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (view.orientations[i] != FaceOrientation::Oblique && view.orientations[i] != FaceOrientation::Between)
            continue;
        double fromTop = 0.0, fromBottom = 0.0;
        for (const std::uint32_t corner : mesh.triangles[i]) {
            fromTop = std::max(fromTop, view.top - view.points[corner].z);
            fromBottom = std::max(fromBottom, view.points[corner].z - view.bottom);
        }
        farthest = std::max(farthest, std::min({fromTop, fromBottom, projectedWidth(view, mesh, i)}));
    }
    return farthest;
}

Attempt fitAlong(const TriangleMesh& mesh, Vec3 axis, const Accuracy& accuracy) {
    const AxisView view = viewAlong(mesh, frameAlong(axis, boundsOf(mesh).centre()), accuracy.flatness());
    const bool isStraight = !view.has(FaceOrientation::Oblique) && !view.has(FaceOrientation::Between);
    Attempt result{axis, Error{}, view.has(FaceOrientation::Top) + view.has(FaceOrientation::Bottom),
                   misplacement(view, mesh)};
    if (result.caps == 2 && isStraight) {
        result.prism = prismIn(view, mesh, accuracy);
    } else {
        result.prism = Error{ErrorCode::Degenerate, prismRejection(view, mesh, accuracy.tolerance)};
    }
    return result;
}

/// The order of axes: z, x, y, others.
int rankOf(Vec3 axis) {
    if (axis.z == 1.0) return 0;
    if (axis.x == 1.0) return 1;
    return axis.y == 1.0 ? 2 : 3;
}

/// The deviation of an axis from the requested one.
double distanceFromRequest(Vec3 axis, PrismAxis requested) {
    return requested == PrismAxis::Thinnest ? 0.0 : 1.0 - std::abs(axis[worldAxis(requested)]);
}

/// Whether the requested world axis is the nearest to an axis.
bool matches(Vec3 axis, PrismAxis requested) {
    if (requested == PrismAxis::Thinnest) return true;
    const Vec3 size = glm::abs(axis);
    return size[worldAxis(requested)] >= std::max({size.x, size.y, size.z}) - 1e-9;
}

/// The rejection along the most promising axis: by most caps, then world axes, then least misplacement.
Error bestRejection(const TriangleMesh& mesh, PrismAxis requested, double tolerance) {
    std::optional<Attempt> best;
    const auto isWorldAxis = [](const Attempt& found) { return rankOf(found.axis) < 3; };
    for (const Vec3 axis : diagnosticAxes(mesh, tolerance)) {
        if (!matches(axis, requested)) continue;
        Attempt found = fitAlong(mesh, axis, {tolerance});
        const auto key = [&](const Attempt& of) {
            return std::tuple(-of.caps, !isWorldAxis(of), of.misplaced, rankOf(of.axis));
        };
        if (!found.prism && (!best || key(found) < key(*best))) best = std::move(found);
    }
    return best ? best->prism.error() : Error{ErrorCode::Degenerate, "The mesh has no flat cap."};
}

/// The axes along which the mesh can be a prism; of a rounded one, those of least squares.
std::vector<Vec3> axesToTry(const TriangleMesh& mesh, const Accuracy& accuracy) {
    const std::vector<Vec3> candidates = candidateAxes(mesh, accuracy.flatness());
    if (!(accuracy.rounding > 0.0)) return candidates;
    const double size = boundsOf(mesh).diagonal();
    std::vector<Vec3> axes;
    for (const Vec3 candidate : candidates) {
        const Vec3 axis = snappedAxis(axisOfLeastSquares(mesh, candidate, accuracy.rounding), size, accuracy.rounding);
        const auto isSame = [&](Vec3 other) {
            return glm::length(glm::cross(axis, other)) * size <= accuracy.flatness();
        };
        if (std::ranges::none_of(axes, isSame)) axes.push_back(axis);
    }
    return axes;
}

/// The prism along the best of all axes along which the mesh is one.
std::optional<PrismFit> bestPrism(const TriangleMesh& solid, PrismAxis requested, const Accuracy& accuracy) {
    std::vector<Attempt> found;
    for (const Vec3 axis : axesToTry(solid, accuracy)) {
        Attempt result = fitAlong(solid, axis, accuracy);
        if (result.prism) found.push_back(std::move(result));
    }
    std::optional<std::size_t> best;
    const auto isBetter = [&](const Attempt& a, const Attempt& b) {
        const double nearer = distanceFromRequest(a.axis, requested) - distanceFromRequest(b.axis, requested);
        if (nearer != 0.0) return nearer < 0.0;
        const double thinner = a.prism->depth - b.prism->depth;
        return std::abs(thinner) > accuracy.flatness() ? thinner < 0.0 : rankOf(a.axis) < rankOf(b.axis);
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (matches(found[i].axis, requested) && (!best || isBetter(found[i], found[*best]))) best = i;
    }
    if (!best) return std::nullopt;
    PrismFit prism = *found[*best].prism;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (i != *best) prism.otherAxes.push_back(found[i].axis);
    return prism;
}

}  // namespace

Result<PrismFit> fitPrism(const TriangleMesh& solid, PrismAxis requested, double tolerance) {
    if (std::optional<PrismFit> prism = bestPrism(solid, requested, {tolerance})) return std::move(*prism);
    return bestRejection(solid, requested, tolerance);
}

std::optional<PrismFit> fitRoundedPrism(const TriangleMesh& solid, PrismAxis requested, double tolerance,
                                        double rounding) {
    return bestPrism(solid, requested, {tolerance, rounding});
}

double smallestExtent(const PrismFit& prism) {
    const Vec2 size = boundsOf(prism.outline.outer).size();
    return std::min({prism.depth, size.x, size.y});
}

double volumeOf(const PrismFit& prism) { return area(prism.outline) * prism.depth; }

}  // namespace rubble
