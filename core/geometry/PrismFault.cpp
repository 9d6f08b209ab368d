#include "core/geometry/PrismFault.h"

#include "core/base/MessageText.h"
#include "core/geometry/OutlineCleaning.h"
#include "core/geometry/PrismFinder.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

/// To a tenth of a degree, small angles to two digits.
std::string degreesText(double degrees) {
    const std::string text =
        roundedText(degrees < 1.0 ? degrees : std::round(10.0 * degrees) / 10.0, degrees < 1.0 ? 2 : 3);
    return text + (text == "1" ? " degree" : " degrees");
}

Polygon canonicalOutline(const AxisView& view, const TriangleMesh& mesh, FaceLie lie, double tolerance) {
    std::vector<Ring> rings = boundaryOf(view, mesh, lie);
    if (lie == FaceLie::Bottom)
        for (Ring& ring : rings) std::ranges::reverse(ring);
    const Result<Polygon> outline = outlineOf(rings, tolerance);
    return outline ? *outline : Polygon{};
}

Polygon moved(Polygon polygon, Vec2 by) {
    for (Vec2& corner : polygon.outer) corner += by;
    for (Ring& hole : polygon.holes)
        for (Vec2& corner : hole) corner += by;
    return polygon;
}

/// How far the top cap is shifted against the bottom, where that is all that is wrong.
std::optional<double> capShift(const AxisView& view, const TriangleMesh& mesh, double tolerance) {
    const Polygon top = canonicalOutline(view, mesh, FaceLie::Top, tolerance);
    const Polygon bottom = canonicalOutline(view, mesh, FaceLie::Bottom, tolerance);
    if (top.outer.size() < 3 || bottom.outer.size() < 3) return std::nullopt;
    const Vec2 shift = centroid(top) - centroid(bottom);
    if (distanceBetween(top, moved(bottom, shift)) > 2.0 * tolerance) return std::nullopt;
    return glm::length(shift);
}

/// The least and the greatest lean of the faces that lean.
struct Leans {
    double least = 90.0;
    double greatest = 0.0;
    bool reachBetween = false;  // some of their points lie between the caps
};

Leans leansOf(const AxisView& view, const TriangleMesh& mesh, double tolerance) {
    Leans leans;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (view.lies[i] != FaceLie::Leaning) continue;
        const double degrees = leanDegrees(view, mesh, i);
        leans.least = std::min(leans.least, degrees);
        leans.greatest = std::max(leans.greatest, degrees);
        for (const std::uint32_t corner : mesh.triangles[i]) {
            const double height = view.points[corner].z;
            leans.reachBetween |= height > view.bottom + 2.0 * tolerance && height < view.top - 2.0 * tolerance;
        }
    }
    return leans;
}

std::string stepSentence(const AxisView& view, const TriangleMesh& mesh, const std::string& along) {
    const auto step = std::ranges::find(view.lies, FaceLie::Between) - view.lies.begin();
    const double height = view.points[mesh.triangles[step][0]].z;
    return "The mesh has a step: a face lies across " + along + ", " + lengthText(view.top - height) +
           " below the top cap.";
}

std::string leanSentence(const AxisView& view, const TriangleMesh& mesh, const std::string& along, double tolerance) {
    const Leans leans = leansOf(view, mesh, tolerance);
    if (!leans.reachBetween) {
        if (const std::optional<double> shift = capShift(view, mesh, tolerance))
            return "The top cap is shifted by " + lengthText(*shift) + " against the bottom, seen along " + along + ".";
        const std::string least = degreesText(leans.least), greatest = degreesText(leans.greatest);
        return "The sides lean by " + (least == greatest ? "" : std::string("up to ")) + greatest + " against " +
               along + ".";
    }
    return "The mesh is curved or bent: between its caps, faces lean by up to " + degreesText(leans.greatest) +
           " against " + along + ".";
}

}  // namespace

std::string prismFault(const AxisView& view, const TriangleMesh& mesh, double tolerance) {
    const std::string name = axisText(view.frame.z);
    const std::string along = name.size() == 1 ? "the " + name + " axis" : "the axis " + name;
    const bool hasTop = view.has(FaceLie::Top), hasBottom = view.has(FaceLie::Bottom);
    if (!hasTop && !hasBottom) return "The mesh has no flat cap at either end of " + along + ".";
    if (!hasTop || !hasBottom) return "The mesh has a flat cap at one end of " + along + " only.";
    if (view.has(FaceLie::Leaning)) return leanSentence(view, mesh, along, tolerance);
    if (view.has(FaceLie::Between)) return stepSentence(view, mesh, along);
    const double apart = distanceBetween(canonicalOutline(view, mesh, FaceLie::Top, tolerance),
                                         canonicalOutline(view, mesh, FaceLie::Bottom, tolerance));
    return "The caps across " + along + " differ by " + lengthText(apart) + ".";
}

std::string axisText(Vec3 axis) {
    for (int k = 0; k < 3; ++k)
        if (std::abs(axis[k]) == 1.0) return std::string(1, "xyz"[k]);
    return "(" + roundedText(axis.x, 3) + ", " + roundedText(axis.y, 3) + ", " + roundedText(axis.z, 3) + ")";
}

std::string lengthText(double metres) {
    const double size = std::abs(metres);
    if (size < 1e-9) return "0 m";  // what computing leaves
    if (size >= 1e4) return messageText(std::round(metres)) + " m";
    if (size >= 0.9995) return roundedText(metres, 4) + " m";
    if (size >= 1e-4) return roundedText(1e3 * metres, 3) + " mm";
    return roundedText(1e6 * metres, 2) + " micrometres";
}

}  // namespace rubble
