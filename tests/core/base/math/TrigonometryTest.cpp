#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

constexpr double kPi = 0x1.921fb54442d18p+1;

/// The error of a value in ulp.
double errorInUlp(double value, long double truth) {
    const double rounded = static_cast<double>(truth);
    const double unit = std::nextafter(std::abs(rounded), INFINITY) - std::abs(rounded);
    return static_cast<double>(std::abs(value - truth) / unit);
}

}  // namespace

class TrigonometryTest : public QObject {
    Q_OBJECT
private slots:
    void fullTurnIsTwoPi() { QCOMPARE(kFullTurn, 2.0 * std::numbers::pi); }
    void knownAngles() {
        QCOMPARE(sine(0.0), 0.0);
        QCOMPARE(cosine(0.0), 1.0);
        QCOMPARE(sine(kPi / 2.0), 1.0);
        QCOMPARE(cosine(kPi), -1.0);
        QCOMPARE(sine(-kPi / 2.0), -1.0);
        QCOMPARE(cosine(kPi / 3.0), 0x1.0000000000001p-1);  // pi/3 is rounded down: the true value rounds to this
        QCOMPARE(sine(kPi), 0x1.1a62633145c07p-53);         // the rounding error of pi
    }
    void anglesOfPoints() {
        QCOMPARE(angleOf(0.0, 0.0), 0.0);
        QCOMPARE(angleOf(0.0, 2.0), 0.0);
        QCOMPARE(angleOf(3.0, 0.0), 0.5 * kPi);
        QCOMPARE(angleOf(0.0, -1.0), kPi);
        QCOMPARE(angleOf(-1e-300, 0.0), -0.5 * kPi);
        for (int k = -5000; k <= 5000; ++k) {
            const double angle = k * kPi / 5001.0;
            const double apart = angleOf(3.0 * std::sin(angle), 3.0 * std::cos(angle)) - angle;
            QVERIFY2(std::abs(apart) < 2e-15, qPrintable(QString("%1 at %2").arg(apart).arg(angle)));
        }
        QCOMPARE(std::bit_cast<std::uint64_t>(angleOf(1.0, 2.0)), std::uint64_t{0x3fddac670561bb50u});
    }
    void bitsAreFixed() {
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
    void errorIsBelowOneUlp_data() {
        QTest::addColumn<double>("range");
        for (const double range : {1e-300, 1e-8, 0.5, 10.0, 1000.0, kMaxAngle}) QTest::addRow("%g", range) << range;
    }
    void errorIsBelowOneUlp() {
        QFETCH(double, range);
        const std::uint64_t seed = 31;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int i = 0; i < 20000; ++i) {
            const double angle = random.between(-range, range);
            QVERIFY(errorInUlp(sine(angle), std::sin(static_cast<long double>(angle))) < 1.0);
            QVERIFY(errorInUlp(cosine(angle), std::cos(static_cast<long double>(angle))) < 1.0);
        }
    }
    void errorIsBelowOneUlpNearZeros() {
        // The doubles next to multiples of pi/2: all digits of the result come from the reduction.
        for (int turns = 1; turns < 600000; turns += 997) {
            const double angle = turns * (kPi / 2.0);
            const long double wide = angle;
            QVERIFY(errorInUlp(turns % 2 == 0 ? sine(angle) : cosine(angle),
                               turns % 2 == 0 ? std::sin(wide) : std::cos(wide)) < 1.0);
        }
    }
};

RUBBLE_TEST(TrigonometryTest)
#include "TrigonometryTest.moc"
