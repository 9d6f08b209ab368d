#include "editor/canvas/painting/FragmentEdges.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

using namespace rubble;

namespace {

/// A box in two halves, each of which is in two again.
Bake halvedTwice() {
    Asset asset = boxAsset(2, 3, PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
    asset.levels = {{.pattern = {{{.id = 4, .parameters = UniformScatter{.count = 2}}}}}};
    return *bake(asset);
}

}  // namespace

class FragmentEdgesTest : public QObject {
    Q_OBJECT
private slots:
    void wholeHasFragmentsAndNoSurroundings() {
        const Bake bake = halvedTwice();
        QVERIFY(surroundingEdges(bake, {}).empty());
        QCOMPARE(fragmentsWithin(bake, {})->count(), std::uint32_t{2});
        QVERIFY(!deeperEdges(bake, {}).empty());
    }
    void fragmentIsSurroundedByItsSibling() {
        const Bake bake = halvedTwice();
        const FragmentPath half = bake.fragmentPath(0);
        QCOMPARE(fragmentsWithin(bake, half)->count(), std::uint32_t{2});
        QVERIFY(!surroundingEdges(bake, half).empty());
        QVERIFY(deeperEdges(bake, half).empty());  // nothing is below the second level
    }
    void missingFragmentHasNothing() {
        const Bake bake = halvedTwice();
        QVERIFY(fragmentsWithin(bake, "7.7") == nullptr);
        QVERIFY(surroundingEdges(bake, "7.7").empty());
    }
};

RUBBLE_TEST(FragmentEdgesTest)
#include "FragmentEdgesTest.moc"
