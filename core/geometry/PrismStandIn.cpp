#include "core/geometry/OutlineCleaning.h"
#include "core/geometry/PrismPlacing.h"
#include "core/geometry/PrismSilhouette.h"

namespace rubble {
namespace {

Vec3 worldAxis(int index) {
    Vec3 axis{0.0, 0.0, 0.0};
    axis[index] = 1.0;
    return axis;
}

/// Of equally thin ones z before x before y.
Vec3 thinnestWorldAxis(const TriangleMesh& mesh, double tolerance) {
    const Box3 box = boundsOf(mesh);
    const Vec3 size = box.max - box.min;
    int thinnest = 2;
    for (const int k : {0, 1})
        if (size[k] < size[thinnest] - tolerance) thinnest = k;
    return worldAxis(thinnest);
}

}  // namespace

Result<FoundPrism> standInPrism(const TriangleMesh& mesh, AxisChoice choice, PrismFallback fallback, double tolerance) {
    const Vec3 axis = choice == AxisChoice::Thinnest
                          ? thinnestWorldAxis(mesh, tolerance)
                          : worldAxis(static_cast<int>(choice) - static_cast<int>(AxisChoice::X));
    const AxisView view = viewedAlong(mesh, frameAlong(axis, boundsOf(mesh).centre()), tolerance);
    if (view.depth() <= tolerance)
        return Error{ErrorCode::Degenerate, "The mesh is flat across the " + axisText(axis) + " axis."};
    if (fallback == PrismFallback::TopCap && !view.has(FaceLie::Top))
        return Error{ErrorCode::Degenerate, "The mesh has no flat face at the end of the " + axisText(axis) + " axis."};
    const Result<Polygon> outline = outlineOf(
        fallback == PrismFallback::TopCap ? boundaryOf(view, mesh, FaceLie::Top) : silhouetteRings(view, mesh),
        tolerance);
    if (!outline) return outline.error();
    return placedPrism(view, *outline, tolerance);
}

}  // namespace rubble
