#include "core/asset/bake/BakeHash.h"
#include "core/asset/bake/VariantGeneration.h"
#include "core/fracture/pattern/PatternKind.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

namespace rubble {
namespace {

/// The unit square with clusters in layer 4 and seeds by hand in layer 5.
Asset heaps() {
    Asset asset = boxAsset(1, 4, Clusters{.clusters = 4, .seedsPerCluster = 5, .radius = 0.2});
    asset.pattern.layers.push_back({.id = 5, .parameters = PlacedSeeds{{{0, {0.5, 0.5}}}}});
    return asset;
}

const Clusters& clustersOf(const Asset& asset) { return std::get<Clusters>(asset.pattern.layers[0].parameters); }

std::vector<Asset> variants(const Asset& asset, const VariantRecipe& recipe) {
    return generateVariants(asset, recipe).value();
}
std::vector<Asset> childrenFrom(std::span<const Asset> parents, const VariantRecipe& recipe) {
    return crossoverVariants(parents, recipe).value();
}

Vec2 positionOf(const Asset& asset, SeedId id) { return lockedIn(*bake(asset), std::vector{id}).at(0).position; }

}  // namespace

class VariantGenerationTest : public QObject {
    Q_OBJECT

private slots:
    void firstVariantIsTheAssetAndOthersDiffer() {
        const Asset asset = fullProject().assets[0];
        const std::vector<Asset> made = variants(asset, {.count = 5});
        QCOMPARE(made.size(), std::size_t{5});
        QVERIFY(made[0] == asset);
        for (std::size_t k = 1; k < made.size(); ++k) {
            QVERIFY(bakeInputHash(made[k]) != bakeInputHash(made[k - 1]));
            QCOMPARE(made[k].id, asset.id);
            QCOMPARE(made[k].name, asset.name);
            QVERIFY(made[k].prism() == asset.prism() && made[k].threshold == asset.threshold);
        }
    }
    void sameRecipeGivesTheSameVariants() {
        const VariantRecipe recipe{.varied = {{4, "radius", 0.1, 0.3}}};
        VariantRecipe other = recipe;
        other.randomSeed = 2;
        const std::vector<Asset> made = variants(heaps(), recipe);
        QVERIFY(made == variants(heaps(), recipe));
        QVERIFY(made != variants(heaps(), other));
        QVERIFY(childrenFrom(made, recipe) == childrenFrom(made, recipe));
    }
    void onlyVariedParametersChangeWithinTheirRanges() {
        const VariantRecipe recipe{.count = 50, .varied = {{4, "radius", 0.1, 0.3}, {4, "clusters", 2.0, 6.0}}};
        std::set<std::uint32_t> counts;
        for (const Asset& variant : variants(heaps(), recipe)) {
            const Clusters& clusters = clustersOf(variant);
            QVERIFY(clusters.radius >= 0.1 && clusters.radius <= 0.3);
            QVERIFY(clusters.clusters >= 2 && clusters.clusters <= 6);
            QCOMPARE(clusters.seedsPerCluster, 5u);
            counts.insert(clusters.clusters);
        }
        QCOMPARE(counts.size(), std::size_t{5});
    }
    void variantsCycleThroughTheKinds() {
        const Asset asset = boxAsset(1, 4, UniformScatter{33});
        const std::vector<Asset> made = variants(asset, {.count = 5, .kinds = {"blueNoise", "radial"}});
        for (std::size_t k : {1, 3}) {
            QCOMPARE(std::get<BlueNoise>(made[k].pattern.layers[0].parameters).count, SeedCount(33));
        }
        for (std::size_t k : {2, 4}) {
            QVERIFY(std::holds_alternative<RadialPattern>(made[k].pattern.layers[0].parameters));
            QCOMPARE(made[k].pattern.layers[0].id, 4u);
        }
    }
    void everyOfferedKindGivesSeeds() {
        QVERIFY(variedKinds().size() >= 6);
        for (const PatternKind* kind : variedKinds()) {
            const VariantRecipe recipe{.count = 2, .kinds = {std::string(kind->name)}};
            const Asset variant = variants(boxAsset(1, 4, UniformScatter{20}), recipe)[1];
            QVERIFY2(bake(variant)->fragmentCount() > 1, kind->caption);
        }
    }
    void lockedSeedsKeepTheirPositions() {
        for (std::uint64_t randomSeed = 0; randomSeed < 10; ++randomSeed) {
            const Asset asset = heaps();
            const std::vector<SeedId> seeds{{4, 3}, {4, 11}, {5, 0}};
            VariantRecipe recipe{.count = 6, .randomSeed = randomSeed};
            recipe.locked = lockedIn(*bake(asset), seeds);
            QCOMPARE(recipe.locked.size(), std::size_t{3});
            const std::vector<Asset> made = variants(asset, recipe);
            std::vector<Asset> all = childrenFrom(std::span(made).subspan(1, 2), recipe);
            all.insert(all.end(), made.begin(), made.end());
            for (const Asset& one : all) {
                for (const LockedSeed& seed : recipe.locked) {
                    QVERIFY2(positionOf(one, seed.id) == seed.position,
                             qPrintable(QString("random seed %1").arg(randomSeed)));
                }
            }
        }
    }
    void countIsRaisedToALockedSeed() {
        const Asset asset = boxAsset(1, 4, UniformScatter{20});
        VariantRecipe recipe{.count = 10, .varied = {{4, "count", 2.0, 4.0}}};
        recipe.locked = lockedIn(*bake(asset), std::vector{SeedId{4, 12}});
        for (const Asset& variant : variants(asset, recipe)) {
            QVERIFY(positionOf(variant, {4, 12}) == recipe.locked[0].position);
            QVERIFY(bake(variant)->diagnostics.empty());
        }
    }
    void relaxedSeedIsLockedAtItsFinalPosition() {
        Asset asset = boxAsset(1, 4, UniformScatter{12});
        asset.pattern.layers.push_back({.id = 6, .parameters = LloydRelaxation{5}});
        VariantRecipe recipe{.count = 4};
        recipe.locked = lockedIn(*bake(asset), std::vector{SeedId{4, 2}});
        for (const Asset& variant : variants(asset, recipe)) {
            QVERIFY(positionOf(variant, {4, 2}) == recipe.locked[0].position);
        }
    }
    void childrenHaveMutatedLayersOfTheirParents() {
        Asset one = heaps(), other = heaps();
        one.pattern.layers[0].randomSeed = 100;
        other.pattern.layers[0].randomSeed = 200;
        other.pattern.layers[0].parameters = Clusters{.clusters = 40, .seedsPerCluster = 5, .radius = 0.02};
        const VariantRecipe recipe{.count = 40, .spread = 0.1};
        const std::vector<Asset> children = childrenFrom(std::vector{one, other}, recipe);
        QVERIFY(children[0] == one && children[1] == other);
        std::size_t inherited = 0;
        for (std::size_t k = 2; k < children.size(); ++k) {
            const Clusters& made = clustersOf(children[k]);
            const bool isOfOne = made.clusters < 10;
            const double radius = isOfOne ? 0.2 : 0.02, clusters = isOfOne ? 4.0 : 40.0;
            QVERIFY(made.radius >= radius / 1.1 - 1e-12 && made.radius <= radius * 1.1 + 1e-12);
            QVERIFY(std::abs(made.clusters - clusters) <= 0.1 * clusters + 0.5);
            QVERIFY(!(children[k] == one) && !(children[k] == other));
            const std::uint64_t randomSeed = children[k].pattern.layers[0].randomSeed;
            if (randomSeed == (isOfOne ? 100u : 200u)) ++inherited;
        }
        QVERIFY(inherited > 20);  // two of three
    }
    void childrenStayInTheVariedRanges() {
        const VariantRecipe recipe{.count = 60, .varied = {{4, "radius", 0.19, 0.21}}, .spread = 0.5};
        for (const Asset& child : childrenFrom(std::vector{heaps()}, recipe)) {
            QVERIFY(clustersOf(child).radius >= 0.19 && clustersOf(child).radius <= 0.21);
        }
    }
    void withoutSpreadChildrenDifferInRandomSeeds() {
        const std::vector<Asset> made = childrenFrom(std::vector{heaps()}, {.count = 4, .spread = 0.0});
        for (std::size_t k = 1; k < made.size(); ++k) {
            QVERIFY(made[k].pattern.layers[0].parameters == heaps().pattern.layers[0].parameters);
            QVERIFY(made[k].pattern.layers[0].randomSeed != made[k - 1].pattern.layers[0].randomSeed);
        }
    }
    void levelsGetNewRandomSeeds() {
        Asset asset = heaps();
        PatternLayer scatter{.id = 6, .randomSeed = 50, .parameters = UniformScatter{5}};
        scatter.overrides = {{.index = 1, .position = {0.01, 0.01}}};
        asset.levels = {{.pattern = {{scatter}}}};
        const auto seedOf = [](const Asset& of) { return of.levels[0].pattern.layers[0].randomSeed; };
        const std::vector<Asset> made = variants(asset, {.count = 6}),
                                 others = variants(asset, {.count = 6, .randomSeed = 2});
        std::set<std::uint64_t> seeds;
        for (std::size_t k = 0; k < made.size(); ++k) {
            seeds.insert(seedOf(made[k]));
            seeds.insert(seedOf(others[k]));
            QVERIFY(made[k].levels[0].pattern.layers[0].parameters == scatter.parameters);
        }
        QCOMPARE(seeds.size(), std::size_t{11});  // the asset's own, and five of each recipe

        const std::vector<Asset> children =
            childrenFrom(std::vector{made[1], made[2], asset}, {.count = 60, .spread = 0.0});
        std::size_t inherited = 0, fresh = 0;
        for (std::size_t k = 3; k < children.size(); ++k) {
            const PatternLayer& layer = children[k].levels[0].pattern.layers[0];
            const bool isOfParent = std::ranges::any_of(
                std::span(children).first(3), [&](const Asset& parent) { return parent.levels == children[k].levels; });
            QVERIFY(isOfParent || layer.overrides.empty());
            ++(isOfParent ? inherited : fresh);
        }
        QVERIFY2(inherited > 10 && fresh > 10, qPrintable(QString("%1 %2").arg(inherited).arg(fresh)));
    }
    void childrenHaveNoSettingsOfSingleFragments() {
        const std::vector<Asset> parents{fullProject().assets[0]};
        const std::vector<Asset> children = childrenFrom(parents, {.count = 4});
        QVERIFY(!parents[0].bonding.neverBreaks.empty());
        for (const Asset& child : std::span(children).subspan(parents.size())) {
            QVERIFY(child.fragmentThresholds.empty() && child.bonding.neverBreaks.empty());
            QVERIFY(child.bonding.clusters.empty());
            QVERIFY(child.bonding.strokes == parents[0].bonding.strokes);
        }
    }
    void allDescendantsAreValid() {
        std::vector<Asset> generation = variants(fullProject().assets[0], {.count = 4});
        for (std::uint64_t k = 0; k < 20; ++k) {
            generation = childrenFrom(generation, {.count = 4, .randomSeed = k, .spread = 0.9});
            for (const Asset& asset : generation) {
                const std::optional<std::string> fault = verifyPattern(asset.pattern);
                QVERIFY2(!fault, fault ? fault->c_str() : "");
            }
        }
    }
    void invalidRecipesAreRejected_data() {
        QTest::addColumn<VariantRecipe>("recipe");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* word, VariantRecipe recipe) { QTest::newRow(word) << recipe << QString(word); };
        row("variants is 0", {.count = 0});
        row("variants is 1001", {.count = 1001});
        row("spread is 1", {.spread = 1.0});
        row("spread is -0.1", {.spread = -0.1});
        row("spread is nan", {.spread = std::nan("")});
        row("\"voronoi\" is not a kind", {.kinds = {"voronoi"}});
        row("\"placed\" is not a kind", {.kinds = {"placed"}});
        row("no such layer", {.varied = {{9, "radius", 0.1, 0.2}}});
        row("not a number of", {.varied = {{4, "centre", 0.1, 0.2}}});
        row("the range is empty", {.varied = {{4, "radius", 0.2, 0.1}}});
        row("from nan", {.varied = {{4, "radius", std::nan(""), 0.1}}});
        row("does not accept", {.varied = {{4, "radius", -0.2, 0.1}}});
        row("Seed 7.1 cannot be locked", {.locked = {{{7, 1}, {}}}});
    }
    void invalidRecipesAreRejected() {
        QFETCH(const VariantRecipe, recipe);
        QFETCH(const QString, word);
        const Result<std::vector<Asset>> made = generateVariants(heaps(), recipe);
        QVERIFY(!made);
        QVERIFY2(QString::fromStdString(made.error().message).contains(word), made.error().message.c_str());
        if (!recipe.varied.empty()) return;  // children may be of another kind
        const Result<std::vector<Asset>> children = crossoverVariants(std::vector{heaps()}, recipe);
        QVERIFY(!children);
        QCOMPARE(children.error().message, made.error().message);
    }
    void crossoverNeedsParents() { QVERIFY(!crossoverVariants({}, {}).hasValue()); }
};

RUBBLE_TEST(VariantGenerationTest)

}  // namespace rubble

#include "VariantGenerationTest.moc"
