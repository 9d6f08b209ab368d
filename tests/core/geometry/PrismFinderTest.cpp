#include "core/base/Random.h"
#include "core/geometry/MeshWelding.h"
#include "core/geometry/OutlineCleaning.h"
#include "core/geometry/PrismFinder.h"
#include "core/geometry/SolidMesh.h"
#include "tests/support/Outlines.h"
#include "tests/support/Solids.h"

#include <QTest>

#include <glm/geometric.hpp>

using namespace rubble;

namespace {

Result<FoundPrism> found(const TriangleMesh& mesh, AxisChoice choice = AxisChoice::Thinnest) {
    const Result<WeldedMesh> one = welded(mesh);
    if (!one) return one.error();
    const Result<SolidMesh> solid = solidOf(one->mesh, one->tolerance);
    if (!solid) return solid.error();
    return findPrism(solid->mesh, choice, one->tolerance);
}

QString faultOf(const TriangleMesh& mesh, AxisChoice choice = AxisChoice::Thinnest) {
    const Result<FoundPrism> prism = found(mesh, choice);
    return prism ? "It is a prism." : QString::fromStdString(prism.error().message);
}

/// The farthest that a point of the mesh lies from a corner of the prism where its pose puts it.
double farthestFromCorners(const FoundPrism& prism, const TriangleMesh& mesh) {
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

/// An outline around the origin whose corners are at any distance between 0.5 and 1.5, every second one farther out.
Polygon star(Random& random) {
    constexpr double kTurn = 6.283185307179586;
    const int count = 3 + static_cast<int>(random.below(20));
    Polygon polygon;
    for (int k = 0; k < count; ++k) {
        const double radius = k % 2 == 0 ? random.between(0.5, 0.8) : random.between(1.0, 1.5);
        polygon.outer.push_back({radius * std::cos(kTurn * k / count), radius * std::sin(kTurn * k / count)});
    }
    return polygon;
}

/// A box of the given size with a corner at the origin.
TriangleMesh box(Vec3 size) {
    return placed(prismSolid({rectangle({0, 0}, {size.x, size.y}), {}}, size.z), {{0, 0, size.z / 2.0}});
}

/// A ball of flat faces: rings of points around the y axis.
TriangleMesh ball(int segments, int rings) {
    constexpr double kPi = 3.14159265358979323846;
    TriangleMesh mesh;
    mesh.points = {{0, 1, 0}, {0, -1, 0}};
    const auto point = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(2 + ring * segments + (segment + segments) % segments);
    };
    for (int ring = 0; ring < rings; ++ring) {
        const double polar = kPi * (ring + 1) / (rings + 1);
        for (int k = 0; k < segments; ++k) {
            const double turn = 2.0 * kPi * k / segments;
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

/// A slab from which a second, smaller one rises.
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

class PrismFinderTest : public QObject {
    Q_OBJECT
private slots:
    void aWallIsExtrudedAlongItsThinnestAxis() {
        const Result<FoundPrism> prism = found(box({1.0, 2.0, 0.3}));
        QVERIFY(prism->outline == Polygon(rectangle({-0.5, -1.0}, {0.5, 1.0}), {}));
        QCOMPARE(prism->depth, 0.3);
        QVERIFY(prism->pose == Pose(Vec3(0.5, 1.0, 0.15), Quat(1.0, 0.0, 0.0, 0.0)));
        QCOMPARE(axisText(prism->axis), "z");
        QCOMPARE(prism->otherAxes.size(), std::size_t{2});
        QCOMPARE(prism->deviation, 0.0);
    }
    void anAxisCanBeChosen() {
        const TriangleMesh wall = box({1.0, 2.0, 0.3});
        const Result<FoundPrism> along = found(wall, AxisChoice::X);
        QVERIFY(along->outline == Polygon(rectangle({-0.15, -1.0}, {0.15, 1.0}), {}));
        QCOMPARE(along->depth, 1.0);
        QVERIFY(farthestFromCorners(*along, wall) < 1e-12);
        QCOMPARE(axisText(found(wall, AxisChoice::Y)->axis), "y");
        QVERIFY(farthestFromCorners(*found(wall, AxisChoice::Y), wall) < 1e-12);
    }
    void aCubeIsExtrudedAlongZ() { QCOMPARE(axisText(found(box({2, 2, 2}))->axis), "z"); }
    void concaveAndHoledOutlinesAreFoundAlongAnyAxis() {
        for (const Polygon& outline : {lShape(), squareRing(), Polygon{{{0, 0}, {5, 0}, {2.5, 1.44}}, {}}}) {
            for (const double depth : {0.01, 0.5, 30.0}) {
                Random random(7);
                for (int round = 0; round < 40; ++round) {
                    const TriangleMesh mesh = placed(prismSolid(outline, depth), anyPose(random));
                    const Result<FoundPrism> prism = found(mesh);
                    QVERIFY2(prism.hasValue(), qPrintable(faultOf(mesh)));
                    QVERIFY(prism->otherAxes.empty());
                    QVERIFY(std::abs(prism->depth - depth) < 1e-8 * (1.0 + depth));
                    QCOMPARE(prism->outline.holes.size(), outline.holes.size());
                    QVERIFY(farthestFromCorners(*prism, mesh) < 1e-7 * (1.0 + depth));
                }
            }
        }
    }
    void starsOfAnyShapeAreFound() {
        Random random(2024);
        for (int round = 0; round < 300; ++round) {
            const TriangleMesh mesh = placed(prismSolid(star(random), random.between(0.1, 3.0)), anyPose(random));
            const Result<FoundPrism> prism = found(mesh);
            QVERIFY2(prism.hasValue(), qPrintable(QString("round %1: ").arg(round) + faultOf(mesh)));
            QVERIFY(farthestFromCorners(*prism, mesh) < 1e-6);
            TriangleMesh bent = mesh;  // by ten times the tolerance
            bent.points[0] += 1e-4 * boundsOf(mesh).diagonal() * prism->axis;
            QVERIFY(!found(bent).hasValue());
        }
    }
    void whatWasLeftOutIsMeasured() {
        const Polygon bulged{{{0, 0}, {1, -1e-5}, {2, 0}, {2, 1}, {0, 1}}, {}};
        const Result<FoundPrism> prism = found(prismSolid(bulged, 0.5));
        QCOMPARE(prism->straightCorners, std::size_t{1});
        QVERIFY(std::abs(prism->deviation - 1e-5) < 1e-9);
    }
    void singlePrecisionIsNoFault() {
        Random random(11);
        for (int round = 0; round < 100; ++round) {
            const Quat turn = glm::normalize(
                Quat(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
            TriangleMesh mesh = placed(prismSolid(squareRing(), 0.2), {{3, 4, 5}, turn});
            for (Vec3& point : mesh.points)
                for (int k = 0; k < 3; ++k) point[k] = static_cast<float>(point[k]);
            QVERIFY2(found(mesh).hasValue(), qPrintable(faultOf(mesh)));
        }
    }
    void aTurnedOutlineLiesAlongItsLongestEdge() {
        const double half = std::sqrt(0.5);
        const Polygon turned{{{0, 0}, {2 * half, 2 * half}, {1 * half, 3 * half}, {-1 * half, 1 * half}}, {}};
        const TriangleMesh slab = prismSolid(turned, 0.1);
        const Result<FoundPrism> prism = found(slab);
        QVERIFY(prism->outline == Polygon(rectangle({-1.0, -0.5}, {1.0, 0.5}), {}));
        QVERIFY(farthestFromCorners(*prism, slab) < 1e-7);  // numbers are rounded to that
    }
    void pointsOnStraightLinesAreLeftOutAndCounted() {
        const Polygon square{{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0.5, 2}, {0, 2}}, {}};
        const Result<FoundPrism> prism = found(prismSolid(square, 0.5));
        QVERIFY(prism->outline == Polygon(rectangle({-1, -1}, {1, 1}), {}));
        QCOMPARE(prism->straightCorners, std::size_t{3});
    }
    void aShiftedCapIsTold() {
        TriangleMesh mesh = prismSolid(lShape(), 0.5);
        for (std::size_t i = mesh.points.size() / 2; i < mesh.points.size(); ++i) mesh.points[i] += Vec3(0.0032, 0, 0);
        QCOMPARE(faultOf(mesh), QString("The top cap is shifted by 3.2 mm against the bottom, seen along the z axis."));
    }
    void leaningSidesAreTold() {
        TriangleMesh mesh = prismSolid({rectangle({-1, -1}, {1, 1}), {}}, 1.0);
        const double inset = 0.0716778;  // the tangent of 4.1 degrees
        for (std::size_t i = 4; i < 8; ++i) mesh.points[i] *= Vec3(1.0 - inset, 1.0 - inset, 1.0);
        QCOMPARE(faultOf(mesh), QString("The sides lean by 4.1 degrees against the z axis."));
        mesh.points[0].x -= 0.1;
        QVERIFY(faultOf(mesh).startsWith("The sides lean by up to "));
    }
    void otherShapesAreTold() {
        const TriangleMesh round = ball(16, 9);
        QVERIFY2(faultOf(round).startsWith("The mesh is curved or bent: between its caps, faces lean by up to "),
                 qPrintable(faultOf(round)));
        QCOMPARE(faultOf(stepped(), AxisChoice::Z),
                 QString("The mesh has a step: a face lies across the z axis, 750 mm below the top cap."));
        TriangleMesh pyramid{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}},
                             {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
        QCOMPARE(faultOf(pyramid), QString("The mesh has a flat cap at one end of the z axis only."));
        QCOMPARE(faultOf(prismSolid(lShape(), 1.0), AxisChoice::X),
                 QString("The mesh has a step: a face lies across the x axis, 1 m below the top cap."));
    }
    void theOrderOfTheFileMakesNoDifference() {
        const TriangleMesh mesh = placed(prismSolid(squareRing(), 0.5), {{1, 2, 3}, Quat(0.5, 0.5, 0.5, 0.5)});
        TriangleMesh other = mesh;
        std::reverse(other.triangles.begin(), other.triangles.end());
        for (auto& [a, b, c] : other.triangles) std::tie(a, b, c) = std::tuple(b, c, a);
        QVERIFY(found(mesh)->outline == found(other)->outline);
        QVERIFY(found(mesh)->pose == found(other)->pose);
    }
    void aSilhouetteStandsInForAnyMesh() {
        const Result<FoundPrism> prism = standInPrism(stepped(), AxisChoice::Z, PrismFallback::Silhouette, 1e-5);
        QVERIFY(prism->outline == Polygon(rectangle({-1, -1}, {1, 1}), {}));
        QCOMPARE(prism->depth, 1.25);
        QVERIFY(prism->pose.position == Vec3(1.0, 1.0, 0.625));
        const Result<FoundPrism> ring =
            standInPrism(prismSolid(squareRing(), 9.0), AxisChoice::Z, PrismFallback::Silhouette, 1e-5);
        QVERIFY(distanceBetween(ring->outline, {rectangle({-2, -2}, {2, 2}), {rectangle({-1, -1}, {1, 1})}}) < 1e-8);
        QCOMPARE(ring->outline.holes.size(), std::size_t{1});
    }
    void theTopCapStandsInWhereThereIsOne() {
        const Result<FoundPrism> prism = standInPrism(stepped(), AxisChoice::Z, PrismFallback::TopCap, 1e-5);
        QVERIFY(prism->outline == Polygon(rectangle({-0.5, -0.5}, {0.5, 0.5}), {}));
        QCOMPARE(standInPrism(ball(8, 3), AxisChoice::Y, PrismFallback::TopCap, 1e-5).error().message,
                 "The mesh has no flat face at the end of the y axis.");
    }
    void lengthsAreToldInTheUnitThatSuits() {
        QCOMPARE(lengthText(0.0032), "3.2 mm");
        QCOMPARE(lengthText(1.25), "1.25 m");
        QCOMPARE(lengthText(0.9999999), "1 m");
        QCOMPARE(lengthText(12345.6), "12346 m");
        QCOMPARE(lengthText(1e-17), "0 m");
        QCOMPARE(lengthText(2.5e-5), "25 micrometres");
        QCOMPARE(axisText({0.6, 0.8, 0.0}), "(0.6, 0.8, 0)");
    }
};

QTEST_APPLESS_MAIN(PrismFinderTest)
#include "PrismFinderTest.moc"
