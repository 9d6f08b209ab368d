#include "core/asset/project/FragmentPath.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class FragmentPathTest : public QObject {
    Q_OBJECT
private slots:
    void descendantsAreWithinTheirAncestors() {
        QVERIFY(isWithin("5.17/9.2", ""));
        QVERIFY(isWithin("5.17/9.2", "5.17"));
        QVERIFY(isWithin("5.17", "5.17"));
        QVERIFY(!isWithin("5.17", "5.17/9.2"));
        QVERIFY(!isWithin("5.171/9.2", "5.17"));  // another seed
        QVERIFY(!isWithin("5.17.1", "5.17"));     // another part of the cell
    }
    void childOnPathAddsTheNextName() {
        QCOMPARE(childOnPath("", "5.17/9.2/4.0"), FragmentPath("5.17"));
        QCOMPARE(childOnPath("5.17", "5.17/9.2/4.0"), FragmentPath("5.17/9.2"));
        QCOMPARE(childOnPath("5.17/9.2", "5.17/9.2/4.0"), FragmentPath("5.17/9.2/4.0"));
        QCOMPARE(childOnPath("", ""), FragmentPath());
    }
};

RUBBLE_TEST_WITH(FragmentPathTest, QCoreApplication)
#include "FragmentPathTest.moc"
