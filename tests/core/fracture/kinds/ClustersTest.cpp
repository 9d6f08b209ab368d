#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/sampling/PairIndex.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>
#include <map>

using namespace rubble;

namespace {

Seeds clusteredSeeds(const Clusters& clusters, const Polygon& outline) {
    return layerSeeds(clusters, outline, 8).value();
}

std::map<std::uint32_t, Vec2> clusteredInRing(const Clusters& clusters) {
    return positionsByIndex(clusteredSeeds(clusters, squareRing()));
}

}  // namespace

class ClustersTest : public QObject {
    Q_OBJECT
private slots:
    void seedsStayWithinTheirCluster() {
        const auto seeds = clusteredInRing({.clusters = 5, .seedsPerCluster = 30, .radius = 0.1});
        QCOMPARE(seeds.size(), std::size_t{150});
        for (std::uint32_t cluster = 0; cluster < 5; ++cluster) {
            for (std::uint32_t k = 1; k < 30; ++k) {
                const Vec2 off = seeds.at(pairIndex(cluster, k)) - seeds.at(pairIndex(cluster, 0));
                QVERIFY(off.x * off.x + off.y * off.y <= 0.2 * 0.2);
            }
        }
    }
    void addedClustersAndSeedsKeepTheOthers() {
        const auto few = clusteredInRing({.clusters = 3, .seedsPerCluster = 4});
        const auto many = clusteredInRing({.clusters = 7, .seedsPerCluster = 9});
        QCOMPARE(many.size(), std::size_t{63});
        for (const auto& [index, seed] : few) QCOMPARE(many.at(index), seed);
    }
    void missingRoomIsReported() {
        // A plank a micrometre wide: hardly any random point within half a metre is in it.
        const Seeds seeds = clusteredSeeds({.clusters = 2, .seedsPerCluster = 10, .radius = 0.5},
                                           {rectangle({0.0, 0.0}, {1.0, 1e-6}), {}});
        QCOMPARE(seeds.diagnostics.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics[0].code, DiagnosticCode::NoRoom);
        QCOMPARE(seeds.diagnostics[0].place.layer, 1u);
        const std::string found = std::to_string(seeds.positions.size());
        QCOMPARE(seeds.diagnostics[0].message,
                 "Layer 1 found room for " + found + " of 20 seeds: the outline is thin where its clusters are.");
    }
    void deletedSeedsAreNotReportedAsMissing() {
        const Polygon plank{rectangle({0.0, 0.0}, {1.0, 1e-6}), {}};
        PatternLayer layer{.id = 1, .parameters = Clusters{.clusters = 2, .seedsPerCluster = 10, .radius = 0.5}};
        const Seeds before = *seedsOf({{layer}}, plank);
        for (std::uint32_t cluster = 0; cluster < 2; ++cluster) {
            for (std::uint32_t seed = 0; seed < 10; ++seed) {
                const SeedId id{1, pairIndex(cluster, seed)};
                if (std::ranges::find(before.ids, id) == before.ids.end()) {
                    layer.overrides.push_back({.index = id.index, .isDeleted = true});
                }
            }
        }
        std::ranges::sort(layer.overrides, {}, &SeedOverride::index);
        const Seeds after = *seedsOf({{layer}}, plank);
        QVERIFY(after.diagnostics.empty());
        QVERIFY(after.positions == before.positions && after.ids == before.ids);
    }
};

RUBBLE_TEST(ClustersTest)
#include "ClustersTest.moc"
