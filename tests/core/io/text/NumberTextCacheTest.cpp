#include "core/io/text/NumberTextCache.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class NumberTextCacheTest : public QObject {
    Q_OBJECT
private slots:
    void cachedTextsAreThoseOfWriteNumber() {
        NumberTextCache cache;
        for (int round = 0; round < 3; ++round) {
            for (int k = -500; k < 500; ++k) {  // more numbers than entries
                const double value = k / 7.0;
                char cached[kMaxNumberLength], written[kMaxNumberLength];
                QCOMPARE(std::string(cached, cache.write(cached, value)),
                         std::string(written, writeNumber(written, value)));
            }
        }
    }
    void zeroIsNotTakenForAnEmptyEntry() {
        NumberTextCache cache;
        char text[kMaxNumberLength];
        QCOMPARE(std::string(text, cache.write(text, 0.0)), std::string("0"));
        QCOMPARE(std::string(text, cache.write(text, -0.0)), std::string("0"));
    }
};

RUBBLE_TEST(NumberTextCacheTest)
#include "NumberTextCacheTest.moc"
