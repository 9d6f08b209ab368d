#include "core/fracture/layer/SeedId.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class SeedIdTest : public QObject {
    Q_OBJECT
private slots:
    void textIsLayerAndIndex() { QCOMPARE((SeedId{4, 17}.text()), "4.17"); }
    void idsAreOrderedByLayerThenIndex() {
        QVERIFY((SeedId{1, 9} < SeedId{2, 0}));
        QVERIFY((SeedId{2, 1} < SeedId{2, 10}));
    }
    void placeWithoutAnIndexNamesNoSeed() {
        QVERIFY(!seedOf({.layer = 4}));
        QVERIFY((seedOf({.layer = 4, .index = 0}) == SeedId{4, 0}));
    }
};

RUBBLE_TEST(SeedIdTest)
#include "SeedIdTest.moc"
