#include "core/structure/clusters/ClusterEditing.h"

#include "core/asset/checks/BondFaults.h"
#include "core/structure/clusters/ClusterLevels.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ClusteredRow.h"

#include <QTest>

using namespace rubble;

namespace {

using ClusterList = std::vector<FragmentCluster>;
using Numbers = std::vector<std::uint32_t>;

constexpr auto kNumber = ClusterTarget::Measure::Number;
constexpr auto kSize = ClusterTarget::Measure::Size;

/// An asset, its bake and the editing of a level.
struct Edited {
    Asset asset;
    Bake baked = *bake(asset);
    ClusterEditing editing;

    explicit Edited(Asset made, std::uint32_t level = 0) : asset(std::move(made)), editing(asset, baked, 0, level) {}
};

FragmentCluster cluster(std::uint32_t level, std::initializer_list<int> fragments) {
    FragmentCluster made{.level = level};
    for (const int fragment : fragments) made.fragments.push_back("3." + std::to_string(fragment));
    return made;
}

}  // namespace

class ClusterEditingTest : public QObject {
    Q_OBJECT
private slots:
    void proposedByNumberOrSize() {
        const ClusterList halves{cluster(0, {0, 1, 2, 3}), cluster(0, {4, 5, 6, 7})};
        QCOMPARE(Edited(test::rowOfEight()).editing.propose({kNumber, 2}), halves);
        QCOMPARE(Edited(test::rowOfEight()).editing.propose({kSize, 4}), halves);
        QVERIFY(Edited(test::rowOfEight()).editing.propose({kNumber, 8}).empty());  // of one fragment each
    }
    void proposalsReplaceTheirLevelOnly() {
        const Edited edited(test::clusteredRow({cluster(0, {0, 1}), cluster(2, {0, 1}), {0, {"3.1/9.0", "3.1/9.1"}}}));
        QCOMPARE(edited.editing.propose({kNumber, 1}),
                 (ClusterList{cluster(0, {0, 1, 2, 3, 4, 5, 6, 7}), {0, {"3.1/9.0", "3.1/9.1"}}, cluster(2, {0, 1})}));
    }
    void deeperProposalsStayWithinCoarserClusters() {
        const ClusterList coarse{cluster(0, {0, 1, 2, 3, 4}), cluster(0, {5, 6, 7})};
        const Edited edited(test::clusteredRow(coarse), 2);  // level 1 has none
        const ClusterList made = edited.editing.propose({kNumber, 3});
        QCOMPARE(made.size(), std::size_t{5});
        QVERIFY(std::ranges::count(made, cluster(2, {5, 6, 7})) == 1);
        const Edited part(test::clusteredRow({cluster(0, {0, 1})}), 1);
        QCOMPARE(part.editing.propose({kNumber, 1}), (ClusterList{cluster(0, {0, 1}), cluster(1, {0, 1})}));
    }
    void madeOfFragments() {
        const Edited edited(test::clusteredRow({cluster(0, {0, 1}), cluster(0, {2, 3, 4}), cluster(1, {2, 3})}));
        QCOMPARE(edited.editing.make(Numbers{1, 2, 6}),
                 (ClusterList{cluster(0, {1, 2, 6}), cluster(0, {3, 4}), cluster(1, {2, 3})}));
        QCOMPARE(edited.editing.make(Numbers{5}), edited.asset.bonding.clusters);
    }
    void grownByFreeNeighbours() {
        const Edited edited(test::clusteredRow({cluster(0, {1, 2}), cluster(0, {4, 5})}));
        QCOMPARE(edited.editing.clustersOf(Numbers{0, 1, 2, 5}), (Numbers{0, 1}));
        QCOMPARE(edited.editing.grow(Numbers{0}), (ClusterList{cluster(0, {0, 1, 2, 3}), cluster(0, {4, 5})}));
        QCOMPARE(edited.editing.grow(Numbers{0, 1}), (ClusterList{cluster(0, {0, 1, 2, 3}), cluster(0, {4, 5, 6})}));
        const Edited deep(test::clusteredRow({cluster(0, {0, 1, 2}), cluster(0, {3, 4}), cluster(1, {1, 2})}), 1);
        QCOMPARE(deep.editing.grow(Numbers{2}),
                 (ClusterList{cluster(0, {0, 1, 2}), cluster(0, {3, 4}), cluster(1, {0, 1, 2})}));
    }
    void mergedSplitAndReduced() {
        const Edited edited(test::clusteredRow({cluster(0, {0, 1}), cluster(0, {2, 3, 99}), cluster(0, {4, 5, 6, 7})}));
        QCOMPARE(edited.editing.merge(Numbers{0, 1}),
                 (ClusterList{cluster(0, {0, 1, 2, 3, 99}), cluster(0, {4, 5, 6, 7})}));
        QCOMPARE(edited.editing.split(Numbers{2}),
                 (ClusterList{cluster(0, {0, 1}), cluster(0, {2, 3, 99}), cluster(0, {4, 5}), cluster(0, {6, 7})}));
        QCOMPARE(edited.editing.split(Numbers{0}), (ClusterList{cluster(0, {2, 3, 99}), cluster(0, {4, 5, 6, 7})}));
        QCOMPARE(edited.editing.remove(Numbers{1, 4}), (ClusterList{cluster(0, {2, 3, 99}), cluster(0, {5, 6, 7})}));
        QCOMPARE(edited.editing.nodesOf(1), (Numbers{2, 3}));
    }
    void randomEditsKeepTheAssetValid() {
        std::size_t most = 0;
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            Random random(seed);
            Asset asset = boxAsset(2, 3, UniformScatter{.count = 5 + static_cast<std::uint32_t>(random.below(40))});
            const Bake baked = *bake(asset);
            for (int step = 0; step < 12; ++step) {
                const ClusterEditing editing(asset, baked, 0, static_cast<std::uint32_t>(random.below(3)));
                Numbers nodes;
                for (std::uint32_t node = 0; node < editing.graph().nodeCount(); ++node) {
                    if (random.below(6) == 0) nodes.push_back(node);
                }
                const Numbers clusters = editing.clustersOf(nodes);
                switch (random.below(6)) {
                    case 0:
                        asset.bonding.clusters = editing.propose(
                            {random.below(2) == 0 ? kNumber : kSize, static_cast<std::uint32_t>(1 + random.below(12))});
                        break;
                    case 1: asset.bonding.clusters = editing.make(nodes); break;
                    case 2: asset.bonding.clusters = editing.grow(clusters); break;
                    case 3: asset.bonding.clusters = editing.merge(clusters); break;
                    case 4: asset.bonding.clusters = editing.split(clusters); break;
                    default: asset.bonding.clusters = editing.remove(nodes); break;
                }
                const std::optional<std::string> fault = bondFault(asset);
                QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
                for (const FragmentCluster& one : asset.bonding.clusters)
                    QVERIFY2(one.fragments.size() > 1, qPrintable(faultOfSeed(seed, "a cluster has one fragment")));
                most = std::max(most, asset.bonding.clusters.size());
            }
        }
        QVERIFY(most > 8);
    }
};

RUBBLE_TEST(ClusterEditingTest)
#include "ClusterEditingTest.moc"
