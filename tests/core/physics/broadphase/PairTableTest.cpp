#include "core/base/Random.h"
#include "core/physics/broadphase/PairTable.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <map>

using namespace rubble;

class PairTableTest : public QObject {
    Q_OBJECT
private slots:
    void orderOfAPairDoesNotMatter() {
        PairTable table;
        QCOMPARE(table.find(3, 5), kNone);
        QVERIFY(table.insert(5, 3, 7));
        QCOMPARE(table.find(3, 5), 7u);
        QCOMPARE(table.find(5, 3), 7u);
        table.erase(3, 5);
        QCOMPARE(table.find(5, 3), kNone);
    }
    void insertingTwiceKeepsTheFirst() {
        PairTable table;
        QVERIFY(table.insert(1, 2, 7));
        QVERIFY(!table.insert(2, 1, 8));
        QCOMPARE(table.find(1, 2), 7u);
    }
    void containsTheSameAsAMap() {
        Random random(3);
        PairTable table;
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> map;
        for (std::uint32_t i = 0; i < 50000; ++i) {
            const auto a = static_cast<std::uint32_t>(random.below(40)),
                       b = a + 1 + static_cast<std::uint32_t>(random.below(40));
            const auto found = map.find({a, b});
            QCOMPARE(table.find(a, b), found == map.end() ? kNone : found->second);
            if (found == map.end()) {
                QVERIFY(table.insert(a, b, i));
                map[{a, b}] = i;
            } else {
                table.erase(b, a);
                map.erase(found);
            }
        }
    }
};

RUBBLE_TEST(PairTableTest)
#include "PairTableTest.moc"
