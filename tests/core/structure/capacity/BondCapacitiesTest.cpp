// Tests core/structure/capacity/BondCapacities.cpp and core/structure/capacity/StrengthMap.cpp.
#include "core/structure/capacity/BondCapacities.h"

#include "core/structure/capacity/StrengthMap.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace rubble;

namespace {

constexpr double kUnbreakable = std::numeric_limits<double>::infinity();

/// A box of 4 x 1 x 0.5 m with its corner at (10, 20), in four fragments of 1 m side by side: "3.0" to "3.3".
Asset fourFragments() {
    Asset asset = boxAsset(2, 3, PlacedSeeds{});
    asset.prism().outline = {rectangle({10.0, 20.0}, {14.0, 21.0}), {}};
    PlacedSeeds seeds;
    for (std::uint32_t k = 0; k < 4; ++k) seeds.seeds.push_back({k, {10.5 + k, 20.5}});
    asset.pattern.layers[0].parameters = seeds;
    asset.bonding.impulsePerArea = 200.0;
    return asset;
}

/// The same with the second fragment in two halves side by side.
Asset withLevel() {
    Asset asset = fourFragments();
    Level halves{.bondStrength = 0.5};
    halves.pattern.layers = {{.id = 9, .parameters = PlacedSeeds{{{0, {-0.25, 0.0}}, {1, {0.25, 0.0}}}}}};
    asset.fragmentLevels = {{"3.1", halves}};
    return asset;
}

std::vector<double> capacitiesOf(const Asset& asset, std::uint32_t fracture = 0, double factor = 1.0) {
    const Bake baked = *bake(asset);
    const BakedFracture& one = baked.fractures[fracture];
    return bondCapacities(asset, Material{}, baked, fracture,
                          bondsOf(one.fragments, Seeds{.positions = one.seeds.positions}), factor);
}

BondStroke stroke(BondBrush brush, std::vector<Vec2> points, double radius = 0.1) {
    return {.brush = brush, .radius = radius, .points = std::move(points)};
}

bool areNear(const std::vector<double>& values, const std::vector<double>& expected) {
    return std::ranges::equal(values, expected,
                              [](double a, double b) { return a == b || std::abs(a - b) <= 1e-12 * std::abs(b); });
}

}  // namespace

