#include "core/io/pack/PackBondingJson.h"

#include "core/io/pack/PackFile.h"
#include "core/play/damage/InstanceDamage.h"
#include "core/play/scene/PlayStructure.h"
#include "core/structure/capacity/BondCapacities.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Packs.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// An asset with its bake, ready for play.
struct ReadyAsset {
    Asset asset;
    std::shared_ptr<const Bake> baked = std::make_shared<const Bake>(*bake(asset));
    std::shared_ptr<const PlayAsset> ready = *playAsset(asset, baked);
};

bool isSame(const PackBond& read, const Bond& bond, double capacity, std::uint32_t first) {
    return read.fragments == std::array{first + bond.first, first + bond.second} && read.area == bond.area &&
           read.centroid == bond.centroid && read.normal == bond.normal &&
           read.capacity.value_or(std::numeric_limits<double>::infinity()) == capacity;
}

}  // namespace

class PackBondingJsonTest : public QObject {
    Q_OBJECT
private slots:
    void bondsAreThoseOfPlay() {
        const ReadyAsset ring{bondedRing()};
        const Pack pack = *readPack(packOf(ring.asset));
        QVERIFY(pack.bonding);
        std::size_t unbreakable = 0, next = 0;
        for (const BakedFracture& baked : ring.baked->fractures) {
            if (ring.ready->fractureOf(baked.parent) == nullptr) continue;
            const auto structure = playStructure(ring.asset, heavyBrick(), ring.ready, baked.parent);
            const PackFracture& fracture = pack.bonding->fractures.at(next++);
            QCOMPARE(fracture.fragment, baked.parent);
            QCOMPARE(fracture.bonds.size(), structure->graph.bonds.size());
            for (std::size_t k = 0; k < fracture.bonds.size(); ++k) {
                const double capacity = structure->capacities[k];
                QVERIFY(isSame(fracture.bonds[k], structure->graph.bonds[k], capacity, baked.first));
                if (std::isinf(capacity)) ++unbreakable;
            }
            // Bodies' offsets are the structure's nodes.
            for (std::uint32_t node = 0; node < structure->nodeCount(); ++node)
                QVERIFY(pack.fragments[baked.first + node].offset == structure->graph.centres[node]);
        }
        QCOMPARE(next, pack.bonding->fractures.size());
        QVERIFY(next > 1 && unbreakable > 0);
    }
    void theRuleIsTheAssets() {
        const ReadyAsset ring{bondedRing()};
        const PackBonding bonding = readPack(packOf(ring.asset))->bonding.value();
        QCOMPARE(bonding.falloffRadius, 0.7);
        QVERIFY(bonding.falloff == HitFalloff::Smooth);
        QCOMPARE(bonding.damageFrom, 1.0 / 3.0);
        QCOMPARE(bonding.span, 1.25);
        QCOMPARE(bonding.collapseDelay, 0.75);
        QCOMPARE(bonding.minimumIsland, 3u);
        QCOMPARE(bonding.bake, damageHash(ring.asset, *ring.baked).hex());
        QCOMPARE(bonding.anchored, anchoredFragments(ring.asset, *ring.baked, 0));
        QVERIFY(!bonding.anchored.empty());
    }
    void packsOfAssetsThatBreakWholeHaveNone() {
        Asset asset = bondedRing();
        asset.breakAs = BreakAs::Whole;
        QCOMPARE(packOf(asset), packOf(twoLevelRing()));
        QVERIFY(packOf(asset).find("bonding") == std::string::npos);
    }
    /// All members but the new one stay, but for hashes, the checksum, and how it breaks.
    void bondsChangeNothingElse() {
        const std::string whole = packOf(twoLevelRing()), bonded = packOf(bondedRing());
        const std::size_t from = whole.find("\"combine\""), size = whole.find("]}\n") - from;
        QCOMPARE(bonded.substr(bonded.find("\"combine\""), size), whole.substr(from, size));
    }
    void anAssetWithOneFragmentHasNoBonds() {
        Asset asset = boxAsset(3, 4, PlacedSeeds{});
        asset.breakAs = BreakAs::Bonded;
        asset.bonding.strokes = {{.points = {{0.5, 0.5}}}};
        const Pack pack = *readPack(packOf(asset));
        QVERIFY(pack.bonding && pack.bonding->fractures.empty() && pack.bonding->anchored.empty());
        QCOMPARE(verifyPack(pack).value_or(""), std::string());
    }
};

RUBBLE_TEST(PackBondingJsonTest)
#include "PackBondingJsonTest.moc"
