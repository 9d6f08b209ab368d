#include "core/base/Random.h"
#include "core/base/Trigonometry.h"

#include <QTest>

#include <bit>
#include <cmath>

using namespace rubble;

namespace {

constexpr double kPi = 0x1.921fb54442d18p+1;

/// How far a value is from the true one, in units of the true one's last place.
double unitsOff(double value, long double truth) {
    const double rounded = static_cast<double>(truth);
    const double unit = std::nextafter(std::abs(rounded), INFINITY) - std::abs(rounded);
    return static_cast<double>(std::abs(value - truth) / unit);
}

}  // namespace

class TrigonometryTest : public QObject {
    Q_OBJECT
private slots:
    void wellKnownAngles() {
        QCOMPARE(sine(0.0), 0.0);
        QCOMPARE(cosine(0.0), 1.0);
        QCOMPARE(sine(kPi / 2.0), 1.0);
        QCOMPARE(cosine(kPi), -1.0);
        QCOMPARE(sine(-kPi / 2.0), -1.0);
        QCOMPARE(cosine(kPi / 3.0), 0x1.0000000000001p-1);  // pi/3 is rounded down: the true value rounds to this
        QCOMPARE(sine(kPi), 0x1.1a62633145c07p-53);         // what pi's double lacks of pi
    }
    void theBitsAreFixedForEver() {
        QCOMPARE(std::bit_cast<std::uint64_t>(sine(1.0)), std::uint64_t{0x3feaed548f090ceeu});
        QCOMPARE(std::bit_cast<std::uint64_t>(cosine(1.0)), std::uint64_t{0x3fe14a280fb5068cu});
        QCOMPARE(std::bit_cast<std::uint64_t>(sine(1e6)), std::uint64_t{0xbfd6664b2568d867u});
    }
    void symmetries() {
        for (double angle = 0.1; angle < 50.0; angle += 0.37) {
            QCOMPARE(sine(-angle), -sine(angle));
            QCOMPARE(cosine(-angle), cosine(angle));
        }
    }
    void everyAngleIsWithinOneUnit_data() {
        QTest::addColumn<double>("reach");
        for (const double reach : {1e-300, 1e-8, 0.5, 10.0, 1000.0, kLargestAngle}) QTest::addRow("%g", reach) << reach;
    }
    void everyAngleIsWithinOneUnit() {
        QFETCH(double, reach);
        const std::uint64_t seed = 31;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int i = 0; i < 20000; ++i) {
            const double angle = random.between(-reach, reach);
            QVERIFY(unitsOff(sine(angle), std::sin(static_cast<long double>(angle))) < 1.0);
            QVERIFY(unitsOff(cosine(angle), std::cos(static_cast<long double>(angle))) < 1.0);
        }
    }
    void zerosAreExactToTheLastPlace() {
        // The doubles next to multiples of pi/2: all digits of the result come from the reduction.
        for (int turns = 1; turns < 600000; turns += 997) {
            const double angle = turns * (kPi / 2.0);
            const long double wide = angle;
            QVERIFY(unitsOff(turns % 2 == 0 ? sine(angle) : cosine(angle),
                             turns % 2 == 0 ? std::sin(wide) : std::cos(wide)) < 1.0);
        }
    }
};

QTEST_APPLESS_MAIN(TrigonometryTest)
#include "TrigonometryTest.moc"
