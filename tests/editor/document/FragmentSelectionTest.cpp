#include "editor/document/FragmentSelection.h"

#include "core/base/Random.h"
#include "editor/document/FragmentVisibility.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomAssets.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

Bake randomBake(Random& random, int kind) {
    Asset asset = test::randomAsset(random, kind).assets.front();
    asset.levels = {{.pattern = {{{.id = 90, .parameters = UniformScatter{.count = 3}}}}, .minimumVolume = 0.02}};
    return *bake(asset);
}

FragmentSet randomSet(const Bake& bake, Random& random) {
    FragmentSet set;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) set.push_back(random.unit() < 0.4);
    return set;
}

}  // namespace

class FragmentSelectionTest : public QObject {
    Q_OBJECT
private slots:
    void init() { m_random = std::make_unique<Random>(4711); }

    void selectionOfASetNamesTheSet() {
        for (int kind = 0; kind < 50; ++kind) {
            const Bake baked = randomBake(*m_random, kind);
            const FragmentSet set = randomSet(baked, *m_random);
            QCOMPARE(fragmentsOf(selectionOf(set, baked), baked), set);
        }
    }
    void allFragmentsOfSeedsAreNamedBySeedsAlone() {
        const Bake baked = randomBake(*m_random, 0);
        const FragmentSelection all = selectionOf(allFragments(baked), baked);
        QVERIFY(!all.ids && all.seeds.size() == 4);
        QVERIFY(selectionOf(FragmentSet(baked.fragmentCount(), false), baked).isEmpty());
    }
    void setInsideAFragmentIsNamedByItsSeeds() {
        for (int kind = 0; kind < 50; ++kind) {
            const Bake baked = randomBake(*m_random, kind);
            for (const BakedFracture& fracture : baked.fractures) {
                if (fracture.parent == kNone) continue;
                const FragmentPath parent = baked.fragmentPath(fracture.parent);
                FragmentSet one(baked.fragmentCount(), false);
                one[fracture.first] = true;
                const FragmentSelection selection = selectionOf(one, baked, parent);
                QCOMPARE(selection.parent, parent);
                QCOMPARE(fragmentsOf(selection, baked), one);
                // In the whole asset's pattern, it is a part of one seed's fragments.
                const auto top = pieceNameOf(parent)->seed;
                QVERIFY(selection.seedsOf({}) == FragmentSelection::Seeds{top});
                QVERIFY(!selection.contains({}, top, baked.fragmentId(fracture.parent)));
                QVERIFY(selection.contains(parent, *selection.seeds.begin(), baked.fragmentId(fracture.first)));

                one[fracture.parent] = true;  // outside `parent`
                const FragmentSelection both = selectionOf(one, baked, parent);
                QVERIFY(both.parent.empty());
                QCOMPARE(fragmentsOf(both, baked), one);
                QVERIFY(!both.ids || both.seedsOf(parent) == selection.seeds);
            }
        }
    }
    void seedContainsAllItsDescendants() {
        const FragmentSelection all{{{5, 17}}, std::nullopt};
        QVERIFY(all.contains("5.17", {9, 2}, "3/5.17/9.2"));
        QVERIFY(all.contains("5.17.1/9.2", {4, 0}, "3/5.17.1/9.2/4.0"));
        QVERIFY(!all.contains("5.18", {9, 2}, "3/5.18/9.2"));
        QVERIFY(all.seedsOf("5.17").empty());  // they are selected through their ancestor
    }
    void selectionSurvivesANewBake() {
        Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.2, 0.5}}, {1, {0.5, 0.5}}, {2, {0.8, 0.5}}}});
        const FragmentSelection last = selectionOf({false, false, true}, *bake(asset));
        std::get<PlacedSeeds>(asset.pattern.layers[0].parameters)
            .seeds.erase(std::get<PlacedSeeds>(asset.pattern.layers[0].parameters).seeds.begin());
        QCOMPARE(fragmentsOf(last, *bake(asset)), (FragmentSet{false, true}));
    }
    void hideIsolateAndShowAreConsistent() {
        for (int kind = 0; kind < 50; ++kind) {
            const Bake baked = randomBake(*m_random, kind);
            const FragmentSet first = randomSet(baked, *m_random), second = randomSet(baked, *m_random);
            FragmentSet both = first;
            for (std::size_t k = 0; k < both.size(); ++k) both[k] = both[k] || second[k];
            Selection selection;
            selection.setFragments(selectionOf(first, baked));
            hideSelected(selection, baked);
            QVERIFY(selection.seeds().empty());
            selection.setFragments(selectionOf(second, baked));
            hideSelected(selection, baked);
            QCOMPARE(fragmentsOf(selection.hidden(), baked), completed(baked, both));

            selection.setFragments(selectionOf(both, baked));
            showSelected(selection, baked);
            QVERIFY(selection.hidden().isEmpty());
            isolateSelected(selection, baked);
            QCOMPARE(fragmentsOf(selection.hidden(), baked), completed(baked, invertedFragments(baked, both)));
            showAllFragments(selection);
            QVERIFY(selection.hidden().isEmpty());
        }
    }
    void isolatingNothingHidesNothing() {
        Selection selection;
        isolateSelected(selection, randomBake(*m_random, 1));
        QVERIFY(selection.hidden().isEmpty());
    }

private:
    std::unique_ptr<Random> m_random;
};

RUBBLE_TEST_WITH(FragmentSelectionTest, QCoreApplication)
#include "FragmentSelectionTest.moc"
