// Tests core/io/pack/PackFile.cpp and core/io/pack/PackBodyJson.cpp.
#include "core/io/pack/PackFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/LayeredBox.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/files/Schemas.h"

#include <QTest>

#include <nlohmann/json.hpp>

using namespace rubble;

class PackFileTest : public QObject {
    Q_OBJECT
private slots:
    void writtenPacksMatchTheSchema() {
        const test::Schema schema("pack.schema.json");
        for (const Asset& asset : {boxAsset(3, 4, UniformScatter{.count = 9}), twoLevelRing(), bondedRing(),
                                   boxAsset(3, 4, PlacedSeeds{})}) {
            const std::string json = packOf(asset);
            QCOMPARE(schema.fault(nlohmann::json::parse(json)), std::string());
        }
    }
    void threadsDoNotChangeTheBytes() {
        const Asset asset = boxAsset(3, 4, UniformScatter{.count = 300});
        QCOMPARE(packOf(asset, 4), packOf(asset, 1));
    }
    void boxMatchesAComputationByHand() {
        const nlohmann::json whole = nlohmann::json::parse(packOf(boxAsset(3, 4, PlacedSeeds{})))["whole"];
        QVERIFY(whole["id"] == "3");
        QVERIFY(whole["name"] == "box_whole");
        QVERIFY(whole["parent"].is_null());
        QVERIFY(whole["offset"] == nlohmann::json({0.5, 0.5, 0.0}));
        QVERIFY(whole["volume"] == 0.5);
        QVERIFY(whole["mass"] == 0.5 * 1800.0);
        QVERIFY(whole["inertia"][2][2] == 0.5 * 1800.0 * (1.0 + 1.0) / 12.0);
        QCOMPARE(whole["hulls"].size(), std::size_t{1});
        QVERIFY(whole["hulls"][0]["planes"][0] == nlohmann::json({0.0, 0.0, 1.0, 0.25 - 1e-4}));
        QVERIFY(whole["hulls"][0]["signedEdges"][1] == nlohmann::json::parse("[[6,-1],[5,-1],[4,-1],[7,-1]]"));
    }
    void thresholdsAreThoseOfWhatBreaks() {
        Asset asset = layeredBox();
        const ContentHash hash = hashesOf(asset).all;
        asset.levels[0].threshold = 12.5;
        const ContentHash ofLevel = hashesOf(asset).all;
        QVERIFY(ofLevel != hash);
        asset.fragmentThresholds = {{"5.1", 3.25}};
        QVERIFY(hashesOf(asset).all != ofLevel);
        const std::string json = packOf(asset);
        QCOMPARE(test::Schema("pack.schema.json").fault(nlohmann::json::parse(json)), std::string());
        const Pack pack = *readPack(json);
        QCOMPARE(pack.whole.threshold, std::optional(asset.threshold));
        QCOMPARE(pack.fragments[0].threshold, std::optional(12.5));
        QCOMPARE(pack.fragments[1].threshold, std::optional(3.25));
        for (std::size_t k = 2; k < pack.fragments.size(); ++k)
            QCOMPARE(pack.fragments[k].threshold.has_value(), pack.fragments[k].childCount > 0);
        QCOMPARE(verifyPack(pack).value_or(""), std::string());
    }
    void hashDependsOnAllInputs() {
        const Asset asset = twoLevelRing();
        const ContentHash hash = hashesOf(asset).all;
        QCOMPARE(hashesOf(twoLevelRing()).all, hash);
        Asset stronger = asset;
        stronger.threshold += 1.0;
        QVERIFY(hashesOf(stronger).all != hash);
        Material strong = heavyBrick();
        strong.tensileStrength = 1e6;
        QVERIFY(hashesOf(asset, strong).all != hash);
        QCOMPARE(hashesOf(asset, strong).physics, hashesOf(asset).physics);  // the threshold does not depend on it
        Asset derived = asset;
        derived.contactTime = 1e-3;
        QCOMPARE(hashesOf(derived).all, hash);
        QVERIFY(hashesOf(derived, strong).all != hash);
        Asset deeper = asset;
        const auto hashOf = [](const Asset& one, const Material& material) { return hashesOf(one, material).all; };
        Asset unused = asset;  // it breaks whole
        unused.bonding = everyBonding("4");
        unused.levels[0].bondStrength = 0.5;
        QCOMPARE(hashOf(unused, heavyBrick()), hash);
        const Asset bonded = bondedRing();
        const ContentHash ofBonds = hashOf(bonded, heavyBrick());
        QVERIFY(ofBonds != hash);
        QCOMPARE(hashesOf(bonded, strong).physics, hashesOf(bonded).physics);  // it has an impulse per area
        const auto changesBonds = [&](const auto& change) {
            Asset other = bonded;
            change(other);
            return hashOf(other, heavyBrick()) != ofBonds;
        };
        QVERIFY(changesBonds([](Asset& a) { a.bonding.impulsePerArea = 1.0; }));
        QVERIFY(changesBonds([](Asset& a) { a.bonding.span = 9.0; }));
        QVERIFY(changesBonds([](Asset& a) { a.levels[0].bondStrength = 2.0; }));
        QVERIFY(changesBonds([](Asset& a) { a.cutAtImpact.emplace(); }));
        Asset derivedBonds = bonded;
        derivedBonds.bonding.impulsePerArea.reset();
        QVERIFY(hashOf(derivedBonds, strong) != hashOf(derivedBonds, heavyBrick()));
        deeper.prism().depth += 1.0;
        QVERIFY(hashesOf(deeper).all != hash);
        Material heavier = heavyBrick();
        heavier.density += 1.0;
        QVERIFY(hashesOf(asset, heavier).all != hash);
        QVERIFY(hashesOf(asset, heavyBrick(), {}).all != hash);
    }
};

RUBBLE_TEST(PackFileTest)
#include "PackFileTest.moc"
