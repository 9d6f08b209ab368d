#include "core/geometry/prism/AxisView.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

constexpr double kTolerance = 1e-6;  // m

AxisView viewAlongZ(const TriangleMesh& mesh) { return viewAlong(mesh, ViewFrame{}, kTolerance); }

auto countOf(const AxisView& view, FaceOrientation orientation) {
    return std::ranges::count(view.orientations, orientation);
}

/// A pyramid of height 1 on a square of side 2: its sides are tilted by 45 degrees.
TriangleMesh pyramid() {
    return {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}},
            {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

}  // namespace

class AxisViewTest : public QObject {
    Q_OBJECT
private slots:
    void framesAreRightHandedAlongAnyAxis() {
        for (std::uint64_t number = 1; number <= 500; ++number) {
            Random random(number);
            const Vec3 axis =
                glm::normalize(Vec3(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
            const Vec3 origin(1.0, 2.0, 3.0);
            const ViewFrame frame = frameAlong(axis, origin);
            const std::string name = "random seed " + std::to_string(number);
            QVERIFY2(frame.z == axis, name.c_str());
            QVERIFY2(glm::distance(glm::cross(frame.x, frame.y), axis) < 1e-14, name.c_str());
            QVERIFY2(std::abs(glm::length(frame.x) - 1.0) < 1e-14, name.c_str());
            const Vec3 local = frame.fromWorld(origin + 2.0 * frame.x - 3.0 * frame.y + 4.0 * frame.z);
            QVERIFY2(glm::distance(local, Vec3(2.0, -3.0, 4.0)) < 1e-14, name.c_str());
        }
    }
    void upIsUpUnlessTheAxisIsUpright() {
        QCOMPARE(frameAlong({1.0, 0.0, 0.0}, Vec3(0.0)).y, Vec3(0.0, 1.0, 0.0));
        QCOMPARE(frameAlong({0.0, 0.0, 1.0}, Vec3(0.0)).x, Vec3(1.0, 0.0, 0.0));
        QCOMPARE(frameAlong({0.0, 1.0, 0.0}, Vec3(0.0)).x, Vec3(1.0, 0.0, 0.0));
    }
    void facesOfAPrismAreCapsAndSides() {
        const AxisView view = viewAlongZ(prismSolid(lShape(), 3.0));
        QCOMPARE(view.bottom, -1.5);
        QCOMPARE(view.depth(), 3.0);
        QCOMPARE(countOf(view, FaceOrientation::Top), 4);
        QCOMPARE(countOf(view, FaceOrientation::Bottom), 4);
        QCOMPARE(countOf(view, FaceOrientation::Side), 12);
        QVERIFY(!view.has(FaceOrientation::Oblique));
    }
    void levelFaceBelowTheTopIsBetween() {
        const AxisView view = viewAlongZ({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 2}},
                                          {{0, 2, 1}, {3, 4, 5}, {3, 4, 6}}});
        QVERIFY(view.orientations ==
                std::vector({FaceOrientation::Bottom, FaceOrientation::Between, FaceOrientation::Side}));
    }
    void tiltIsThatOfTheFace() {
        const TriangleMesh mesh = pyramid();
        const AxisView view = viewAlongZ(mesh);
        QCOMPARE(tiltDegrees(view, mesh, 0), 90.0);
        for (std::size_t side = 2; side < 6; ++side) {
            QVERIFY(std::abs(tiltDegrees(view, mesh, side) - 45.0) < 1e-12);
            QVERIFY(view.orientations[side] == FaceOrientation::Oblique);
            QVERIFY(std::abs(projectedWidth(view, mesh, side) - 1.0) < 1e-15);  // above the edge of the base
        }
        QCOMPARE(tiltDegrees(viewAlongZ(prismSolid(unitSquare(), 1.0)), prismSolid(unitSquare(), 1.0), 4), 0.0);
    }
    void boundaryOfTheCapsHasTheirAreaAndHoles() {
        const TriangleMesh tube = prismSolid(squareRing(), 1.0);
        const AxisView view = viewAlongZ(tube);
        const auto areaWithin = [&](FaceOrientation orientation) {
            const std::vector<Ring> rings = boundaryOf(view, tube, orientation);
            return rings.size() == 2 ? signedArea(rings[0]) + signedArea(rings[1]) : 0.0;
        };
        QCOMPARE(areaWithin(FaceOrientation::Top), 12.0);
        QCOMPARE(areaWithin(FaceOrientation::Bottom), -12.0);
    }
};

RUBBLE_TEST(AxisViewTest)
#include "AxisViewTest.moc"
