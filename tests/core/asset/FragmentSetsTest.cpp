#include "core/asset/FragmentSets.h"

#include "core/base/Random.h"
#include "tests/support/Projects.h"
#include "tests/support/RandomAssets.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

using namespace rubble;

namespace {

constexpr int kBakes = 60;

/// An asset of up to three levels; some of its fragments are broken again and some are not.
Bake randomBake(Random& random, int kind) {
    Asset asset = test::randomAsset(random, kind).assets.front();
    asset.pattern.layers[0].parameters = UniformScatter{.count = static_cast<std::uint32_t>(2 + random.below(12))};
    for (std::uint64_t level = random.below(3); level > 0; --level) {
        Level next{.minimumVolume = random.between(0.0, 0.05)};
        next.pattern.layers = {
            {.id = 90 + static_cast<Id>(level), .randomSeed = random.next(), .parameters = UniformScatter{.count = 4}}};
        asset.levels.push_back(next);
    }
    return *bake(asset);
}

FragmentSet randomSet(const Bake& bake, Random& random) {
    const double share = random.unit();
    FragmentSet set(bake.fragmentCount());
    for (std::size_t k = 0; k < set.size(); ++k) set[k] = random.unit() < share;
    return set;
}

/// What a set holds by asking of each fragment alone.
FragmentSet setOf(const Bake& bake, const std::function<bool(std::uint32_t)>& isIn) {
    FragmentSet set;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) set.push_back(isIn(k));
    return set;
}

bool isCovered(const Bake& bake, const FragmentSet& set, std::uint32_t fragment) {
    for (; fragment != kNone; fragment = bake.fragment(fragment).parent) {
        if (set[fragment]) return true;
    }
    return false;
}

bool isFilled(const Bake& bake, const FragmentSet& set, std::uint32_t fragment) {
    if (isCovered(bake, set, fragment)) return true;
    const BakedFragment baked = bake.fragment(fragment);
    for (std::uint32_t k = 0; k < baked.childCount; ++k) {
        if (!isFilled(bake, set, baked.firstChild + k)) return false;
    }
    return baked.childCount > 0;
}

bool touchesOne(const Bake& bake, const FragmentSet& set, std::uint32_t fragment) {
    const BakedFragment baked = bake.fragment(fragment);
    for (const Bond& bond : baked.solid.bonds()) {
        if (set[baked.firstSibling + bond.fragment]) return true;
    }
    return false;
}

bool hasRelative(const Bake& bake, const FragmentSet& set, const std::function<bool(std::uint32_t)>& isRelative) {
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        if (set[k] && isRelative(k)) return true;
    }
    return false;
}

}  // namespace

/// Each function against a slow one that looks at every fragment by itself, on random bakes of several levels.
class FragmentSetsTest : public QObject {
    Q_OBJECT
private slots:
    void init() { m_random = std::make_unique<Random>(20261122); }

    void piecesGoWithWhatTheyArePiecesOf() {
        forEachBake([](const Bake& bake, const FragmentSet& set) {
            QCOMPARE(withPieces(bake, set), setOf(bake, [&](std::uint32_t k) { return isCovered(bake, set, k); }));
            QCOMPARE(completed(bake, set), setOf(bake, [&](std::uint32_t k) { return isFilled(bake, set, k); }));
        });
    }
    void invertingGivesWhatIsLeft() {
        forEachBake([](const Bake& bake, const FragmentSet& set) {
            const FragmentSet rest = invertedFragments(bake, set);
            QCOMPARE(rest, setOf(bake, [&](std::uint32_t k) {
                         return bake.fragment(k).childCount == 0 && !isCovered(bake, set, k);
                     }));
            QCOMPARE(completed(bake, invertedFragments(bake, rest)), completed(bake, set));
        });
    }
    void neighboursTouch() {
        forEachBake([](const Bake& bake, const FragmentSet& set) {
            QCOMPARE(withNeighbours(bake, set),
                     setOf(bake, [&](std::uint32_t k) { return set[k] || touchesOne(bake, set, k); }));
        });
    }
    void relativesAreFound() {
        forEachBake([](const Bake& bake, const FragmentSet& set) {
            const auto parent = [&](std::uint32_t k) { return bake.fragment(k).parent; };
            QCOMPARE(siblingsOf(bake, set), setOf(bake, [&](std::uint32_t k) {
                         return hasRelative(bake, set, [&](std::uint32_t other) { return parent(other) == parent(k); });
                     }));
            QCOMPARE(parentsOf(bake, set), setOf(bake, [&](std::uint32_t k) {
                         return hasRelative(bake, set, [&](std::uint32_t other) { return parent(other) == k; });
                     }));
            QCOMPARE(childrenOf(bake, set), setOf(bake, [&](std::uint32_t k) {
                         return hasRelative(bake, set, [&](std::uint32_t other) { return parent(k) == other; });
                     }));
        });
    }
    void levelsAndVolumesAreAsTheFragmentsSay() {
        forEachBake([](const Bake& bake, const FragmentSet&) {
            std::uint32_t deepest = 0;
            for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k)
                deepest = std::max(deepest, bake.fragment(k).level);
            QCOMPARE(levelCount(bake), deepest + 1);
            for (std::uint32_t level = 0; level <= deepest; ++level) {
                QCOMPARE(fragmentsOfLevel(bake, level),
                         setOf(bake, [&](std::uint32_t k) { return bake.fragment(k).level == level; }));
            }
            const double least = bake.fragment(0).solid.volume() / 2.0, most = 3.0 * least;
            QCOMPARE(fragmentsOfVolume(bake, least, most), setOf(bake, [&](std::uint32_t k) {
                         const BakedFragment fragment = bake.fragment(k);
                         const double volume = fragment.solid.volume();
                         return fragment.childCount == 0 && volume >= least && volume <= most;
                     }));
        });
    }
    void aShareIsAsLargeAsAskedForAndOfSmallestOnes() {
        forEachBake([](const Bake& bake, const FragmentSet&) {
            const FragmentSet smallest = smallestFragments(bake);
            const auto all = std::ranges::count(smallest, true);
            FragmentSet before(bake.fragmentCount(), false);
            for (const double share : {0.0, 0.3, 0.5, 1.0}) {
                const FragmentSet some = randomFragments(bake, share, 5);
                QCOMPARE(std::ranges::count(some, true), std::llround(share * static_cast<double>(all)));
                for (std::size_t k = 0; k < some.size(); ++k) QVERIFY(smallest[k] || !some[k]);
                for (std::size_t k = 0; k < some.size(); ++k) QVERIFY(some[k] || !before[k]);
                before = some;
            }
            QCOMPARE(before, smallest);
            QCOMPARE(randomFragments(bake, 0.5, 8), randomFragments(bake, 0.5, 8));
        });
    }
    void anotherRandomSeedGivesOthers() {
        Asset asset = boxAsset(3, 5, UniformScatter{.count = 40});
        const Bake baked = *bake(asset);
        QVERIFY(randomFragments(baked, 0.5, 1) != randomFragments(baked, 0.5, 2));
    }

private:
    void forEachBake(const std::function<void(const Bake&, const FragmentSet&)>& check) {
        for (int kind = 0; kind < kBakes && !QTest::currentTestFailed(); ++kind) {
            const Bake baked = randomBake(*m_random, kind);
            check(baked, randomSet(baked, *m_random));
            if (QTest::currentTestFailed()) qWarning("bake %d of random seed 20261122", kind);
        }
    }
    std::unique_ptr<Random> m_random;
};

QTEST_GUILESS_MAIN(FragmentSetsTest)
#include "FragmentSetsTest.moc"
