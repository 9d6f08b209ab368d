#include "core/structure/rule/SimpleRule.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/structure/BondGraphs.h"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>

using namespace rubble;

namespace {

using Bonds = std::vector<std::uint32_t>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A row of cubes of 1 m along x without anchors: bond k is at x = k + 0.5.
BondGraph row(std::uint32_t nodes) {
    std::vector<Vec3> centres;
    for (std::uint32_t k = 0; k < nodes; ++k) centres.emplace_back(k, 0.0, 0.0);
    std::vector<Bond> bonds;
    for (std::uint32_t k = 0; k + 1 < nodes; ++k) bonds.push_back(test::bondBetween(centres, k, k + 1));
    return bondGraph(centres, bonds);
}

/// One body, its bonds and their damage.
struct Struck {
    BondGraph graph;
    std::vector<double> capacities;
    std::vector<BondDamage> damage;
    std::vector<std::uint32_t> owners;

    explicit Struck(BondGraph made, double capacity = 1.0)
        : graph(std::move(made)),
          capacities(graph.bondCount(), capacity),
          damage(graph.bondCount(), kIntact),
          owners(graph.nodeCount(), 0) {}

    HitOutcome hit(Vec3 point, double impulse, const SimpleRule& rule) {
        return applyHit(graph, capacities, rule, {std::span(&point, 1), impulse}, owners, 0, damage);
    }
};

constexpr SimpleRule kRule{.radius = 2.0, .falloff = HitFalloff::Linear, .damageFrom = 0.5};

struct RandomHit {
    Struck struck;
    SimpleRule rule;
    std::vector<Vec3> points;
    double impulse = 0.0;

    explicit RandomHit(Random& random) : struck(test::randomBondGraph(random)) {
        rule = {random.between(0.1, 8.0), static_cast<HitFalloff>(random.below(3)), random.between(0.05, 1.0)};
        for (double& capacity : struck.capacities)
            capacity = random.below(10) == 0 ? kInfinite : random.below(20) == 0 ? 0.0 : random.between(0.1, 20.0);
        struck.damage = test::randomDamage(random, struck.damage.size());
        for (std::uint32_t& owner : struck.owners) owner = static_cast<std::uint32_t>(random.below(3) / 2);
        for (std::uint64_t k = random.below(4); k < 4; ++k)
            points.emplace_back(random.between(0.0, 10.0), random.between(0.0, 10.0), random.between(0.0, 10.0));
        impulse = random.between(0.0, 60.0);
    }
    HitOutcome apply() {
        return applyHit(struck.graph, struck.capacities, rule, {points, impulse}, struck.owners, 0, struck.damage);
    }
};

/// What is wrong with the effect of a hit; empty: nothing.
std::string faultOf(const RandomHit& before, const RandomHit& after, const HitOutcome& outcome) {
    if (!(outcome.taken >= 0.0 && outcome.taken <= before.impulse)) return "more is taken than the impulse";
    double taken = 0.0;
    for (std::uint32_t k = 0; k < before.struck.graph.bondCount(); ++k) {
        const BondDamage was = before.struck.damage[k], is = after.struck.damage[k];
        if (is < was) return "damage heals";
        const bool isBroken = std::ranges::binary_search(outcome.broken, k);
        if (isBroken != (is == kBroken && was != kBroken)) return "a broken bond is not reported";
        const bool isDamaged = std::ranges::binary_search(outcome.damaged, k);
        if (isDamaged != (is != kBroken && was != is)) return "a damaged bond is not reported";
        if (was == is) continue;
        const Bond& bond = before.struck.graph.bonds[k];
        if (before.struck.owners[bond.first] != 0) return "another body is damaged";
        if (bond.second != kNone && before.struck.owners[bond.second] != 0) return "a bond between bodies is damaged";
        if (before.struck.capacities[k] == kInfinite) return "a bond that never breaks is damaged";
        taken += before.struck.capacities[k] * (is - was) / kBroken;
    }
    return std::abs(taken - outcome.taken) <= 1e-12 * before.impulse ? "" : "what is taken is not what bonds lost";
}

}  // namespace

