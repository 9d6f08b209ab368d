// Tests core/asset/compare/AssetDifference.cpp and core/asset/compare/RecipeDifference.cpp.
#include "core/asset/compare/AssetDifference.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

namespace rubble {
namespace {

Project projectOf(std::vector<Asset> assets) {
    Project project{.nextId = 100, .materials = {{.id = 1, .name = "stone"}, {.id = 2, .name = "glass"}}};
    project.assets = std::move(assets);
    return project;
}

Asset called(const std::string& name, Id id) {
    Asset asset = boxAsset(id, id + 50, UniformScatter{6});
    asset.name = name;
    return asset;
}

std::vector<RecipeChange> changesOf(const Asset& before, const Asset& after) {
    return recipeChanges(projectOf({before}), before, projectOf({after}), after);
}

}  // namespace

class AssetDifferenceTest : public QObject {
    Q_OBJECT

private slots:
    void assetsAreMatchedByNameThenById() {
        const Project before = projectOf({called("wall", 3), called("roof", 4), called("door", 5)});
        const Project after = projectOf({called("gable", 4), called("wall", 9), called("step", 10)});
        const std::vector<AssetPair> pairs = assetPairs(before, after);
        QCOMPARE(pairs.size(), std::size_t{4});
        QVERIFY(pairs[0].before == &before.assets[1] && pairs[0].after == &after.assets[0]);  // renamed
        QVERIFY(pairs[1].before == &before.assets[0] && pairs[1].after == &after.assets[1]);  // of another id
        QVERIFY(!pairs[2].before && pairs[2].after == &after.assets[2]);
        QVERIFY(pairs[3].before == &before.assets[2] && !pairs[3].after);
        QCOMPARE(pairs[3].name(), std::string("door"));
    }
    void nameTakesPrecedenceOverId() {
        const Project before = projectOf({called("wall", 3), called("roof", 4)});
        const Project after = projectOf({called("roof", 3), called("wall", 4)});
        const std::vector<AssetPair> pairs = assetPairs(before, after);
        QCOMPARE(pairs.size(), std::size_t{2});
        QVERIFY(pairs[0].before == &before.assets[1] && pairs[1].before == &before.assets[0]);
    }
    void assetEqualsItself() {
        const Project project = fullProject();
        for (const Asset& asset : project.assets) {
            QVERIFY(recipeChanges(project, asset, project, asset).empty());
        }
    }
    void everyMemberOfAnAssetIsReported() {
        const Asset asset = fullProject().assets[0];
        const auto isReported = [&](auto change, const std::string& what) {
            Asset other = asset;
            change(other);
            const std::vector<RecipeChange> changes = changesOf(asset, other);
            return changes.size() == 1 && changes[0].what == what && changes[0].before != changes[0].after;
        };
        QVERIFY(isReported([](Asset& a) { a.name = "fence"; }, "name"));
        QVERIFY(isReported([](Asset& a) { a.prism().outline.outer[0].x -= 0.5; }, "outline"));
        QVERIFY(isReported(
            [](Asset& a) { std::ranges::rotate(a.prism().outline.outer, a.prism().outline.outer.begin() + 1); },
            "outline"));
        QVERIFY(isReported([](Asset& a) { a.prism().depth = 3.0; }, "depth"));
        QVERIFY(isReported([](Asset& a) { a.material = 2; }, "material"));
        QVERIFY(isReported([](Asset& a) { a.insideMaterial = 0; }, "inside material"));
        QVERIFY(isReported([](Asset& a) { a.threshold = 56.0; }, "threshold"));
        QVERIFY(isReported([](Asset& a) { a.contactTime = 0.0625; }, "threshold"));
        QVERIFY(isReported([](Asset& a) { a.insideUvScale = 3.0; }, "inside UV scale"));
        QVERIFY(isReported([](Asset& a) { a.cutAtImpact.reset(); }, "cut at impact"));
        QVERIFY(isReported([](Asset& a) { a.shaping.gap = 0.0; }, "gap"));
        QVERIFY(isReported([](Asset& a) { a.shaping.smallPieces.limit = 0.5; }, "small fragments"));
        QVERIFY(isReported([](Asset& a) { a.shaping.roughness.octaves = 1; }, "roughness"));
        QVERIFY(isReported([](Asset& a) { a.fragmentLevels[0].fragment = "4.4"; }, "fragments with their own pattern"));
        QVERIFY(isReported([](Asset& a) { a.edits.pop_back(); }, "fragments merged or split"));
        QVERIFY(isReported([](Asset& a) { a.requirements.clear(); }, "strength requirements"));
        QVERIFY(isReported([](Asset& a) { a.levels[0].minimumVolume = 1.0; },
                           "minimum volume of fractured fragments, of level 1"));
    }
    void everyParameterOfALayerIsReported() {
        const Asset asset = fullProject().assets[0];
        for (std::size_t level = 0; level < asset.levels.size(); ++level) {
            for (std::size_t k = 0; k < asset.levels[level].pattern.layers.size(); ++k) {
                Asset other = asset;
                PatternLayer& layer = other.levels[level].pattern.layers[k];
                const PatternKind& kind = kindOf(layer.parameters);
                for (const LayerParameter& parameter : kind.parameters) {
                    if (parameter.type != ParameterType::Real) continue;
                    layer = asset.levels[level].pattern.layers[k];
                    parameter.write(layer.parameters, std::get<double>(parameter.read(layer.parameters)) + 0.125);
                    const std::vector<RecipeChange> changes = changesOf(asset, other);
                    QCOMPARE(changes.size(), std::size_t{1});
                    QCOMPARE(changes[0].what, "layer " + std::to_string(layer.id) + " (" + std::string(kind.name) +
                                                  "), " + std::string(parameter.name));
                }
            }
        }
    }
    void addedRemovedAndMovedLayersAreReported() {
        const Asset asset = fullProject().assets[0];
        Asset other = asset;
        std::swap(other.pattern.layers[0], other.pattern.layers[1]);
        QCOMPARE(changesOf(asset, other), (std::vector<RecipeChange>{{"order of layers", "4, 5, 6, 7", "5, 4, 6, 7"}}));
        other = asset;
        other.pattern.layers.erase(other.pattern.layers.begin() + 3);
        const std::vector<RecipeChange> gone = changesOf(asset, other), added = changesOf(other, asset);
        QCOMPARE(gone, (std::vector<RecipeChange>{{"layer 7 (lloyd)", "rounds 4", ""}}));
        QCOMPARE(sentenceOf(gone[0]), std::string("layer 7 (lloyd) removed: rounds 4"));
        QCOMPARE(sentenceOf(added[0]), std::string("layer 7 (lloyd) added: rounds 4"));
    }
    void seedEditsAreReported() {
        const Asset asset = fullProject().assets[0];
        Asset other = asset;
        other.pattern.layers[0].overrides[0].position = {0.0, 0.0};
        QCOMPARE(changesOf(asset, other),
                 (std::vector<RecipeChange>{{"layer 4 (uniform), seeds changed by hand", "2", "2, changed"}}));
        other = asset;
        std::get<PlacedSeeds>(other.pattern.layers[2].parameters).seeds.pop_back();
        const std::vector<RecipeChange> changes = changesOf(asset, other);
        QCOMPARE(changes, (std::vector<RecipeChange>{{"layer 6 (placed), data", "2 seeds", "1 seed"}}));
        QCOMPARE(sentenceOf(changes[0]), std::string("layer 6 (placed), data: 1 seed, was 2 seeds"));
    }
    void differenceCombinesRecipeAndBakes() {
        Project before = projectOf({called("wall", 3)}), after = before;
        after.assets[0].pattern.layers[0].parameters = UniformScatter{8};
        const AssetDifference difference =
            differenceOf(before, after, assetPairs(before, after)[0], {.threads = 2}).value();
        QVERIFY(!difference.isEmpty());
        QCOMPARE(difference.recipe, (std::vector<RecipeChange>{{"layer 53 (uniform), count", "6", "8"}}));
        QCOMPARE(difference.fragments.count(FragmentChange::Added), std::size_t{2});
        QVERIFY(
            QString::fromStdString(sentenceOf(difference.fragments.sum())).startsWith("8 fragments, were 6: 2 added"));
        QVERIFY(differenceOf(before, before, assetPairs(before, before)[0])->isEmpty());
    }
    void fragmentsOfANewOrRemovedAssetAreAddedOrGone() {
        const Project with = projectOf({called("wall", 3)}), without = projectOf({});
        const AssetDifference added = differenceOf(without, with, assetPairs(without, with)[0]).value();
        QCOMPARE(added.fragments.count(FragmentChange::Added), std::size_t{6});
        QVERIFY(added.recipe.empty() && !added.isEmpty());
        QCOMPARE(differenceOf(with, without, assetPairs(with, without)[0])->fragments.count(FragmentChange::Gone),
                 std::size_t{6});
    }
    void bakeErrorsAndCancellationAreReturned() {
        Project before = projectOf({called("wall", 3)}), after = before;
        after.assets[0].prism().depth = 0.0;
        const AssetPair pair = assetPairs(before, after)[0];
        QVERIFY(differenceOf(before, after, pair).error().code != ErrorCode::Cancelled);
        const TaskContext task;
        task.cancel.cancel();
        QVERIFY(differenceOf(before, before, assetPairs(before, before)[0], task).error().code == ErrorCode::Cancelled);
    }
    void sentenceDescribesOneFragment() {
        FragmentDifference piece{.path = "5.17", .shift = 0.0125, .volumeBefore = 0.25, .volumeAfter = 0.5};
        QCOMPARE(sentenceOf(piece), std::string("5.17 moved by 12.5 mm, now 0.5 m³, was 0.25 m³"));
        piece.change = FragmentChange::Reshaped;
        QCOMPARE(sentenceOf(piece), std::string("5.17 changed shape, now 0.5 m³, was 0.25 m³"));
        piece.change = FragmentChange::Gone;
        QCOMPARE(sentenceOf(piece), std::string("5.17 removed, was 0.25 m³"));
        piece.change = FragmentChange::Added;
        QCOMPARE(sentenceOf(piece), std::string("5.17 added, 0.5 m³"));
        QCOMPARE(sentenceOf(LevelDifference{.before = 1, .after = 1, .unchanged = 1}),
                 std::string("1 fragment, unchanged"));
    }
};

RUBBLE_TEST(AssetDifferenceTest)

}  // namespace rubble

#include "AssetDifferenceTest.moc"
