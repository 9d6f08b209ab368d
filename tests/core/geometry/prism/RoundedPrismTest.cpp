// Tests core/geometry/prism/RoundedPrism.cpp.
#include "core/geometry/prism/PrismFit.h"
#include "core/geometry/prism/RoundedPrism.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

const Pose kTilted{{3, 1, 2}, glm::normalize(Quat(0.9, 0.2, 0.3, 0.1))};

/// A prism whose coordinates are multiples of a step.
TriangleMesh roundedSolid(const Polygon& outline, double depth, double step) {
    TriangleMesh mesh = placed(prismSolid(outline, depth), kTilted);
    for (Vec3& point : mesh.points) point = step * glm::round(point / step);
    return mesh;
}

constexpr double kGrid = 1e-3, kStepRounding = 0.867 * kGrid, kStrictTolerance = 2e-5;

std::optional<PrismFit> fitted(const TriangleMesh& mesh, double rounding = kStepRounding) {
    return fitRoundedPrism(mesh, PrismAxis::Thinnest, kStrictTolerance, rounding);
}

}  // namespace

class RoundedPrismTest : public QObject {
    Q_OBJECT
private slots:
    void roundedPrismIsFitted() {
        const TriangleMesh mesh = roundedSolid(lShapeWithHole(), 0.5, kGrid);
        QVERIFY(!fitPrism(mesh, PrismAxis::Thinnest, kStrictTolerance));
        const std::optional<PrismFit> prism = fitted(mesh);
        QVERIFY(prism.has_value());
        QCOMPARE(prism->outline.outer.size(), std::size_t{6});
        QCOMPARE(prism->outline.holes.size(), std::size_t{1});
        QVERIFY(std::abs(prism->depth - 0.5) < kGrid);
        QVERIFY(std::abs(volumeOf(*prism) - 2.75 * 0.5) < 2e-3);
        QVERIFY(prism->deviation <= 2.0 * kStepRounding);
        QVERIFY(std::abs(glm::dot(prism->axis, kTilted.orientation * Vec3(0, 0, 1))) > 1.0 - 1e-6);
        QCOMPARE(smallestExtent(*prism), prism->depth);
    }
    void largerDeviationsAreNone() {
        const TriangleMesh mesh = roundedSolid(lShape(), 0.5, kGrid);
        QVERIFY(fitted(mesh).has_value());
        QVERIFY(!fitted(mesh, kStepRounding / 4.0));
        TriangleMesh shifted = mesh;
        for (std::size_t i = 6; i < 12; ++i) shifted.points[i] += kTilted.orientation * Vec3(0.006, 0.0, 0.0);
        QVERIFY(!fitted(shifted));
    }
    void manyCornersKeepTheirArea() {
        const Polygon round{star(64, 1.0, 1.0), {}};
        const std::optional<PrismFit> prism = fitted(roundedSolid(round, 1.0, kGrid));
        QVERIFY(prism.has_value());
        QVERIFY(std::abs(area(prism->outline) / area(round) - 1.0) < 1e-3);
    }
    void leastSquaresFindTheAxis() {
        const TriangleMesh mesh = roundedSolid(lShape(), 0.5, kGrid);
        const Vec3 right = kTilted.orientation * Vec3(0, 0, 1);
        const Vec3 near = glm::normalize(right + Vec3(0.02, -0.01, 0.02));
        QVERIFY(glm::distance(axisOfLeastSquares(mesh, near, kStepRounding), right) < 5e-4);
        QVERIFY(glm::distance(axisOfLeastSquares(prismSolid(lShape(), 2.0), {0.01, 0.0, 1.0}, 0.0), Vec3(0, 0, 1)) <
                1e-9);
    }
    void ringsMeetHalfway() {
        const std::vector<Ring> top{{{0, 0}, {1, 0}, {1, 1}}}, bottom{{{1.01, 0}, {1, 1.02}, {5, 5}}};
        const std::vector<Ring> middle = ringsBetween(top, bottom, 0.05);
        QCOMPARE(middle[0][0], Vec2(0, 0));
        QCOMPARE(middle[0][1], Vec2(1.005, 0));
        QCOMPARE(middle[0][2], Vec2(1, 1.01));
    }
};

RUBBLE_TEST(RoundedPrismTest)
#include "RoundedPrismTest.moc"
