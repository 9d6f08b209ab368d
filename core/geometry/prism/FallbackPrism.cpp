#include "core/geometry/polygon/OutlineCleaning.h"
#include "core/geometry/prism/PrismPlacement.h"
#include "core/geometry/prism/PrismSilhouette.h"

namespace rubble {
namespace {

Vec3 worldAxis(int index) {
    Vec3 axis{0.0, 0.0, 0.0};
    axis[index] = 1.0;
    return axis;
}

/// The world axis with the smallest extent; ties: z before x before y.
Vec3 thinnestWorldAxis(const TriangleMesh& mesh, double tolerance) {
    const Box3 box = boundsOf(mesh);
    const Vec3 size = box.max - box.min;
    int thinnest = 2;
    for (const int k : {0, 1})
        if (size[k] < size[thinnest] - tolerance) thinnest = k;
    return worldAxis(thinnest);
}

}  // namespace

Result<PrismFit> fallbackPrism(const TriangleMesh& mesh, PrismAxis requested, PrismFallback fallback,
                               double tolerance) {
    const Vec3 axis = requested == PrismAxis::Thinnest
                          ? thinnestWorldAxis(mesh, tolerance)
                          : worldAxis(static_cast<int>(requested) - static_cast<int>(PrismAxis::X));
    const AxisView view = viewAlong(mesh, frameAlong(axis, boundsOf(mesh).centre()), tolerance);
    if (view.depth() <= tolerance)
        return Error{ErrorCode::Degenerate, "The mesh has no depth along the " + axisText(axis) + " axis."};
    if (fallback == PrismFallback::TopCap && !view.has(FaceOrientation::Top))
        return Error{ErrorCode::Degenerate, "The mesh has no flat face at the end of the " + axisText(axis) + " axis."};
    const Result<Polygon> outline = outlineOf(
        fallback == PrismFallback::TopCap ? boundaryOf(view, mesh, FaceOrientation::Top) : silhouetteRings(view, mesh),
        tolerance);
    if (!outline) return outline.error();
    return placedPrism(view, *outline, tolerance);
}

}  // namespace rubble
