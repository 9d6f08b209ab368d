#include "core/physics/queries/VisibleFaces.h"

#include "core/physics/state/WorldState.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <cmath>
#include <map>

using namespace rubble;

namespace {

/// Bodies for the query alone: only shapes and poses count.
class Bodies {
public:
    std::uint32_t add(std::shared_ptr<const Shape> shape, Vec3 position) {
        state.bodies.push_back({.shape = std::move(shape)});
        state.motions.emplace_back();
        state.poses.push_back({.centre = toFloat(position)});
        return static_cast<std::uint32_t>(state.bodies.size() - 1);
    }
    /// The visible area of each body from the origin.
    std::map<std::uint32_t, double> areas(double radius = 100.0) {
        std::map<std::uint32_t, double> areas;
        comparisons = visitVisibleFaces(state, Vec3(0.0), radius, [&](std::uint32_t body, const FacePolygon& part) {
            Vec3 twice(0.0);
            for (std::size_t k = 2; k < part.size(); ++k) twice += glm::cross(part[k - 1] - part[0], part[k] - part[0]);
            areas[body] += glm::length(twice) / 2.0;
        });
        return areas;
    }

    WorldState state;
    std::size_t comparisons = 0;
};

}  // namespace

class VisibleFacesTest : public QObject {
    Q_OBJECT
private slots:
    void loneBoxShowsTheFacesTurnedToThePoint() {
        Bodies bodies;
        const std::uint32_t before = bodies.add(test::boxShape({2.0, 1.0, 1.0}), {0.0, 0.0, -5.0});
        const std::uint32_t beside = bodies.add(test::boxShape({1.0, 1.0, 1.0}), {5.0, 0.0, -5.0});
        const std::map<std::uint32_t, double> areas = bodies.areas();
        QVERIFY(std::abs(areas.at(before) - 2.0) < 1e-5);
        QVERIFY(std::abs(areas.at(beside) - 2.0) < 1e-5);  // two faces
    }
    void shadowsCoverWhatIsBehind() {
        Bodies bodies;
        bodies.add(test::boxShape({1.0, 1.0, 0.1}), {0.0, 0.0, -1.05});
        const std::uint32_t far = bodies.add(test::boxShape({6.0, 4.0, 0.1}), {0.0, 0.0, -3.05});
        const std::uint32_t hidden = bodies.add(test::boxShape({0.5, 0.5, 0.5}), {0.0, 0.0, -2.0});
        const std::map<std::uint32_t, double> areas = bodies.areas();
        QVERIFY(std::abs(areas.at(far) - (24.0 - 9.0)) < 1e-3);
        QVERIFY(!areas.contains(hidden));
    }
    void bodiesBeyondTheRadiusAreLeftOut() {
        Bodies bodies;
        bodies.add(test::boxShape(Vec3(1.0)), {0.0, 0.0, -5.0});
        QVERIFY(bodies.areas(3.0).empty());
        QCOMPARE(bodies.areas(5.0).size(), 1u);
    }
    void boxAroundThePointIsTransparent() {
        Bodies bodies;
        bodies.add(test::boxShape(Vec3(2.0)), Vec3(0.0));
        const std::uint32_t outside = bodies.add(test::boxShape(Vec3(2.0)), {0.0, 0.0, -5.0});
        const std::map<std::uint32_t, double> areas = bodies.areas();
        QCOMPARE(areas.size(), 1u);
        QVERIFY(std::abs(areas.at(outside) - 4.0) < 1e-5);
    }
    /// A face behind many small plates is halved, so that all shadows on it count.
    void manyShadowsDivideAFaceBoundedly_data() {
        QTest::addColumn<int>("side");
        for (const int side : {10, 20, 60}) QTest::addRow("%d plates", side * side) << side;
    }
    void manyShadowsDivideAFaceBoundedly() {
        QFETCH(int, side);
        Bodies bodies;
        const double width = 1.0 / side;
        const std::shared_ptr<const Shape> plate = test::boxShape({width, width, 0.001});
        for (int k = 0; k < side * side; ++k) {
            bodies.add(plate, {2.0 * width * (k % side + 0.5) - 1.0, 2.0 * width * (k / side + 0.5) - 1.0, -2.0});
        }
        const std::uint32_t wall = bodies.add(test::boxShape({2.0, 2.0, 0.1}), {0.0, 0.0, -2.06});
        const double area = bodies.areas().at(wall);
        QVERIFY2(std::abs(area - 3.0) < 0.05, qPrintable(QString::number(area)));  // a quarter is hidden
        std::size_t parts = 0;
        visitVisibleFaces(bodies.state, Vec3(0.0), 9.0,
                          [&](std::uint32_t body, const FacePolygon&) { parts += body == wall ? 1 : 0; });
        QVERIFY2(parts <= (kMaxVisibleParts + 16) << kMaxHalvings, qPrintable(QString::number(parts)));
    }
    void workGrowsAsTheNumberOfFragments() {
        std::map<int, std::size_t> comparisons;
        for (const int side : {32, 64, 128}) {
            Bodies bodies;
            const double width = 1.0 / side;
            const std::shared_ptr<const Shape> shape = test::boxShape({width, width, 0.05});
            for (int k = 0; k < side * side; ++k) {
                bodies.add(shape, {(k % side + 0.5) * width - 0.4, (k / side + 0.5) * width - 0.6, -0.5});
            }
            static_cast<void>(bodies.areas());
            comparisons[side] = bodies.comparisons;
        }
        QVERIFY2(comparisons[64] < 6 * comparisons[32], qPrintable(QString::number(comparisons[32])));
        QVERIFY2(comparisons[128] < 6 * comparisons[64], qPrintable(QString::number(comparisons[64])));
        QVERIFY(comparisons[32] < 100 * 32 * 32);
    }
};

RUBBLE_TEST(VisibleFacesTest)
#include "VisibleFacesTest.moc"
