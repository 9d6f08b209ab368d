// Tests core/geometry/predicates/WideInteger.h and core/geometry/predicates/BoundedDouble.h.
#include "core/geometry/predicates/WideInteger.h"

#include "core/base/Random.h"
#include "core/geometry/predicates/BoundedDouble.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

using WideFive = WideInteger<5>;

std::int64_t randomInteger(Random& random) { return static_cast<std::int64_t>(random.next()) >> random.below(64); }

}  // namespace

class WideIntegerTest : public QObject {
    Q_OBJECT
private slots:
    void computesAsIntegersOf128Bits() {
        Random random(1);
        for (int k = 0; k < 100'000; ++k) {
            const std::int64_t a = randomInteger(random), b = randomInteger(random);
            const Int128 product = Int128{a} * b;
            QVERIFY(WideFive(a) * WideFive(b) == WideFive(product));
            QVERIFY(WideFive(a) + WideFive(b) == WideFive(Int128{a} + b));
            QVERIFY(WideFive(a) - WideFive(b) == WideFive(Int128{a} - b));
            QVERIFY(-WideFive(product) == WideFive(-product));
            QCOMPARE(WideFive(product).sign(), product > 0 ? 1 : product < 0 ? -1 : 0);
            QCOMPARE(WideInteger<2>(product).rounded(), static_cast<double>(product));
        }
    }
    void productsOfManyFactorsAreExact() {
        Random random(2);
        for (int k = 0; k < 20'000; ++k) {
            WideFive a(std::int64_t{1}), b(std::int64_t{1});
            std::int64_t factors[4];
            for (std::int64_t& factor : factors) factor = randomInteger(random);
            for (int f = 0; f < 4; ++f) a = a * WideFive(factors[f]), b = b * WideFive(factors[3 - f]);
            QVERIFY(a == b);
            QVERIFY((a - b).sign() == 0);
            QVERIFY((a * WideFive(std::int64_t{3}) - a - a - a).sign() == 0);
            QVERIFY(WideInteger<8>(a) - WideInteger<8>(b) == WideInteger<8>(std::int64_t{0}));
        }
    }
    void roundsToTheNearestDoubles() {
        const WideFive large =
            WideFive(std::int64_t{1} << 62) * WideFive(std::int64_t{1} << 62) * WideFive(std::int64_t{1} << 62);
        QCOMPARE(large.rounded(), 0x1p186);
        QCOMPARE((-large).rounded(), -0x1p186);
        QCOMPARE((large + WideFive(std::int64_t{1})).rounded(), 0x1p186);
        QCOMPARE(WideFive(std::int64_t{0}).rounded(), 0.0);
    }
    void boundsHoldTheExactValue() {
        Random random(3);
        int undecided = 0;
        for (int k = 0; k < 100'000; ++k) {
            // A determinant of numbers of 40 bits, of which some nearly cancel.
            const std::int64_t a = randomInteger(random) >> 24, b = randomInteger(random) >> 24;
            const std::int64_t c = k % 2 == 0 ? a + 1 : randomInteger(random) >> 24, d = k % 2 == 0 ? b : c;
            const auto bounded = [](std::int64_t value) { return BoundedDouble(static_cast<double>(value)); };
            const BoundedDouble square = bounded(a) * bounded(d) - bounded(b) * bounded(c);
            const BoundedDouble fourth = square * square - bounded(a) * bounded(b) * bounded(c) * bounded(d);
            const WideFive exactSquare = WideFive(a) * WideFive(d) - WideFive(b) * WideFive(c);
            const WideFive exact = exactSquare * exactSquare - WideFive(a) * WideFive(b) * WideFive(c) * WideFive(d);
            QVERIFY(std::abs(exactSquare.rounded() - square.value) <= square.error * (1.0 + 1e-9));
            QVERIFY(std::abs(exact.rounded() - fourth.value) <= fourth.error * (1.0 + 1e-9) + 1e-300);
            if (fourth.sign() == 0)
                ++undecided;
            else
                QCOMPARE(fourth.sign(), exact.sign());
        }
        QVERIFY2(undecided < 30'000, qPrintable(QString::number(undecided)));
    }
};

RUBBLE_TEST(WideIntegerTest)
#include "WideIntegerTest.moc"
