#include "core/asset/compare/BondingDifference.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/BondedProject.h"

#include <functional>

using namespace rubble;

namespace {

/// What differs after a change of the bonded box, in sentences.
std::string changesAfter(const std::function<void(Asset&)>& change) {
    const Project before = bondedProject();
    Project after = before;
    change(after.assets[0]);
    std::string text;
    for (const RecipeChange& each : recipeChanges(before, before.assets[0], after, after.assets[0]))
        text += sentenceOf(each) + "\n";
    return text;
}

}  // namespace

class BondingDifferenceTest : public QObject {
    Q_OBJECT
private slots:
    void equalAssetsHaveNone() {
        const Asset box = bondedProject().assets[0];
        QVERIFY(bondingChanges(box, box).empty());
        QCOMPARE(changesAfter([](Asset&) {}), std::string());
    }
    void everySettingIsNamed() {
        const Asset box = bondedProject().assets[0];
        Asset plain = box;
        plain.breakAs = BreakAs::Whole;
        plain.bonding = {};
        std::string text;
        for (const RecipeChange& change : bondingChanges(plain, box)) text += sentenceOf(change) + "\n";
        QCOMPARE(text, std::string("breaks as: bonded, was whole\n"
                                   "impulse per area of bonds: 1234.5 N·s/m², was from the material\n"
                                   "radius of hits on bonds: 0.7 m, was 0.3 m\n"
                                   "falloff of hits on bonds: smooth, was linear\n"
                                   "load that leaves damage: 0.3333333333333333, was 0.5\n"
                                   "span of bonds: 1.25 m, was any\n"
                                   "collapse delay: 0.75 s, was 0.2 s\n"
                                   "least island: 3 fragments, was 1 fragment\n"
                                   "strokes of bond brushes: 3, was 0\n"
                                   "bond strength by height: 3 at 0.25 m, 0.125 at 0.5 m, was none\n"
                                   "bond strength by picture: 0.25 to 4, 2 x 2 pixels, was none\n"
                                   "fragments that never break: 3.1, 3.4, was none\n"
                                   "clusters of fragments: 1 of level 0, 1 of level 1, was none\n"));
    }
    void differencesThatTheirTextsDoNotShowAreReported() {
        QCOMPARE(changesAfter([](Asset& box) { box.bonding.strokes[0].radius = 0.3; }),
                 std::string("strokes of bond brushes: 3, changed, was 3\n"));
        QCOMPARE(changesAfter([](Asset& box) {
                     box.bonding.clusters[1].fragments = {"3.1", "3.2"};
                 }),
                 std::string("clusters of fragments: 1 of level 0, 1 of level 1, changed, was 1 of level 0, 1 of level "
                             "1\n"));
        QCOMPARE(
            changesAfter([](Asset& box) {
                auto other = std::make_shared<GreyImage>(*box.bonding.strengthImage->image);
                other->grey[0] = 1;
                box.bonding.strengthImage->image = other;
            }),
            std::string("bond strength by picture: 0.25 to 4, 2 x 2 pixels, changed, was 0.25 to 4, 2 x 2 pixels\n"));
        QCOMPARE(changesAfter([](Asset& box) { box.levels[0].bondStrength = 2.0; }),
                 std::string("bond strength, of level 1: 2, was 0.5\n"));
    }
};

RUBBLE_TEST(BondingDifferenceTest)
#include "BondingDifferenceTest.moc"
