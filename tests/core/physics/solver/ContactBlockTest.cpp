#include "core/physics/solver/ContactBlock.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class ContactBlockTest : public QObject {
    Q_OBJECT
private slots:
    void couplingsOfAllPairs() {
        QCOMPARE(couplingIndex(0, 1), 0);
        QCOMPARE(couplingIndex(0, 2), 1);
        QCOMPARE(couplingIndex(0, 3), 2);
        QCOMPARE(couplingIndex(1, 2), 3);
        QCOMPARE(couplingIndex(1, 3), 4);
        QCOMPARE(couplingIndex(2, 3), 5);
    }
    void storedLaneComesBackInAnotherPlace() {
        ContactBlock block{};
        block.contact[3] = 77;
        block.pointCount[3] = 2;
        block.points[1].impulse[3] = 1.5f;
        block.torsionalImpulse[3] = -2.5f;
        const StoredLane<ContactBlock> stored = storedLane(block, 3);
        ContactBlock other{};
        other.contact[4] = 5;
        putLane(other, 6, stored);
        QCOMPARE(other.contact[6], 77u);
        QCOMPARE(other.pointCount[6], 2u);
        QCOMPARE(other.points[1].impulse[6], 1.5f);
        QCOMPARE(other.torsionalImpulse[6], -2.5f);
        QCOMPARE(other.contact[4], 5u);
        QCOMPARE(other.contact[7], 0u);
    }
    void vectorOfALane() {
        const Vec3Row rows{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}};
        QVERIFY(rows.at(2) == Vec3f(3.0f, 7.0f, 11.0f));
    }
};

RUBBLE_TEST(ContactBlockTest)
#include "ContactBlockTest.moc"
