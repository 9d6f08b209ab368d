#include "core/geometry/prism/PrismRejection.h"

#include "core/base/MessageText.h"
#include "core/geometry/polygon/BoundaryDistance.h"
#include "core/geometry/polygon/OutlineCleaning.h"
#include "core/geometry/prism/PrismFit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

/// An angle for a message, to a tenth of a degree; small angles with two digits.
std::string degreesText(double degrees) {
    const std::string text =
        roundedText(degrees < 1.0 ? degrees : std::round(10.0 * degrees) / 10.0, degrees < 1.0 ? 2 : 3);
    return text + (text == "1" ? " degree" : " degrees");
}

Polygon canonicalOutline(const AxisView& view, const TriangleMesh& mesh, FaceOrientation orientation,
                         double tolerance) {
    std::vector<Ring> rings = boundaryOf(view, mesh, orientation);
    if (orientation == FaceOrientation::Bottom)
        for (Ring& ring : rings) std::ranges::reverse(ring);
    const Result<Polygon> outline = outlineOf(rings, tolerance);
    return outline ? *outline : Polygon{};
}

Polygon translated(Polygon polygon, Vec2 by) {
    for (Vec2& corner : polygon.outer) corner += by;
    for (Ring& hole : polygon.holes)
        for (Vec2& corner : hole) corner += by;
    return polygon;
}

/// The shift of the top cap relative to the bottom, if the caps are otherwise equal.
std::optional<double> capShift(const AxisView& view, const TriangleMesh& mesh, double tolerance) {
    const Polygon top = canonicalOutline(view, mesh, FaceOrientation::Top, tolerance);
    const Polygon bottom = canonicalOutline(view, mesh, FaceOrientation::Bottom, tolerance);
    if (top.outer.size() < 3 || bottom.outer.size() < 3) return std::nullopt;
    const Vec2 shift = centroid(top) - centroid(bottom);
    if (distanceBetween(top, translated(bottom, shift)) > 2.0 * tolerance) return std::nullopt;
    return glm::length(shift);
}

/// The range of tilts of the oblique faces.
struct Tilts {
    double least = 90.0;
    double greatest = 0.0;
    bool hasPointBetween = false;  // whether a point is between the caps
};

Tilts tiltsOf(const AxisView& view, const TriangleMesh& mesh, double tolerance) {
    Tilts tilts;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (view.orientations[i] != FaceOrientation::Oblique) continue;
        const double degrees = tiltDegrees(view, mesh, i);
        tilts.least = std::min(tilts.least, degrees);
        tilts.greatest = std::max(tilts.greatest, degrees);
        for (const std::uint32_t corner : mesh.triangles[i]) {
            const double height = view.points[corner].z;
            tilts.hasPointBetween |= height > view.bottom + 2.0 * tolerance && height < view.top - 2.0 * tolerance;
        }
    }
    return tilts;
}

std::string stepSentence(const AxisView& view, const TriangleMesh& mesh, const std::string& along) {
    const auto step = std::ranges::find(view.orientations, FaceOrientation::Between) - view.orientations.begin();
    const double height = view.points[mesh.triangles[step][0]].z;
    return "The mesh has a step: a face lies perpendicular to " + along + ", " + lengthText(view.top - height) +
           " below the top cap.";
}

std::string tiltSentence(const AxisView& view, const TriangleMesh& mesh, const std::string& along, double tolerance) {
    const Tilts tilts = tiltsOf(view, mesh, tolerance);
    if (!tilts.hasPointBetween) {
        if (const std::optional<double> shift = capShift(view, mesh, tolerance))
            return "The top cap is shifted by " + lengthText(*shift) + " relative to the bottom, seen along " + along +
                   ".";
        const std::string least = degreesText(tilts.least), greatest = degreesText(tilts.greatest);
        return "The sides are tilted by " + (least == greatest ? "" : std::string("up to ")) + greatest + " from " +
               along + ".";
    }
    return "The mesh is curved or bent: between its caps, faces are tilted by up to " + degreesText(tilts.greatest) +
           " from " + along + ".";
}

}  // namespace

std::string prismRejection(const AxisView& view, const TriangleMesh& mesh, double tolerance) {
    const std::string name = axisText(view.frame.z);
    const std::string along = name.size() == 1 ? "the " + name + " axis" : "the axis " + name;
    const bool hasTop = view.has(FaceOrientation::Top), hasBottom = view.has(FaceOrientation::Bottom);
    if (!hasTop && !hasBottom) return "The mesh has no flat cap at either end of " + along + ".";
    if (!hasTop || !hasBottom) return "The mesh has a flat cap at one end of " + along + " only.";
    if (view.has(FaceOrientation::Oblique)) return tiltSentence(view, mesh, along, tolerance);
    if (view.has(FaceOrientation::Between)) return stepSentence(view, mesh, along);
    const double apart = distanceBetween(canonicalOutline(view, mesh, FaceOrientation::Top, tolerance),
                                         canonicalOutline(view, mesh, FaceOrientation::Bottom, tolerance));
    return "The caps perpendicular to " + along + " differ by " + lengthText(apart) + ".";
}

std::string axisText(Vec3 axis) {
    for (int k = 0; k < 3; ++k)
        if (std::abs(axis[k]) == 1.0) return std::string(1, "xyz"[k]);
    constexpr double kShownAsZero = 1e-9;
    const auto text = [](double value) { return std::abs(value) < kShownAsZero ? "0" : roundedText(value, 3); };
    return "(" + text(axis.x) + ", " + text(axis.y) + ", " + text(axis.z) + ")";
}

std::string lengthText(double metres) {
    const double size = std::abs(metres);
    if (size < 1e-9) return "0 m";  // rounding error
    if (size >= 1e4) return messageText(std::round(metres)) + " m";
    if (size >= 0.9995) return roundedText(metres, 4) + " m";
    if (size >= 1e-4) return roundedText(1e3 * metres, 3) + " mm";
    return roundedText(1e6 * metres, 2) + " micrometres";
}

}  // namespace rubble
