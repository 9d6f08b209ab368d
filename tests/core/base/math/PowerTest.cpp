#include "core/base/Random.h"
#include "core/base/math/Power.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <bit>
#include <cmath>

using namespace rubble;

class PowerTest : public QObject {
    Q_OBJECT
private slots:
    void knownPowers() {
        QCOMPARE(power(0.0, 0.0), 1.0);
        QCOMPARE(power(0.0, 1.5), 0.0);
        QCOMPARE(power(1.0, 123.0), 1.0);
        QCOMPARE(power(7.0, 0.0), 1.0);
        QCOMPARE(power(2.0, 10.0), 1024.0);
        QCOMPARE(power(0.25, 0.5), 0.5);
    }
    void bitsAreFixed() {
        QCOMPARE(std::bit_cast<std::uint64_t>(power(3.0, 1.5)), std::uint64_t{0x4014c8dc2e423980u});
        QCOMPARE(std::bit_cast<std::uint64_t>(power(0.1, 0.3)), std::uint64_t{0x3fe009b9cf334253u});
        QCOMPARE(std::bit_cast<std::uint64_t>(power(1e-300, 0.9)), std::uint64_t{0x07e0e7c9eebc43a1u});
    }
    void randomPowersMatchLongDouble() {
        const std::uint64_t seed = 17;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int i = 0; i < 20000; ++i) {
            const double base = std::ldexp(1.0 + random.unit(), static_cast<int>(random.between(-60.0, 60.0)));
            const double exponent = random.between(-5.0, 5.0);
            const long double truth = std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
            const double tolerance = 1e-14 * (1.0 + std::abs(exponent * std::log(base)));
            QVERIFY(std::abs(power(base, exponent) / truth - 1.0L) < tolerance);
        }
    }
};

RUBBLE_TEST(PowerTest)
#include "PowerTest.moc"
