#include "core/base/Random.h"
#include "core/io/text/NumberText.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

using namespace rubble;

class NumberTextTest : public QObject {
    Q_OBJECT
private slots:
    void roundNumbersAreShort() {
        QCOMPARE(numberText(1.0), "1");
        QCOMPARE(numberText(-2.5), "-2.5");
        QCOMPARE(numberText(0.1), "0.1");
        QCOMPARE(numberText(0.1 + 0.2), "0.30000000000000004");
        QCOMPARE(numberText(1e-7), "1e-07");
        QCOMPARE(numberText(1e22), "1e+22");
    }
    void negativeZeroIsWrittenAsZero() { QCOMPARE(numberText(-0.0), "0"); }
    void floatsAreTheShortestThatReadBack() {
        const auto textOf = [](double value) {
            std::string text;
            appendFloat(text, value);
            return text;
        };
        QCOMPARE(textOf(0.1), "0.1");
        QCOMPARE(textOf(1.0 / 3.0), "0.33333334");
        QCOMPARE(textOf(-0.0), "0");
        QCOMPARE(textOf(-1e-60), "0");
        QCOMPARE(textOf(std::numeric_limits<float>::max()), "3.4028235e+38");
        Random random(7);
        for (int k = 0; k < 1000; ++k) {
            const auto value = static_cast<float>(random.between(-50.0, 50.0));
            const std::string text = textOf(double{value});
            float read = 0.0f;
            std::from_chars(text.data(), text.data() + text.size(), read);
            QCOMPARE(read, value);
        }
    }
    void longestNumbersFit() {
        QCOMPARE(numberText(-std::numeric_limits<double>::min()), "-2.2250738585072014e-308");
        QCOMPARE(numberText(-std::numeric_limits<double>::min()).size(), kMaxNumberLength);
        QCOMPARE(numberText(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
        QCOMPARE(numberText(std::numeric_limits<double>::denorm_min()), "5e-324");
    }
    void numbersAreAppended() {
        std::string text = "v ";
        appendNumber(text, 0.25);
        appendNumber(text, std::uint32_t{4294967295u});
        QCOMPARE(text, "v 0.254294967295");
    }
    void doublesRoundTrip() {
        const std::uint64_t seed = 20;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int i = 0; i < 100000; ++i) {
            const double value = std::bit_cast<double>(random.next());
            if (!std::isfinite(value)) continue;
            const std::string text = numberText(value);
            double read = 0.0;
            const auto end = std::from_chars(text.data(), text.data() + text.size(), read);
            QCOMPARE(end.ptr, text.data() + text.size());
            QCOMPARE(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value));
        }
    }
};

RUBBLE_TEST(NumberTextTest)
#include "NumberTextTest.moc"
