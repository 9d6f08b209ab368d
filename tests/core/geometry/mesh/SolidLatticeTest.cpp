// Tests core/geometry/mesh/SolidLattice.cpp.
#include "core/geometry/mesh/SolidLattice.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>

using namespace rubble;

class SolidLatticeTest : public QObject {
    Q_OBJECT
private slots:
    void latticeKeepsPointsWithinHalfAStep() {
        Random random(6);
        for (int k = 0; k < 1000; ++k) {
            const double size = std::exp2(random.between(-30.0, 30.0));
            const Vec3 low(random.between(-size, size), random.between(-size, size), random.between(-size, size));
            Box3 box;
            box.include(low);
            box.include(low + Vec3(size, 0.5 * size, random.between(0.0, size)));
            const SolidLattice lattice(box);
            QVERIFY(lattice.step() * kLatticeSteps <= 2.0 * box.diagonal());
            QVERIFY(lattice.step() * kLatticeSteps >= box.diagonal());
            const Vec3 point(random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y), box.max.z);
            const Vec3 steps = lattice.snapped(point);
            for (int c = 0; c < 3; ++c) {
                QVERIFY(steps[c] >= 0.0 && steps[c] <= kLatticeSteps && steps[c] == std::floor(steps[c]));
                QVERIFY(std::abs(lattice.origin()[c] + lattice.metres(steps)[c] - point[c]) <=
                        0.5 * lattice.step() + 1e-15 * (std::abs(point[c]) + size));
            }
        }
    }
};

RUBBLE_TEST(SolidLatticeTest)
#include "SolidLatticeTest.moc"
