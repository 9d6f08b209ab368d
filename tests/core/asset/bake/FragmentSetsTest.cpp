// Tests core/asset/bake/FragmentSets.cpp and core/asset/bake/NeighboursAcrossParents.cpp.
#include "core/asset/bake/FragmentSets.h"

#include "core/asset/bake/NeighboursAcrossParents.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomAssets.h"

#include <QTest>

#include <glm/geometric.hpp>

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
    const double fraction = random.unit();
    FragmentSet set(bake.fragmentCount());
    for (std::size_t k = 0; k < set.size(); ++k) set[k] = random.unit() < fraction;
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
    for (const FragmentContact& contact : baked.solid.contacts()) {
        if (set[baked.firstSibling + contact.fragment]) return true;
    }
    return false;
}

/// A fragment's edges in the asset's frame.
std::vector<std::pair<Vec2, Vec2>> edgesOf(const Bake& bake, std::uint32_t fragment) {
    const Fragment solid = bake.fragment(fragment).solid;
    const Polygon outline = solid.extruded()->outline();
    std::vector<std::pair<Vec2, Vec2>> edges;
    const auto add = [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            edges.emplace_back(Vec2{solid.offset()} + ring[k], Vec2{solid.offset()} + ring[(k + 1) % ring.size()]);
        }
    };
    add(outline.outer);
    for (const Ring& hole : outline.holes) add(hole);
    return edges;
}

/// How far two edges run along each other the opposite way, m, on one line up to rounding.
double sharedLength(const std::pair<Vec2, Vec2>& one, const std::pair<Vec2, Vec2>& other) {
    const Vec2 along = glm::normalize(one.second - one.first);
    const Vec2 across(-along.y, along.x);
    for (const Vec2 end : {other.first, other.second}) {
        if (std::abs(glm::dot(end - one.first, across)) > 1e-11) return 0.0;
    }
    const double from = glm::dot(other.second - one.first, along), to = glm::dot(other.first - one.first, along);
    return std::min(to, glm::distance(one.first, one.second)) - std::max(from, 0.0);
}

/// Whether one of its edges lies on one of the other's.
bool liesAgainst(const Bake& bake, std::uint32_t fragment, std::uint32_t other) {
    for (const auto& one : edgesOf(bake, fragment)) {
        for (const auto& against : edgesOf(bake, other)) {
            if (sharedLength(one, against) > bake.fractures[0].fragments.extruded()->minSharedEdge) return true;
        }
    }
    return false;
}

/// Whether a selected fragment of its level, or of a deeper one if it is not broken, lies against it without being made
/// with it.
bool touchesAcross(const Bake& bake, const FragmentSet& set, std::uint32_t fragment) {
    const BakedFragment baked = bake.fragment(fragment);
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        const BakedFragment selected = bake.fragment(k);
        const bool isOnLevel = selected.level == baked.level || (selected.level > baked.level && baked.childCount == 0);
        if (!set[k] || !isOnLevel || selected.parent == baked.parent) continue;
        if (liesAgainst(bake, fragment, k)) return true;
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

    void descendantsAreAddedAndCompleteParents() {
        forEachBake([](const Bake& bake, const FragmentSet& set) {
            QCOMPARE(withDescendants(bake, set), setOf(bake, [&](std::uint32_t k) { return isCovered(bake, set, k); }));
            QCOMPARE(completed(bake, set), setOf(bake, [&](std::uint32_t k) { return isFilled(bake, set, k); }));
        });
    }
    void rootsHaveNoAncestorInTheSet() {
        forEachBake([](const Bake& bake, const FragmentSet& set) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
                const std::uint32_t parent = bake.fragment(k).parent;
                if (set[k] && (parent == kNone || !isCovered(bake, set, parent))) expected.push_back(k);
            }
            QVERIFY(rootsOf(bake, set) == expected);
        });
    }
    void inversionGivesTheRemainingLeaves() {
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
            QCOMPARE(withNeighbours(bake, set), setOf(bake, [&](std::uint32_t k) {
                         return set[k] || touchesOne(bake, set, k) || touchesAcross(bake, set, k);
                     }));
        });
    }
    void neighboursTouchAcrossAGap() {
        // Two halves, each cut in two at other heights: 0.4 on the left, 0.7 on the right.
        Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        const auto halves = [](Id layer, double height) {
            const double y = height - 0.5;
            return Level{
                .pattern = {{{.id = layer, .parameters = PlacedSeeds{{{0, {0.0, y - 0.1}}, {1, {0.0, y + 0.1}}}}}}}};
        };
        asset.fragmentLevels = {{"5.0", halves(6, 0.4)}, {"5.1", halves(7, 0.7)}};
        for (const double gap : {0.0, 0.02}) {
            asset.shaping.gap = gap;
            const Bake baked = *bake(asset);
            QCOMPARE(baked.fragmentCount(), 6u);
            const auto number = [&](const std::string& id) {
                std::uint32_t k = 0;
                while (baked.fragmentId(k) != id) ++k;
                return k;
            };
            const std::uint32_t low = number("3/5.0/6.0"), high = number("3/5.0/6.1"), lowRight = number("3/5.1/7.0"),
                                highRight = number("3/5.1/7.1");
            using Pair = std::pair<std::uint32_t, std::uint32_t>;
            QCOMPARE(neighboursAcrossParents(baked, 1),
                     (std::vector<Pair>{{low, lowRight}, {high, lowRight}, {high, highRight}}));
            QVERIFY(neighboursAcrossParents(baked, 0).empty());
            FragmentSet set(6, false);
            set[highRight] = true;
            FragmentSet expected = set;
            expected[lowRight] = expected[high] = true;
            QCOMPARE(withNeighbours(baked, set), expected);
        }
    }
    void parentsChildrenAndSiblingsAreFound() {
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
    void levelsAndVolumesMatchTheFragments() {
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
    void randomFractionHasTheRequestedSizeAndHoldsLeaves() {
        forEachBake([](const Bake& bake, const FragmentSet&) {
            const FragmentSet smallest = leafFragments(bake);
            const auto all = std::ranges::count(smallest, true);
            FragmentSet before(bake.fragmentCount(), false);
            for (const double fraction : {0.0, 0.3, 0.5, 1.0}) {
                const FragmentSet some = randomFragments(bake, fraction, 5);
                QCOMPARE(std::ranges::count(some, true), std::llround(fraction * static_cast<double>(all)));
                for (std::size_t k = 0; k < some.size(); ++k) QVERIFY(smallest[k] || !some[k]);
                for (std::size_t k = 0; k < some.size(); ++k) QVERIFY(some[k] || !before[k]);
                before = some;
            }
            QCOMPARE(before, smallest);
            QCOMPARE(randomFragments(bake, 0.5, 8), randomFragments(bake, 0.5, 8));
        });
    }
    void anotherRandomSeedGivesAnotherSet() {
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

RUBBLE_TEST_WITH(FragmentSetsTest, QCoreApplication)
#include "FragmentSetsTest.moc"
