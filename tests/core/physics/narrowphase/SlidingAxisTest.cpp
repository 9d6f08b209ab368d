#include "core/physics/narrowphase/SlidingAxis.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A tile of 1 m, and a box of 1 m whose bottom is at `height` over the top of the tile and whose side is 10 mm before
/// it: it stands on the tile before. The axis that separates them most is -x, at 10 mm.
struct Tiles {
    Hull cube = hullOf(boxOf(Vec3(1.0)));
    RelativePose pose;
    SeparatingAxis axis;

    explicit Tiles(float height) : pose{{}, Vec3f(-1.01f, 1.0f + height, 0.0f)} {
        const auto side = static_cast<std::uint16_t>(cube.faceAlong(Vec3f(-1.0f, 0.0f, 0.0f)));
        axis = faceAxis({.kind = AxisKind::FirstFace, .first = side}, cube, cube, pose);
    }
    std::optional<SeparatingAxis> slide(Vec3f displacement) const {
        return slidingAxis(axis, cube, cube, pose, displacement);
    }
};

}  // namespace

class SlidingAxisTest : public QObject {
    Q_OBJECT
private slots:
    void boxSlidesOverTheSeamOfFlushTiles() {
        for (const float height : {0.0f, -0.0015f, 0.005f}) {  // bodies at rest overlap by up to 2 mm
            const auto axis = Tiles(height).slide(Vec3f(0.05f, 0.0f, 0.0f));
            QVERIFY(axis.has_value());
            QVERIFY(axis->isFace());
            QVERIFY(std::abs(axis->normal.y) > 0.99f);
            QVERIFY(std::abs(axis->separation - height) < 1e-6f);
        }
    }
    void boxBelowTheTopHitsTheSide() { QVERIFY(!Tiles(-0.003f).slide(Vec3f(0.05f, 0.0f, 0.0f))); }
    void boxThatDoesNotGetThereHasNoOtherAxis() {
        QVERIFY(!Tiles(0.0f).slide(Vec3f(0.0101f - 0.0005f, 0.0f, 0.0f)));
        QVERIFY(!Tiles(0.0f).slide(Vec3f(-0.05f, 0.0f, 0.0f)));
    }
    /// It falls onto the tile by more than 2 mm, behind its side.
    void boxThatSinksWhileItMovesHitsTheSide() { QVERIFY(!Tiles(0.0f).slide(Vec3f(0.05f, -0.0025f, 0.0f))); }
    /// It passes along x at 30 mm and rises by 5: both keep it apart, but along y there is more room in the end.
    void faceWithTheMostRoomAtTheEndIsTaken() {
        const Tiles tiles(0.005f);
        const auto axis = tiles.slide(Vec3f(0.0115f, 0.02f, 0.0f));
        QVERIFY(axis && std::abs(axis->normal.y) > 0.99f);
    }
    /// Thin hulls overlap by a tenth of their width at most.
    void thinHullsOverlapLess() {
        const Hull cube = hullOf(boxOf(Vec3(1.0))), sheet = hullOf(boxOf({1.0, 0.01, 1.0}));
        const auto side = static_cast<std::uint16_t>(cube.faceAlong(Vec3f(-1.0f, 0.0f, 0.0f)));
        const auto slides = [&](float height) {
            const RelativePose pose{{}, Vec3f(-1.01f, 0.505f + height, 0.0f)};
            const SeparatingAxis axis = faceAxis({.kind = AxisKind::FirstFace, .first = side}, cube, sheet, pose);
            return slidingAxis(axis, cube, sheet, pose, Vec3f(0.05f, 0.0f, 0.0f)).has_value();
        };
        QVERIFY(slides(-0.0009f));
        QVERIFY(!slides(-0.0011f));
    }
};

RUBBLE_TEST(SlidingAxisTest)
#include "SlidingAxisTest.moc"
