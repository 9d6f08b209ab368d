#include "editor/document/FragmentChoice.h"

#include "core/base/Random.h"
#include "editor/document/FragmentHiding.h"
#include "tests/support/Projects.h"
#include "tests/support/RandomAssets.h"

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

class FragmentChoiceTest : public QObject {
    Q_OBJECT
private slots:
    void init() { m_random = std::make_unique<Random>(4711); }

    void aSetComesBackFromItsChoice() {
        for (int kind = 0; kind < 50; ++kind) {
            const Bake baked = randomBake(*m_random, kind);
            const FragmentSet set = randomSet(baked, *m_random);
            QCOMPARE(fragmentsOf(choiceOf(set, baked), baked), set);
        }
    }
    void allThatComesFromSeedsIsNamedByThemAlone() {
        const Bake baked = randomBake(*m_random, 0);
        const FragmentChoice all = choiceOf(allFragments(baked), baked);
        QVERIFY(!all.ids && all.seeds.size() == 4);
        QVERIFY(choiceOf(FragmentSet(baked.fragmentCount(), false), baked).isEmpty());
    }
    void aSetInsideAFragmentIsNamedBySeedsInThere() {
        for (int kind = 0; kind < 50; ++kind) {
            const Bake baked = randomBake(*m_random, kind);
            for (const BakedBreaking& breaking : baked.breakings) {
                if (breaking.parent == kNone) continue;
                const FragmentPath inside = pathOfId(baked.fragmentId(breaking.parent));
                FragmentSet one(baked.fragmentCount(), false);
                one[breaking.first] = true;
                const FragmentChoice choice = choiceOf(one, baked, inside);
                QCOMPARE(choice.inside, inside);
                QCOMPARE(fragmentsOf(choice, baked), one);
                // Seen from the whole, it is some of what comes from one seed.
                const auto top = pieceNameOf(inside)->seed;
                QVERIFY(choice.seedsInside({}) == FragmentChoice::Seeds{top});
                QVERIFY(!choice.holds({}, top, baked.fragmentId(breaking.parent)));
                QVERIFY(choice.holds(inside, *choice.seeds.begin(), baked.fragmentId(breaking.first)));

                one[breaking.parent] = true;  // does not lie inside
                const FragmentChoice both = choiceOf(one, baked, inside);
                QVERIFY(both.inside.empty());
                QCOMPARE(fragmentsOf(both, baked), one);
                QVERIFY(!both.ids || both.seedsInside(inside) == choice.seeds);
            }
        }
    }
    void whatComesFromASeedOfTheWholeHoldsAllInside() {
        const FragmentChoice all{{{5, 17}}, std::nullopt};
        QVERIFY(all.holds("5.17", {9, 2}, "3/5.17/9.2"));
        QVERIFY(all.holds("5.17.1/9.2", {4, 0}, "3/5.17.1/9.2/4.0"));
        QVERIFY(!all.holds("5.18", {9, 2}, "3/5.18/9.2"));
        QVERIFY(all.seedsInside("5.17").empty());  // they are not named
    }
    void namesOutlastAnotherBake() {
        Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.2, 0.5}}, {1, {0.5, 0.5}}, {2, {0.8, 0.5}}}});
        const FragmentChoice last = choiceOf({false, false, true}, *bake(asset));
        std::get<PlacedSeeds>(asset.pattern.layers[0].parameters)
            .seeds.erase(std::get<PlacedSeeds>(asset.pattern.layers[0].parameters).seeds.begin());
        QCOMPARE(fragmentsOf(last, *bake(asset)), (FragmentSet{false, true}));
    }
    void hidingIsolatingAndShowingFillSpace() {
        for (int kind = 0; kind < 50; ++kind) {
            const Bake baked = randomBake(*m_random, kind);
            const FragmentSet first = randomSet(baked, *m_random), second = randomSet(baked, *m_random);
            FragmentSet both = first;
            for (std::size_t k = 0; k < both.size(); ++k) both[k] = both[k] || second[k];
            Selection selection;
            selection.setChoice(choiceOf(first, baked));
            hideChosen(selection, baked);
            QVERIFY(selection.seeds().empty());
            selection.setChoice(choiceOf(second, baked));
            hideChosen(selection, baked);
            QCOMPARE(fragmentsOf(selection.hidden(), baked), completed(baked, both));

            selection.setChoice(choiceOf(both, baked));
            showChosen(selection, baked);
            QVERIFY(selection.hidden().isEmpty());
            isolateChosen(selection, baked);
            QCOMPARE(fragmentsOf(selection.hidden(), baked), completed(baked, invertedFragments(baked, both)));
            showAllFragments(selection);
            QVERIFY(selection.hidden().isEmpty());
        }
    }
    void isolatingNothingHidesNothing() {
        Selection selection;
        isolateChosen(selection, randomBake(*m_random, 1));
        QVERIFY(selection.hidden().isEmpty());
    }

private:
    std::unique_ptr<Random> m_random;
};

QTEST_GUILESS_MAIN(FragmentChoiceTest)
#include "FragmentChoiceTest.moc"
