#include "tests/support/scenes/BodyShapes.h"

#include "core/base/math/Trigonometry.h"
#include "core/geometry/hull/ConvexHull.h"

#include <cmath>
#include <numbers>

namespace rubble::test {
namespace {

Vec2 onCircle(double radius, int corner, int corners) {
    const double angle = 2.0 * std::numbers::pi * corner / corners;
    return {radius * cosine(angle), radius * sine(angle)};
}

/// A rectangle in fifths of the width, from the lower left corner.
struct Rectangle {
    double left, bottom, right, top;
};

std::vector<Polytope> rectangleHulls(const std::vector<Rectangle>& rectangles, double width, double height) {
    std::vector<Polytope> hulls;
    for (const Rectangle& each : rectangles) {
        const auto at = [&](double x, double y) { return width * (Vec2(x, y) / 5.0 - Vec2(0.5)); };
        hulls.push_back(lyingPrism({at(each.left, each.bottom), at(each.right, each.bottom), at(each.right, each.top),
                                    at(each.left, each.top)},
                                   height));
    }
    return hulls;
}

}  // namespace

Polytope lyingPrism(const std::vector<Vec2>& ring, double height) {
    Polytope prism = extruded(ring, -0.5 * height, 0.5 * height);
    const auto laid = [](Vec3 v) { return Vec3(v.x, v.z, -v.y); };
    for (Vec3& vertex : prism.vertices) vertex = laid(vertex);
    for (Plane& plane : prism.planes) plane.normal = laid(plane.normal);
    return prism;
}

std::vector<Polytope> frameHulls(double width, double beam, double height) {
    const double part = 5.0 * beam / width;
    return rectangleHulls({{0.0, 0.0, 5.0, part},
                           {0.0, 5.0 - part, 5.0, 5.0},
                           {0.0, part, part, 5.0 - part},
                           {5.0 - part, part, 5.0, 5.0 - part}},
                          width, height);
}

std::vector<Polytope> ringHulls(double outerRadius, double innerRadius, double height, int sections) {
    std::vector<Polytope> hulls;
    for (int k = 0; k < sections; ++k) {
        hulls.push_back(lyingPrism({onCircle(outerRadius, k, sections), onCircle(outerRadius, k + 1, sections),
                                    onCircle(innerRadius, k + 1, sections), onCircle(innerRadius, k, sections)},
                                   height));
    }
    return hulls;
}

std::vector<Polytope> gearHulls(double radius, double toothLength, double height, int teeth) {
    const double hub = radius - toothLength;
    std::vector<Polytope> hulls{discHull(hub, height, 2 * teeth)};
    for (int k = 0; k < 2 * teeth; k += 2) {
        const Vec2 first = onCircle(hub, k, 2 * teeth), second = onCircle(hub, k + 1, 2 * teeth);
        const Vec2 outward = toothLength * glm::normalize(first + second);
        hulls.push_back(lyingPrism({first, first + outward, second + outward, second}, height));
    }
    return hulls;
}

std::vector<Polytope> eHulls(double width, double height) {
    return rectangleHulls({{0, 0, 1, 5}, {1, 0, 5, 1}, {1, 2, 5, 3}, {1, 4, 5, 5}}, width, height);
}

std::vector<Polytope> uHulls(double width, double height) {
    return rectangleHulls({{0, 0, 5, 1}, {0, 1, 1, 5}, {4, 1, 5, 5}}, width, height);
}

std::vector<Polytope> lHulls(double width, double height) {
    return rectangleHulls({{0, 0, 1, 5}, {1, 0, 5, 1}}, width, height);
}

std::vector<Polytope> crossHulls(double width, double height) {
    return rectangleHulls({{0, 2, 5, 3}, {2, 0, 3, 2}, {2, 3, 3, 5}}, width, height);
}

Polytope discHull(double radius, double height, int corners) {
    std::vector<Vec2> ring;
    for (int k = 0; k < corners; ++k) ring.push_back(onCircle(radius, k, corners));
    return lyingPrism(ring, height);
}

Polytope needleHull(double length, double width) {
    const double half = 0.5 * width;
    return *convexHull(std::vector<Vec3>{{-0.5 * length, 0.0, 0.0},
                                         {0.5 * length, 0.0, 0.0},
                                         {0.0, -half, -half},
                                         {0.0, -half, half},
                                         {0.0, half, -half},
                                         {0.0, half, half}});
}

Polytope tetrahedronHull(double edge) {
    const double half = edge / std::sqrt(8.0);
    return *convexHull(
        std::vector<Vec3>{{half, half, half}, {half, -half, -half}, {-half, half, -half}, {-half, -half, half}});
}

}  // namespace rubble::test
