#include "editor/widgets/EulerAngles.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class EulerAnglesTest : public QObject {
    Q_OBJECT
private slots:
    void anglesAreRecoveredFromTheirOrientation() {
        for (const Vec3 degrees : {Vec3{0, 0, 0}, Vec3{90, 0, 0}, Vec3{0, 90, 0}, Vec3{0, 0, -90}, Vec3{10, 20, 30},
                                   Vec3{-170, 45, 120}, Vec3{180, 0, 0}}) {
            QCOMPARE(eulerDegrees(orientationOf(degrees)), degrees);
        }
        const Quat half = orientationOf({0, 180, 0});
        QCOMPARE(half.y, 1.0);
        QCOMPARE(half.w, 0.0);
    }
};

RUBBLE_TEST(EulerAnglesTest)
#include "EulerAnglesTest.moc"