class SimpleRuleTest : public QObject {
    Q_OBJECT
private slots:
    void loadFallsOffWithDistance() {
        const auto fraction = [](HitFalloff falloff, double distance) {
            return loadFraction({.radius = 2.0, .falloff = falloff}, distance);
        };
        for (const HitFalloff falloff : {HitFalloff::Constant, HitFalloff::Linear, HitFalloff::Smooth}) {
            QCOMPARE(fraction(falloff, 0.0), 1.0);
            QCOMPARE(fraction(falloff, 2.1), 0.0);
        }
        QCOMPARE(fraction(HitFalloff::Constant, 2.0), 1.0);
        QCOMPARE(fraction(HitFalloff::Linear, 0.5), 0.75);
        QCOMPARE(fraction(HitFalloff::Smooth, 0.5), 0.84375);  // 1 - 3/16 + 2/64
        QCOMPARE(fraction(HitFalloff::Smooth, 1.0), 0.5);
        QCOMPARE(fraction(HitFalloff::Linear, 2.0), 0.0);
    }
    // Bonds at 0.5, 1.5 and 2.5 m; from the first: fractions of 1, 0.5 and 0.
    void theNearestBreakFirst() {
        Struck struck(row(4));
        const HitOutcome outcome = struck.hit({0.5, 0.0, 0.0}, 1.9, kRule);
        QCOMPARE(outcome.broken, Bonds{0});  // takes 1 N·s
        // What is left, 0.9 N·s, loads the second by 0.45, too little.
        QCOMPARE(outcome.damaged, Bonds{});
        QCOMPARE(outcome.taken, 1.0);
        QCOMPARE(struck.damage, (std::vector<BondDamage>{kBroken, 0, 0}));
    }
    void whatIsLeftLoadsTheNext() {
        Struck struck(row(4));
        const HitOutcome outcome = struck.hit({0.5, 0.0, 0.0}, 2.5, kRule);
        QCOMPARE(outcome.broken, Bonds{0});
        QCOMPARE(outcome.damaged, Bonds{1});  // 1.5 N·s by 0.5 is 0.75, halfway from 0.5 to 1: 127.5 of 255
        QCOMPARE(struck.damage[1], BondDamage{127});
        QVERIFY(std::abs(outcome.taken - (1.0 + 127.0 / 255.0)) <= 1e-15);
    }
    void damageAccumulates() {
        Struck struck(row(2));
        QCOMPARE(struck.hit({0.5, 0.0, 0.0}, 0.75, kRule).damaged, Bonds{0});  // by one half
        QCOMPARE(struck.damage[0], BondDamage{127});
        QCOMPARE(struck.hit({0.5, 0.0, 0.0}, 0.75, kRule).damaged, Bonds{0});
        QCOMPARE(struck.damage[0], BondDamage{254});
        const HitOutcome last = struck.hit({0.5, 0.0, 0.0}, 0.75, kRule);
        QCOMPARE(last.broken, Bonds{0});
        QVERIFY(std::abs(last.taken - 1.0 / 255.0) <= 1e-15);  // what was left of it
        QVERIFY(struck.hit({0.5, 0.0, 0.0}, 100.0, kRule).broken.empty());
    }
    // A fragment of 10 m whose neighbours are beyond the radius.
    void theMiddleOfALargeFragmentCanBeHit() {
        const std::vector<Vec3> centres{{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {0.0, 12.0, 0.0}};
        Struck struck(bondGraph(centres, {test::bondBetween(centres, 0, 1), test::bondBetween(centres, 0, 2)}));
        const HitOutcome outcome = struck.hit({0.0, 0.0, 0.0}, 10.0, kRule);
        QCOMPARE(outcome.broken, (Bonds{0, 1}));
        QCOMPARE(outcome.taken, 2.0);
    }
    void bondsThatNeverBreakTakeNothing() {
        Struck struck(row(8));
        struck.capacities[0] = kInfinite;
        const HitOutcome outcome = struck.hit({0.5, 0.0, 0.0}, 1e9, kRule);
        QCOMPARE(outcome.broken, Bonds{1});  // 1 m away, within the radius of 2 m; the next is at it
        QCOMPARE(struck.damage[0], kIntact);
        QCOMPARE(outcome.taken, 1.0);
    }
    void onlyBondsOfTheBodyAreLoaded() {
        Struck struck(row(4));
        struck.owners = {7, 0, 0, 0};
        const HitOutcome outcome = struck.hit({0.5, 0.0, 0.0}, 10.0, kRule);
        QCOMPARE(outcome.broken, Bonds{1});  // the bond of the node at 1 m; the next is 2 m away
        QVERIFY(Struck(row(1)).hit({0.0, 0.0, 0.0}, 10.0, kRule).broken.empty());
    }
    void anchorsBreakAsOtherBonds() {
        Struck struck(test::wallOfCubes(1, 2));
        QCOMPARE(struck.hit({0.0, -0.5, 0.0}, 1.5, kRule).broken, Bonds{test::bondAt(struck.graph, 0, kNone)});
    }
    void theNearestOfSeveralPointsCounts() {
        Struck struck(row(10));
        const std::vector<Vec3> points{{0.5, 0.0, 0.0}, {7.5, 0.0, 0.0}};
        const HitOutcome outcome =
            applyHit(struck.graph, struck.capacities, {.radius = 0.9}, {points, 5.0}, struck.owners, 0, struck.damage);
        QCOMPARE(outcome.broken, (Bonds{0, 6, 7}));  // all bonds of the nodes at 0 and 7 m
    }
    /// Two clusters of three: a hit anywhere in one parts them at the bond between, and leaves the bonds within whole.
    void aHitAnywhereInAClusterBreaksItOff() {
        const std::array<ClusterLevel, 5> levels{1, 1, 0, 1, 1};
        for (const double at : {0.0, 1.0, 2.0}) {
            Struck struck(row(6));
            const Vec3 point{at, 0.0, 0.0};
            const BondHit hit{{&point, 1}, 1.0, {levels, 0}};
            const HitOutcome outcome =
                applyHit(struck.graph, struck.capacities, {.radius = 0.1}, hit, struck.owners, 0, struck.damage);
            QCOMPARE(outcome.broken, Bonds{2});
            QCOMPARE(outcome.taken, 1.0);
        }
    }
    void theNextLevelBreaksAfterwards() {
        const std::array<ClusterLevel, 5> levels{1, 1, 0, 1, 1};
        Struck struck(row(6));
        struck.damage[2] = kBroken;
        struck.owners = {0, 0, 0, 1, 1, 1};
        const Vec3 point{1.0, 0.0, 0.0};
        const BondHit hit{{&point, 1}, 9.0, {levels, 1}};
        const HitOutcome outcome =
            applyHit(struck.graph, struck.capacities, {.radius = 0.1}, hit, struck.owners, 0, struck.damage);
        QCOMPARE(outcome.broken, (Bonds{0, 1}));
        QCOMPARE(outcome.taken, 2.0);
    }
    void heldBondsAreNeverDamaged() {
        int changed = 0;
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            RandomHit hit(random);
            std::vector<ClusterLevel> levels(hit.struck.damage.size());
            for (ClusterLevel& level : levels) level = static_cast<ClusterLevel>(random.below(4));
            const RandomHit before = hit;
            const HeldClusters held{levels, static_cast<ClusterLevel>(random.below(3))};
            const HitOutcome outcome =
                applyHit(hit.struck.graph, hit.struck.capacities, hit.rule, {hit.points, hit.impulse, held},
                         hit.struck.owners, 0, hit.struck.damage);
            std::string fault = faultOf(before, hit, outcome);
            for (std::uint32_t bond = 0; bond < levels.size(); ++bond) {
                if (held.holds(bond) && hit.struck.damage[bond] != before.struck.damage[bond]) fault = "a bond is held";
            }
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
            changed += outcome.broken.empty() ? 0 : 1;
        }
        QVERIFY(changed > 500);
    }
    /// Levels that hold nothing are the same bits as none.
    void levelsThatHoldNothingChangeNothing() {
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            Random random(seed);
            RandomHit hit(random), other = hit;
            const std::vector<ClusterLevel> levels(hit.struck.damage.size(), 1);
            const HitOutcome outcome = hit.apply();
            const HitOutcome same =
                applyHit(other.struck.graph, other.struck.capacities, other.rule,
                         {other.points, other.impulse, {levels, 1}}, other.struck.owners, 0, other.struck.damage);
            QVERIFY2(outcome.taken == same.taken && outcome.utilization == same.utilization &&
                         hit.struck.damage == other.struck.damage,
                     qPrintable(faultOfSeed(seed, "levels change a hit")));
        }
    }
    void aHitNeverTakesMoreThanItsImpulse() {
        int changed = 0;
        for (std::uint64_t seed = 0; seed < 5000; ++seed) {
            Random random(seed);
            RandomHit hit(random);
            const RandomHit before = hit;
            const HitOutcome outcome = hit.apply();
            const std::string fault = faultOf(before, hit, outcome);
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
            if (!outcome.broken.empty()) ++changed;
        }
        QVERIFY(changed > 1000);
    }
    void utilizationSaysWhetherABondBreaks() {
        std::array<int, 2> count{};
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            RandomHit hit(random);
            const HitOutcome outcome = hit.apply();
            QVERIFY2((outcome.utilization >= 1.0) == !outcome.broken.empty(), qPrintable(faultOfSeed(seed, "it lies")));
            ++count[outcome.broken.empty() ? 0 : 1];
        }
        QVERIFY(count[0] > 300 && count[1] > 1000);
    }
    void impulseByUtilizationIsTheLeastThatBreaksIntactBonds() {
        int tried = 0;
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            RandomHit hit(random);
            std::ranges::fill(hit.struck.damage, kIntact);
            RandomHit less = hit, more = hit;
            const double utilization = hit.apply().utilization;
            if (utilization == 0.0 || utilization == kInfinite) continue;
            less.impulse *= (1.0 - 1e-6) / utilization;
            more.impulse *= (1.0 + 1e-6) / utilization;
            QVERIFY2(less.apply().broken.empty(), qPrintable(faultOfSeed(seed, "less breaks a bond")));
            QVERIFY2(!more.apply().broken.empty(), qPrintable(faultOfSeed(seed, "more breaks no bond")));
            ++tried;
        }
        QVERIFY2(tried > 1000, QByteArray::number(tried));
    }
    void aHitBelowTheLeastImpulseChangesNothing() {
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            RandomHit hit(random);
            const double least = leastImpulse(hit.struck.capacities, hit.rule);
            hit.impulse = least == kInfinite ? 1e6 : std::nextafter(least, 0.0);
            if (!(hit.impulse < least)) continue;
            const RandomHit before = hit;
            const HitOutcome outcome = hit.apply();
            QVERIFY2(outcome.taken == 0.0 && hit.struck.damage == before.struck.damage,
                     qPrintable(faultOfSeed(seed, "a bond is damaged")));
        }
        QCOMPARE(leastImpulse({}, kRule), kInfinite);
        QCOMPARE(leastImpulse(std::vector{3.0, 2.0, kInfinite}, kRule), 1.0);
    }
    void theOrderOfBondsDoesNotMatter() {
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            Random random(seed);
            RandomHit hit(random);
            RandomHit turned = hit;  // the same bonds from the last to the first
            std::vector<Bond> bonds(hit.struck.graph.bonds.rbegin(), hit.struck.graph.bonds.rend());
            turned.struck.graph = bondGraph(hit.struck.graph.centres, bonds);
            std::ranges::reverse(turned.struck.capacities);
            std::ranges::reverse(turned.struck.damage);
            const HitOutcome outcome = hit.apply(), ofTurned = turned.apply();
            std::ranges::reverse(turned.struck.damage);
            QVERIFY2(outcome.taken == ofTurned.taken && hit.struck.damage == turned.struck.damage,
                     qPrintable(faultOfSeed(seed, "the order of bonds matters")));
        }
    }
    void theRuleIsThatOfTheAsset() {
        const Bonding bonding{.radius = 0.7, .falloff = HitFalloff::Smooth, .damageFrom = 0.25};
        QCOMPARE(simpleRuleOf(bonding).radius, 0.7);
        QVERIFY(simpleRuleOf(bonding) == (SimpleRule{0.7, HitFalloff::Smooth, 0.25}));
    }
};

RUBBLE_TEST(SimpleRuleTest)
#include "SimpleRuleTest.moc"
