#include "core/base/math/Roots.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace rubble;

class RootsTest : public QObject {
    Q_OBJECT
private slots:
    void cubesHaveWholeRoots() {
        for (const double root : {1.0, 2.0, 3.0, 10.0, 0.5, 1024.0}) QCOMPARE(cubeRoot(root * root * root), root);
        QVERIFY(cubeRoot(0x1p-1074) == 0x1p-358);  // the smallest double
    }
    void errorIsTwoUlpAtMost() {
        Random random(20261126);
        for (int k = 0; k < 100000; ++k) {
            const double number = std::ldexp(random.between(0.5, 1.0), static_cast<int>(random.below(2000)) - 1000);
            const double expected = std::cbrt(number);  // itself within one ulp
            const double ulp = std::nextafter(expected, HUGE_VAL) - expected;
            QVERIFY2(std::abs(cubeRoot(number) - expected) <= 3.0 * ulp, qPrintable(QString::number(number, 'g', 17)));
        }
        QVERIFY(std::isfinite(cubeRoot(std::numeric_limits<double>::max())));
    }
};

RUBBLE_TEST(RootsTest)
#include "RootsTest.moc"
