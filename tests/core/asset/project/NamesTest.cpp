#include "core/asset/project/Names.h"

#include "core/asset/project/Project.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class NamesTest : public QObject {
    Q_OBJECT
private slots:
    void ownerIsKindIdAndName() {
        QCOMPARE(ownerText("Asset", 3, "wall"), "Asset 3 \"wall\"");
        QCOMPARE(ownerText("Asset", 3, ""), "Asset 3");
    }
    void onlyAsciiLettersAreFolded() { QCOMPARE(caseFolded("Wall AZ 9 Ä"), "wall az 9 Ä"); }
    void takenNamesAreNumbered() {
        std::vector<Asset> assets(2);
        assets[0].name = "Wall";
        assets[1].name = "wall 2";
        QVERIFY(isNameTaken(assets, "wALL"));
        QVERIFY(!isNameTaken(assets, "gate"));
        QCOMPARE(uniqueName(assets, "gate"), "gate");
        QCOMPARE(uniqueName(assets, "wall"), "wall 3");
        QCOMPARE(uniqueName(assets, "wall", {"wall 3"}), "wall 4");
        QCOMPARE(uniqueName(assets, "gate", {"gate"}), "gate");
    }
};

RUBBLE_TEST(NamesTest)
#include "NamesTest.moc"