class BondCapacitiesTest : public QObject {
    Q_OBJECT
private slots:
    void capacityIsByArea() {
        // Bonds of 1 m x 0.5 m.
        QVERIFY(areNear(capacitiesOf(fourFragments()), {100.0, 100.0, 100.0}));
        QVERIFY(areNear(capacitiesOf(fourFragments(), 0, 2.5), {250.0, 250.0, 250.0}));
    }
    void levelsHaveTheirStrength() {
        const Asset asset = withLevel();
        const Bake baked = *bake(asset);
        QCOMPARE(baked.fractures.size(), std::size_t{2});
        QCOMPARE(levelStrength(asset, baked, 0), 1.0);
        QCOMPARE(levelStrength(asset, baked, 1), 0.5);
        QVERIFY(areNear(capacitiesOf(asset, 1), {50.0}));
    }
    void eachLevelHasItsOwn() {
        Asset asset = fourFragments();
        for (const double strength : {0.5, 0.25}) {
            Level level{.bondStrength = strength};
            level.pattern.layers = {{.id = 9, .randomSeed = 3, .parameters = UniformScatter{.count = 3}}};
            asset.levels.push_back(level);
        }
        const Bake baked = *bake(asset);
        for (std::uint32_t k = 0; k < baked.fractures.size(); ++k) {
            const std::uint32_t level = baked.fractures[k].level;
            QCOMPARE(levelStrength(asset, baked, k), level == 0 ? 1.0 : level == 1 ? 0.5 : 0.25);
        }
        QCOMPARE(baked.fractures.back().level, 2u);
    }
    void theLastStrokeDecides() {
        Asset asset = fourFragments();
        BondStroke strong = stroke(BondBrush::Strength, {{11.0, 20.5}, {13.0, 20.5}});
        strong.strength = 3.0;
        BondStroke weak = stroke(BondBrush::Strength, {{12.0, 20.55}});
        weak.strength = 0.25;
        BondStroke erased = stroke(BondBrush::Strength, {{13.0, 20.5}});
        erased.isErasing = true;
        BondStroke beside = stroke(BondBrush::Strength, {{11.0, 20.61}});  // 0.11 m from the bond
        beside.strength = 100.0;
        asset.bonding.strokes = {strong, weak, erased, beside};
        QVERIFY(areNear(capacitiesOf(asset), {300.0, 25.0, 100.0}));
        asset.bonding.strokes = {weak, strong};
        QVERIFY(areNear(capacitiesOf(asset), {300.0, 300.0, 300.0}));
    }
    void strokesReachTheFragmentsOfFragments() {
        Asset asset = withLevel();
        BondStroke strong = stroke(BondBrush::Strength, {{11.5, 20.0}, {11.5, 21.0}});  // the middle of "3.1"
        strong.strength = 4.0;
        asset.bonding.strokes = {strong};
        QVERIFY(areNear(capacitiesOf(asset, 1), {200.0}));
    }
    void strengthIsLinearBetweenHeights() {
        Asset asset = fourFragments();
        asset.bonding.heightStrengths = {{0.25, 2.0}, {0.75, 4.0}};
        QCOMPARE(strengthAt(asset, {11.0, 20.0}), 2.0);
        QCOMPARE(strengthAt(asset, {11.0, 20.5}), 3.0);
        QCOMPARE(strengthAt(asset, {13.0, 20.625}), 3.5);
        QCOMPARE(strengthAt(asset, {11.0, 21.0}), 4.0);
        asset.bonding.heightStrengths = {{0.5, 1.0}, {0.5, 3.0}};  // a step
        QCOMPARE(strengthAt(asset, {11.0, 20.4}), 1.0);
        QCOMPARE(strengthAt(asset, {11.0, 20.6}), 3.0);
    }
    // Two pixels side by side, black and white: their centres are at 11 and 13 m.
    void imagesAreBilinear() {
        Asset asset = fourFragments();
        asset.bonding.strengthImage = StrengthImage{.darkest = 0.5, .brightest = 2.5};
        QCOMPARE(strengthAt(asset, {11.0, 20.5}), 1.0);  // no image yet
        GreyImage image{.width = 2, .height = 1, .bits = 8, .grey = {0, 255}};
        asset.bonding.strengthImage->image = std::make_shared<GreyImage>(image);
        QCOMPARE(strengthAt(asset, {10.0, 20.5}), 0.5);
        QCOMPARE(strengthAt(asset, {11.0, 20.5}), 0.5);
        QCOMPARE(strengthAt(asset, {11.5, 20.5}), 1.0);
        QCOMPARE(strengthAt(asset, {12.0, 20.9}), 1.5);
        QCOMPARE(strengthAt(asset, {13.5, 20.1}), 2.5);
    }
    void rowsOfImagesRunDownwards() {
        Asset asset = fourFragments();
        const GreyImage image{.width = 1, .height = 2, .bits = 16, .grey = {65535, 0}};
        asset.bonding.strengthImage =
            StrengthImage{.darkest = 0.0, .brightest = 2.0, .image = std::make_shared<GreyImage>(image)};
        QCOMPARE(strengthAt(asset, {12.0, 20.9}), 2.0);
        QCOMPARE(strengthAt(asset, {12.0, 20.5}), 1.0);
        QCOMPARE(strengthAt(asset, {12.0, 20.1}), 0.0);
    }
    void transparentPixelsChangeNothing() {
        Asset asset = fourFragments();
        const GreyImage image{.width = 2, .height = 1, .bits = 8, .grey = {255, 255}, .opacity = {0, 51}};
        asset.bonding.strengthImage =
            StrengthImage{.darkest = 0.0, .brightest = 6.0, .image = std::make_shared<GreyImage>(image)};
        QCOMPARE(strengthAt(asset, {11.0, 20.5}), 1.0);
        QCOMPARE(strengthAt(asset, {13.0, 20.5}), 2.0);  // a fifth of the way from 1 to 6
    }
    void factorsMultiply() {
        Asset asset = fourFragments();
        BondStroke strong = stroke(BondBrush::Strength, {{12.0, 20.5}}, 5.0);
        strong.strength = 3.0;
        asset.bonding.strokes = {strong};
        asset.bonding.heightStrengths = {{0.0, 0.5}};
        QVERIFY(areNear(capacitiesOf(asset, 0, 2.0), {300.0, 300.0, 300.0}));
    }
    void bondsBetweenFragmentsThatNeverBreakAreInfinite() {
        Asset asset = fourFragments();
        asset.bonding.strokes = {stroke(BondBrush::NeverBreaks, {{10.5, 20.5}, {11.5, 20.5}})};
        asset.bonding.neverBreaks = {"3.2"};
        QVERIFY(areNear(capacitiesOf(asset), {kUnbreakable, kUnbreakable, 100.0}));
        Bond anchor{.first = 1, .area = 1.0, .centroid = {11.5, 20.0, 0.0}, .seedDistance = 0.5};
        const Bake baked = *bake(asset);
        QCOMPARE(bondCapacities(asset, Material{}, baked, 0, std::span(&anchor, 1)), std::vector{kUnbreakable});
        anchor.first = 3;
        QCOMPARE(bondCapacities(asset, Material{}, baked, 0, std::span(&anchor, 1)), std::vector{200.0});
    }
    void fragmentsNeverBreakByStrokeOrPath() {
        Asset asset = withLevel();
        asset.bonding.strokes = {stroke(BondBrush::NeverBreaks, {{12.5, 20.5}, {13.5, 20.5}})};
        asset.bonding.neverBreaks = {"3.1"};
        const Bake baked = *bake(asset);
        QCOMPARE(neverBreaking(asset, baked, 0), (std::vector<bool>{false, true, true, true}));
        QCOMPARE(neverBreaking(asset, baked, 1), (std::vector<bool>{true, true}));  // descendants of "3.1"
        asset.bonding.neverBreaks = {"3.1/9.1"};
        QCOMPARE(neverBreaking(asset, baked, 0), (std::vector<bool>{false, false, true, true}));
        QCOMPARE(neverBreaking(asset, baked, 1), (std::vector<bool>{false, true}));
    }
    void anchorsArePainted() {
        Asset asset = withLevel();
        BondStroke erased = stroke(BondBrush::Anchor, {{12.5, 20.5}});
        erased.isErasing = true;
        asset.bonding.strokes = {stroke(BondBrush::Anchor, {{9.0, 19.95}, {15.0, 19.95}}), erased,
                                 stroke(BondBrush::NeverBreaks, {{10.5, 20.5}})};
        const Bake baked = *bake(asset);
        QCOMPARE(anchoredFragments(asset, baked, 0), (std::vector<std::uint32_t>{0, 1, 3}));
        QCOMPARE(anchoredFragments(asset, baked, 1), (std::vector<std::uint32_t>{0, 1}));
        asset.bonding.strokes = {stroke(BondBrush::Anchor, {{11.7, 20.5}})};
        QCOMPARE(anchoredFragments(asset, baked, 0), std::vector<std::uint32_t>{1});
        QCOMPARE(anchoredFragments(asset, baked, 1), std::vector<std::uint32_t>{1});
    }
    void strokesCoverPointsWithinTheirRadius() {
        const BondStroke line = stroke(BondBrush::Strength, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}, 0.25);
        QVERIFY(covers(line, {0.5, 0.25}));
        QVERIFY(covers(line, {1.25, 0.5}));
        QVERIFY(!covers(line, {0.5, 0.26}));
        QVERIFY(!covers(line, {0.5, 0.6}));
    }
};

RUBBLE_TEST(BondCapacitiesTest)
#include "BondCapacitiesTest.moc"
