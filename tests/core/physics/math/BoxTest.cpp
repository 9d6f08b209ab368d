#include "core/physics/math/Box.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

const Box kUnit{Vec3f(0.0f, 0.0f, 0.0f), Vec3f(1.0f, 1.0f, 1.0f)};

Box moved(const Box& box, Vec3f by) { return {box.low + by, box.high + by}; }

}  // namespace

class BoxTest : public QObject {
    Q_OBJECT
private slots:
    void boxesOverlapWhereTheyShareAPoint() {
        for (int axis = 0; axis < 3; ++axis) {
            for (const float sign : {-1.0f, 1.0f}) {
                Vec3f along(0.0f);
                along[axis] = sign;
                QVERIFY(kUnit.overlaps(moved(kUnit, along)));  // touching counts
                QVERIFY(!kUnit.overlaps(moved(kUnit, along * 1.001f)));
                QVERIFY(!moved(kUnit, along * 1.001f).overlaps(kUnit));
            }
        }
    }
    void boxContainsBoxesUpToItsBounds() {
        const Box inner{Vec3f(0.25f), Vec3f(0.75f)};
        QVERIFY(kUnit.contains(inner));
        QVERIFY(kUnit.contains(kUnit));
        QVERIFY(!inner.contains(kUnit));
        for (int axis = 0; axis < 3; ++axis) {
            for (const float sign : {-1.0f, 1.0f}) {
                Vec3f along(0.0f);
                along[axis] = sign * 0.3f;
                QVERIFY(!kUnit.contains(moved(inner, along)));
            }
        }
    }
    void measures() {
        const Box box{Vec3f(-1.0f, 0.0f, 2.0f), Vec3f(1.0f, 3.0f, 6.0f)};  // 2 x 3 x 4
        QCOMPARE(box.halfSurfaceArea(), 26.0f);
        QVERIFY(box.middle() == Vec3f(0.0f, 1.5f, 4.0f));
    }
    void joinedWidenedAndSwept() {
        const Box other{Vec3f(-1.0f, 0.5f, 0.5f), Vec3f(0.5f, 3.0f, 0.75f)};
        QVERIFY(joined(kUnit, other).low == Vec3f(-1.0f, 0.0f, 0.0f));
        QVERIFY(joined(kUnit, other).high == Vec3f(1.0f, 3.0f, 1.0f));
        QVERIFY(widened(kUnit, 0.5f).low == Vec3f(-0.5f));
        QVERIFY(widened(kUnit, 0.5f).high == Vec3f(1.5f));
        QVERIFY(swept(kUnit, Vec3f(2.0f, -3.0f, 0.0f)).low == Vec3f(0.0f, -3.0f, 0.0f));
        QVERIFY(swept(kUnit, Vec3f(2.0f, -3.0f, 0.0f)).high == Vec3f(3.0f, 1.0f, 1.0f));
    }
};

RUBBLE_TEST(BoxTest)
#include "BoxTest.moc"
