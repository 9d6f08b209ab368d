// Tests core/geometry/prism/PrismFit.cpp, core/geometry/prism/PrismAxes.cpp, core/geometry/prism/PrismPlacement.cpp
// and core/geometry/prism/FallbackPrism.cpp.
#include "core/base/Random.h"
#include "core/geometry/mesh/MeshWelding.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "core/geometry/polygon/BoundaryDistance.h"
#include "core/geometry/prism/PrismFit.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

Result<PrismFit> found(const TriangleMesh& mesh, PrismAxis axis = PrismAxis::Thinnest) {
    const Result<WeldedMesh> one = welded(mesh);
    if (!one) return one.error();
    const Result<SolidMesh> solid = orientedSolid(one->mesh, one->tolerance);
    if (!solid) return solid.error();
    return fitPrism(solid->mesh, axis, one->tolerance);
}

QString prismFault(const TriangleMesh& mesh, PrismAxis axis = PrismAxis::Thinnest) {
    const Result<PrismFit> prism = found(mesh, axis);
    return prism ? "It is a prism." : QString::fromStdString(prism.error().message);
}

/// The largest distance of a point of the mesh from a corner of the posed prism.
double farthestFromCorners(const PrismFit& prism, const TriangleMesh& mesh) {
    const TriangleMesh again = placed(prismSolid(prism.outline, prism.depth), prism.pose);
    double farthest = 0.0;
    for (const Vec3 point : mesh.points) {
        double nearest = 1e308;
        for (const Vec3 corner : again.points) nearest = std::min(nearest, glm::distance(point, corner));
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

Pose anyPose(Random& random) {
    const Quat turn(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    return {{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)}, glm::normalize(turn)};
}

/// A star-shaped outline with random radii between 0.5 and 1.5, every second one larger.
Polygon randomStarOutline(Random& random) {
    const int count = 3 + static_cast<int>(random.below(20));
    Polygon polygon;
    for (int k = 0; k < count; ++k) {
        const double radius = k % 2 == 0 ? random.between(0.5, 0.8) : random.between(1.0, 1.5);
        const double angle = 2.0 * std::numbers::pi * k / count;
        polygon.outer.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return polygon;
}

/// A box of the given size with a corner at the origin.
TriangleMesh box(Vec3 size) {
    return placed(prismSolid({rectangle({0, 0}, {size.x, size.y}), {}}, size.z), {{0, 0, size.z / 2.0}});
}

/// A faceted ball: rings of points around the y axis.
TriangleMesh ball(int segments, int rings) {
    TriangleMesh mesh;
    mesh.points = {{0, 1, 0}, {0, -1, 0}};
    const auto point = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(2 + ring * segments + (segment + segments) % segments);
    };
    for (int ring = 0; ring < rings; ++ring) {
        const double polar = std::numbers::pi * (ring + 1) / (rings + 1);
        for (int k = 0; k < segments; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / segments;
            mesh.points.push_back(
                {std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn)});
        }
    }
    for (int k = 0; k < segments; ++k) {
        mesh.triangles.push_back({0, point(0, k), point(0, k + 1)});
        mesh.triangles.push_back({1, point(rings - 1, k + 1), point(rings - 1, k)});
        for (int ring = 0; ring + 1 < rings; ++ring) {
            mesh.triangles.push_back({point(ring, k), point(ring + 1, k), point(ring + 1, k + 1)});
            mesh.triangles.push_back({point(ring, k), point(ring + 1, k + 1), point(ring, k + 1)});
        }
    }
    return mesh;
}

/// A slab with a smaller slab on top.
TriangleMesh stepped() {
    TriangleMesh low = box({2, 2, 0.5});
    low.triangles.erase(std::remove_if(low.triangles.begin(), low.triangles.end(),
                                       [](const auto& t) { return t[0] >= 4 && t[1] >= 4 && t[2] >= 4; }),
                        low.triangles.end());
    TriangleMesh lid = prismSolid({rectangle({0, 0}, {2, 2}), {reversed(rectangle({0.5, 0.5}, {1.5, 1.5}))}}, 1.0);
    for (const auto& [a, b, c] : lid.triangles) {
        if (a < 8 || b < 8 || c < 8) continue;
        const auto first = static_cast<std::uint32_t>(low.points.size());
        for (const std::uint32_t corner : {a, b, c}) low.points.push_back(lid.points[corner]);
        low.triangles.push_back({first, first + 1, first + 2});
    }
    const TriangleMesh high = placed(box({1, 1, 0.75}), {{0.5, 0.5, 0.5}});
    for (const auto& [a, b, c] : high.triangles) {
        if (a < 4 && b < 4 && c < 4) continue;
        const auto first = static_cast<std::uint32_t>(low.points.size());
        for (const std::uint32_t corner : {a, b, c}) low.points.push_back(high.points[corner]);
        low.triangles.push_back({first, first + 1, first + 2});
    }
    return welded(low)->mesh;
}

}  // namespace

