// Tests core/asset/project/Variants.cpp and core/asset/bake/AssetBakes.cpp.
#include "core/asset/bake/AssetBakes.h"
#include "core/asset/bake/BakeHash.h"
#include "core/asset/checks/VerifyBake.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

namespace rubble {

class VariantsTest : public QObject {
    Q_OBJECT

private slots:
    void variantZeroIsTheAsset() {
        for (const Asset& asset : fullProject().assets) QVERIFY(variantOf(asset, 0) == asset);
    }
    void everyLayerGetsAnotherRandomSeed() {
        const Asset asset = fullProject().assets[0];
        const Asset first = variantOf(asset, 1), second = variantOf(asset, 2);
        for (std::size_t k = 0; k < asset.pattern.layers.size(); ++k) {
            QVERIFY(first.pattern.layers[k].randomSeed != asset.pattern.layers[k].randomSeed);
            QVERIFY(first.pattern.layers[k].randomSeed != second.pattern.layers[k].randomSeed);
        }
        QVERIFY(first.levels[0].pattern.layers[0].randomSeed != asset.levels[0].pattern.layers[0].randomSeed);
        QCOMPARE(first.name, std::string("wall~1"));
        QVERIFY(first.prism() == asset.prism());
    }
    void overridesAreDroppedAndPlacedSeedsKept() {
        const Asset asset = fullProject().assets[0];
        const Asset variant = variantOf(asset, 7);
        QVERIFY(!asset.pattern.layers[0].overrides.empty() && variant.pattern.layers[0].overrides.empty());
        QVERIFY(variant.pattern.layers[2].parameters == asset.pattern.layers[2].parameters);
    }
    void thresholdsOfSingleFragmentsAreDroppedAndThoseOfLevelsKept() {
        const Asset variant = variantOf(fullProject().assets[0], 1);
        QVERIFY(variant.fragmentThresholds.empty());
        QCOMPARE(variant.levels[0].threshold, std::optional(17.25));
    }
    void onlyPaintedFragmentsNeverBreakInVariants() {
        const Asset asset = fullProject().assets[0], variant = variantOf(asset, 1);
        QVERIFY(!asset.bonding.neverBreaks.empty() && variant.bonding.neverBreaks.empty());
        QVERIFY(!asset.bonding.clusters.empty() && variant.bonding.clusters.empty());
        QVERIFY(variant.bonding.strokes == asset.bonding.strokes);
        QCOMPARE(variant.levels[0].bondStrength, 0.75);
    }
    void usedVariantsAreAllAssetsAndThoseOfInstances() {
        Project project = fullProject();  // assets 3, 9 and 11; an instance of 3, and one of 9 in variant 3
        project.instances.push_back(project.instances[1]);
        project.instances.push_back({.id = 22, .asset = 99, .variant = 1});  // of nothing
        const std::vector<AssetVariant> expected{{3, 0}, {9, 0}, {9, 3}, {11, 0}};
        QVERIFY(usedVariants(project) == expected);
    }
    void bakesOfVariantsDiffer() {
        Project project;
        project.assets = {boxAsset(2, 3, UniformScatter{.count = 6})};
        project.instances = {{.id = 5, .asset = 2}, {.id = 6, .asset = 2, .variant = 4}};
        const AssetBakes bakes = bakesOf(project).value();
        QCOMPARE(bakes.size(), std::size_t{2});
        const Bake &own = *bakes.at({2}), &other = *bakes.at({2, 4});
        QVERIFY(own.input == bakeInputHash(project.assets[0]) && own.input != other.input);
        QVERIFY(own.fractures[0].seeds.positions != other.fractures[0].seeds.positions);
        QCOMPARE(own.whole.volume, other.whole.volume);
        QCOMPARE(own.fragmentId(5), other.fragmentId(5));
        QVERIFY(!verifyBake(other, variantOf(project.assets[0], 4)));
    }
};

RUBBLE_TEST(VariantsTest)

}  // namespace rubble

#include "VariantsTest.moc"
