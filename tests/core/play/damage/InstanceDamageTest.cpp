#include "core/play/damage/InstanceDamage.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/Damages.h"

using namespace rubble;

namespace {

constexpr std::uint64_t kMergeSeed = 11;

InstanceDamage fractures(std::vector<bool> broken, std::optional<ImpactCut> cut = std::nullopt) {
    return {.bake = {1, 2}, .cut = cut, .broken = std::move(broken)};
}

/// A damage of few different ones: with the same cuts, and all but one with the same number of fractures.
InstanceDamage anyDamage(Random& random) {
    InstanceDamage damage = fractures(std::vector<bool>(20));
    if (const std::uint64_t cut = random.below(3); cut > 0) {
        damage.cut = ImpactCut{.point = {0.1, cut == 1 ? 0.0 : -0.0}, .number = 1};
        damage.broken.resize(7 + cut);
    }
    for (std::size_t k = 0; k < damage.broken.size(); ++k) damage.broken[k] = random.below(3) == 0;
    return damage;
}

}  // namespace

class InstanceDamageTest : public QObject {
    Q_OBJECT
private slots:
    void aFractureIsBrokenIfItIsInOneOfThem() {
        QCOMPARE(mergedDamage(fractures({true, false, false}), fractures({false, false, true}))->broken,
                 (std::vector<bool>{true, false, true}));
        QCOMPARE(damageSince(fractures({true, false, true}), fractures({true, false, false}))->broken,
                 (std::vector<bool>{false, false, true}));
        QVERIFY(fractures({false, false}).isIntact());
        QVERIFY(!fractures({false, true}).isIntact());
    }
    void ofTwoCutsTheOneWithTheLargerNumberPrevails() {
        const InstanceDamage none = fractures({true, true, true});
        const InstanceDamage small = fractures({true}, ImpactCut{{0.9, 0.9}, 1});
        const InstanceDamage large = fractures({true, false}, ImpactCut{{0.1, 0.1}, 2});
        QVERIFY(*mergedDamage(none, small) == small);
        QVERIFY(*mergedDamage(large, small) == large);
        QVERIFY(*damageSince(large, small) == large);
    }
    void mergeIsCommutativeAssociativeAndIdempotent() {
        qInfo("seed %d", static_cast<int>(kMergeSeed));
        Random random(kMergeSeed);
        for (int round = 0; round < 2000; ++round) {
            const InstanceDamage a = anyDamage(random), b = anyDamage(random), c = anyDamage(random);
            const InstanceDamage ab = *mergedDamage(a, b);
            QVERIFY(ab == *mergedDamage(b, a));
            QVERIFY(*mergedDamage(ab, c) == *mergedDamage(a, *mergedDamage(b, c)));
            QVERIFY(*mergedDamage(ab, b) == ab);
            QVERIFY(*mergedDamage(a, *damageSince(ab, a)) == ab);
        }
    }
    void damageOfAnotherBakeIsRefusedWithBothHashes() {
        InstanceDamage other = fractures({true});
        other.bake = {3, 4};
        const Result<InstanceDamage> merged = mergedDamage(fractures({true}), other);
        QVERIFY(!merged);
        QCOMPARE(merged.error().message,
                 std::string("The damage is of the bake 00000000000000010000000000000002, but the instance is of the "
                             "bake 00000000000000030000000000000004; only damage of the same bake can be applied."));
        QVERIFY(!damageSince(fractures({true}), other));
    }
    void damageOfAnotherSizeIsRefused() {
        QCOMPARE(mergedDamage(fractures({true}), fractures({true, true})).error().message,
                 std::string("The damages are of 1 and 2 fractures; only damage of the same fractures can be merged."));
    }
    void theHashIsThatOfTheBakeAndOfTheCut() {
        const Project project = test::threeBlocks();
        const auto scene = test::playSceneOf(project);
        const Bake& bake = *test::onlyAsset(*scene).bake;
        QVERIFY(damageHash(project.assets[0], bake) == bake.input);
        Asset cut = project.assets[1];
        const ContentHash hash = damageHash(cut, bake);
        QVERIFY(hash != bake.input);
        cut.cutAtImpact->fragments++;
        QVERIFY(damageHash(cut, bake) != hash);
    }
    void aFragmentThatBreaksBeforeItsParentIsAFault() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        const PlayAsset& asset = test::onlyAsset(*scene);
        InstanceDamage damage = intactDamage(scene->project.assets[0], asset);
        QCOMPARE(damage.broken.size(), std::size_t{6});
        QVERIFY(!damageFault(damage, damage.bake, asset));
        damage.broken[1] = true;
        QCOMPARE(damageFault(damage, damage.bake, asset).value_or(""),
                 std::string("Fragment 3.0 is broken, but what it is a fragment of is not."));
        damage.broken[0] = true;
        QVERIFY(!damageFault(damage, damage.bake, asset));
        damage.broken.push_back(false);
        QCOMPARE(damageFault(damage, damage.bake, asset).value_or(""),
                 std::string("The damage is of 7 fractures, but the asset has 6."));
    }
};

RUBBLE_TEST(InstanceDamageTest)
#include "InstanceDamageTest.moc"