class PrismFitTest : public QObject {
    Q_OBJECT
private slots:
    void wallIsExtrudedAlongItsThinnestAxis() {
        const Result<PrismFit> prism = found(box({1.0, 2.0, 0.3}));
        QVERIFY(prism->outline == Polygon(rectangle({-0.5, -1.0}, {0.5, 1.0}), {}));
        QCOMPARE(prism->depth, 0.3);
        QVERIFY(prism->pose == Pose(Vec3(0.5, 1.0, 0.15), Quat(1.0, 0.0, 0.0, 0.0)));
        QCOMPARE(axisText(prism->axis), "z");
        QCOMPARE(prism->otherAxes.size(), std::size_t{2});
        QCOMPARE(prism->deviation, 0.0);
    }
    void axisCanBeRequested() {
        const TriangleMesh wall = box({1.0, 2.0, 0.3});
        const Result<PrismFit> along = found(wall, PrismAxis::X);
        QVERIFY(along->outline == Polygon(rectangle({-0.15, -1.0}, {0.15, 1.0}), {}));
        QCOMPARE(along->depth, 1.0);
        QVERIFY(farthestFromCorners(*along, wall) < 1e-12);
        QCOMPARE(axisText(found(wall, PrismAxis::Y)->axis), "y");
        QVERIFY(farthestFromCorners(*found(wall, PrismAxis::Y), wall) < 1e-12);
    }
    void cubeIsExtrudedAlongZ() { QCOMPARE(axisText(found(box({2, 2, 2}))->axis), "z"); }
    void concaveOutlinesWithHolesAreFoundAlongAnyAxis() {
        for (const Polygon& outline : {lShape(), squareRing(), Polygon{{{0, 0}, {5, 0}, {2.5, 1.44}}, {}}}) {
            for (const double depth : {0.01, 0.5, 30.0}) {
                Random random(7);
                for (int round = 0; round < 40; ++round) {
                    const TriangleMesh mesh = placed(prismSolid(outline, depth), anyPose(random));
                    const Result<PrismFit> prism = found(mesh);
                    QVERIFY2(prism.hasValue(), qPrintable(prismFault(mesh)));
                    QVERIFY(prism->otherAxes.empty());
                    QVERIFY(std::abs(prism->depth - depth) < 1e-8 * (1.0 + depth));
                    QCOMPARE(prism->outline.holes.size(), outline.holes.size());
                    QVERIFY(farthestFromCorners(*prism, mesh) < 1e-7 * (1.0 + depth));
                }
            }
        }
    }
    void randomStarsAreFound() {
        Random random(2024);
        for (int round = 0; round < 300; ++round) {
            const TriangleMesh mesh =
                placed(prismSolid(randomStarOutline(random), random.between(0.1, 3.0)), anyPose(random));
            const Result<PrismFit> prism = found(mesh);
            QVERIFY2(prism.hasValue(), qPrintable(QString("round %1: ").arg(round) + prismFault(mesh)));
            QVERIFY(farthestFromCorners(*prism, mesh) < 1e-6);
            TriangleMesh bent = mesh;  // by ten times the tolerance
            bent.points[0] += 1e-4 * boundsOf(mesh).diagonal() * prism->axis;
            QVERIFY(!found(bent).hasValue());
        }
    }
    void deviationIsMeasured() {
        const Polygon bulged{{{0, 0}, {1, -1e-5}, {2, 0}, {2, 1}, {0, 1}}, {}};
        const Result<PrismFit> prism = found(prismSolid(bulged, 0.5));
        QCOMPARE(prism->collinearCorners, std::size_t{1});
        QVERIFY(std::abs(prism->deviation - 1e-5) < 1e-9);
    }
    void singlePrecisionIsTolerated() {
        Random random(11);
        for (int round = 0; round < 100; ++round) {
            const Quat turn = glm::normalize(
                Quat(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
            TriangleMesh mesh = placed(prismSolid(squareRing(), 0.2), {{3, 4, 5}, turn});
            for (Vec3& point : mesh.points)
                for (int k = 0; k < 3; ++k) point[k] = static_cast<float>(point[k]);
            QVERIFY2(found(mesh).hasValue(), qPrintable(prismFault(mesh)));
        }
    }
    void rotatedOutlineIsAlignedToItsLongestEdge() {
        const double half = std::sqrt(0.5);
        const Polygon turned{{{0, 0}, {2 * half, 2 * half}, {1 * half, 3 * half}, {-1 * half, 1 * half}}, {}};
        const TriangleMesh slab = prismSolid(turned, 0.1);
        const Result<PrismFit> prism = found(slab);
        QVERIFY(prism->outline == Polygon(rectangle({-1.0, -0.5}, {1.0, 0.5}), {}));
        QVERIFY(farthestFromCorners(*prism, slab) < 1e-7);  // numbers are rounded to that
    }
    void collinearPointsAreRemovedAndCounted() {
        const Polygon square{{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0.5, 2}, {0, 2}}, {}};
        const Result<PrismFit> prism = found(prismSolid(square, 0.5));
        QVERIFY(prism->outline == Polygon(rectangle({-1, -1}, {1, 1}), {}));
        QCOMPARE(prism->collinearCorners, std::size_t{3});
    }
    void shiftedCapIsReported() {
        TriangleMesh mesh = prismSolid(lShape(), 0.5);
        for (std::size_t i = mesh.points.size() / 2; i < mesh.points.size(); ++i) mesh.points[i] += Vec3(0.0032, 0, 0);
        QCOMPARE(prismFault(mesh),
                 QString("The top cap is shifted by 3.2 mm relative to the bottom, seen along the z axis."));
    }
    void tiltedSidesAreReported() {
        TriangleMesh mesh = prismSolid({rectangle({-1, -1}, {1, 1}), {}}, 1.0);
        const double inset = 0.0716778;  // the tangent of 4.1 degrees
        for (std::size_t i = 4; i < 8; ++i) mesh.points[i] *= Vec3(1.0 - inset, 1.0 - inset, 1.0);
        QCOMPARE(prismFault(mesh), QString("The sides are tilted by 4.1 degrees from the z axis."));
        mesh.points[0].x -= 0.1;
        QVERIFY(prismFault(mesh).startsWith("The sides are tilted by up to "));
    }
    void otherShapesAreReported() {
        const TriangleMesh round = ball(16, 9);
        QVERIFY2(
            prismFault(round).startsWith("The mesh is curved or bent: between its caps, faces are tilted by up to "),
            qPrintable(prismFault(round)));
        QCOMPARE(prismFault(stepped(), PrismAxis::Z),
                 QString("The mesh has a step: a face lies perpendicular to the z axis, 750 mm below the top cap."));
        TriangleMesh pyramid{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}},
                             {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
        QCOMPARE(prismFault(pyramid), QString("The mesh has a flat cap at one end of the z axis only."));
        QCOMPARE(prismFault(prismSolid(lShape(), 1.0), PrismAxis::X),
                 QString("The mesh has a step: a face lies perpendicular to the x axis, 1 m below the top cap."));
    }
    void orderInTheFileDoesNotMatter() {
        const TriangleMesh mesh = placed(prismSolid(squareRing(), 0.5), {{1, 2, 3}, Quat(0.5, 0.5, 0.5, 0.5)});
        TriangleMesh other = mesh;
        std::reverse(other.triangles.begin(), other.triangles.end());
        for (auto& [a, b, c] : other.triangles) std::tie(a, b, c) = std::tuple(b, c, a);
        QVERIFY(found(mesh)->outline == found(other)->outline);
        QVERIFY(found(mesh)->pose == found(other)->pose);
    }
    void silhouetteIsAFallbackForAnyMesh() {
        const Result<PrismFit> prism = fallbackPrism(stepped(), PrismAxis::Z, PrismFallback::Silhouette, 1e-5);
        QVERIFY(prism->outline == Polygon(rectangle({-1, -1}, {1, 1}), {}));
        QCOMPARE(prism->depth, 1.25);
        QVERIFY(prism->pose.position == Vec3(1.0, 1.0, 0.625));
        const Result<PrismFit> ring =
            fallbackPrism(prismSolid(squareRing(), 9.0), PrismAxis::Z, PrismFallback::Silhouette, 1e-5);
        QVERIFY(distanceBetween(ring->outline, {rectangle({-2, -2}, {2, 2}), {rectangle({-1, -1}, {1, 1})}}) < 1e-8);
        QCOMPARE(ring->outline.holes.size(), std::size_t{1});
    }
    void topCapIsAFallbackIfFlat() {
        const Result<PrismFit> prism = fallbackPrism(stepped(), PrismAxis::Z, PrismFallback::TopCap, 1e-5);
        QVERIFY(prism->outline == Polygon(rectangle({-0.5, -0.5}, {0.5, 0.5}), {}));
        QCOMPARE(fallbackPrism(ball(8, 3), PrismAxis::Y, PrismFallback::TopCap, 1e-5).error().message,
                 "The mesh has no flat face at the end of the y axis.");
    }
    void lengthsHaveASuitableUnit() {
        QCOMPARE(lengthText(0.0032), "3.2 mm");
        QCOMPARE(lengthText(1.25), "1.25 m");
        QCOMPARE(lengthText(0.9999999), "1 m");
        QCOMPARE(lengthText(12345.6), "12346 m");
        QCOMPARE(lengthText(1e-17), "0 m");
        QCOMPARE(lengthText(2.5e-5), "25 micrometres");
        QCOMPARE(axisText({0.6, 0.8, 0.0}), "(0.6, 0.8, 0)");
        QCOMPARE(axisText({0.6, -4e-16, -0.0}), "(0.6, 0, 0)");
    }
};

RUBBLE_TEST(PrismFitTest)
#include "PrismFitTest.moc"
