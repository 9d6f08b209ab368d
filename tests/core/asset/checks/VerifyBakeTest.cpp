#include "core/asset/checks/VerifyBake.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/LayeredBox.h"

#include <functional>

using namespace rubble;

namespace {

using BakeDamage = std::function<void(Bake&)>;

}  // namespace
Q_DECLARE_METATYPE(BakeDamage)

class VerifyBakeTest : public QObject {
    Q_OBJECT
private slots:
    void damagedBakesAreDetected_data() {
        QTest::addColumn<BakeDamage>("damage");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* sentence, const BakeDamage& damage) {
            QTest::newRow(sentence) << damage << sentence;
        };
        row("Asset \"box\": the bake was computed from a different asset.", [](Bake& b) { b.asset = 7; });
        row("Asset \"box\": the bake was computed from a different asset.", [](Bake& b) { b.input = {}; });
        row("Asset \"box\": a hull of the whole: 6 faces have 5 planes.",
            [](Bake& b) { b.wholeHulls[0].planes.pop_back(); });
        row("Asset \"box\": the whole has no fracture.", [](Bake& b) { b.fractures.clear(); });
        row("Asset \"box\": the whole has no fracture.", [](Bake& b) { b.fractures[0].parent = 1; });
        row("Asset \"box\": fragment 2 has the wrong number.", [](Bake& b) { b.fractures[1].first = 3; });
        row("Asset \"box\": fragment 6 does not belong to the next fractured fragment.",
            [](Bake& b) { b.fractures[2].parent = 0; });
        row("Asset \"box\": fragment 6 does not belong to the next fractured fragment.",
            [](Bake& b) { b.fractures[2].parent = 6; });
        row("Asset \"box\": fragment 3/5.1 has fragments of a wrong level.", [](Bake& b) { b.fractures[2].level = 2; });
        row("Asset \"box\": fragment 3/5.1/6.3 is fractured below the last level.", [](Bake& b) {
            b.fractures.push_back(b.fractures[2]);
            b.fractures[3].parent = 9;
            b.fractures[3].first = 10;
        });
        row("Asset \"box\": Fragment 1 does not have its centre of mass as origin.", [](Bake& b) {
            Fragments& fragments = b.fractures[0].fragments;
            fragments.extruded()->records[fragments.extruded()->pieceOfFragment[1]].moments.centre.x += 0.5;
        });
        row("Asset \"box\": Fragment 3/5.7 should be 3/5.1.", [](Bake& b) { b.fractures[0].seeds.ids[1].index = 7; });
        row("Asset \"box\": fragment 3/5.1: There are 3 fragments, but 4 when it is fractured again.",
            [](Bake& b) { b.fractures[2].fragments.extruded()->pieceOfFragment.pop_back(); });
        row("Asset \"box\": fragment 3/5.1: The fragments have the wrong offset.",
            [](Bake& b) { b.fractures[2].fragments.origin.x += 0.1; });
    }
    void damagedBakesAreDetected() {
        QFETCH(BakeDamage, damage);
        QFETCH(QString, sentence);
        Bake result = *bake(layeredBox());
        damage(result);
        QCOMPARE(QString::fromStdString(verifyBake(result, layeredBox()).value_or("")), sentence);
    }
};

RUBBLE_TEST(VerifyBakeTest)
#include "VerifyBakeTest.moc"
