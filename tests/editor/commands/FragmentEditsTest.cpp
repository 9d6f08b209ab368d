#include "editor/commands/FragmentEdits.h"

#include "core/asset/bake/Bake.h"
#include "core/asset/bake/FractureResult.h"
#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/fracture/pattern/SeedEdits.h"
#include "core/io/project/ProjectFile.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/Document.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ProjectParts.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <map>

using namespace rubble;

namespace {

/// A unit square in four columns; the last is the widest.
Project columns() {
    Project project;
    const Id stone = test::addMaterial(project, {.name = "stone"});
    test::addAsset(project, {.name = "wall", .material = stone, .shape = Prism{unitSquare(), 0.5}},
                   {PlacedSeeds{{{0, {0.1, 0.5}}, {1, {0.3, 0.5}}, {2, {0.5, 0.5}}, {3, {0.7, 0.5}}}}});
    return project;
}

constexpr Id kWall = 2;
constexpr Id kLayer = 3;

/// The current pieces of some seeds.
std::vector<SelectedFragment> selectedOf(const Project& project, const std::set<SeedId>& seeds) {
    const Asset& asset = *findAsset(project, kWall);
    const PlanarFracture cut = *planarFracture(recipeOf(asset), asset.prism(), {});
    return selectedFragments(kWall, cut.partition, cut.seeds, {.seeds = seeds});
}

/// The same in a fragment's pattern.
std::vector<SelectedFragment> selectedInside(const Project& project, const FragmentPath& fragment,
                                             const std::set<SeedId>& seeds) {
    const Bake baked = *bake(*findAsset(project, kWall));
    const std::uint32_t number = *fragmentAt(baked, fragment);
    const BakedFracture& fracture = *baked.fractureOf(number);
    return selectedFragments(kWall, fracture.fragments.extruded()->partition, fracture.seeds,
                             {.seeds = seeds, .parent = fragment}, fragment,
                             Vec2{baked.fragment(number).solid.offset()});
}

/// The ids of all fragments, and their outlines.
std::map<std::string, Polygon> outlinesOf(const Asset& asset) {
    const Bake baked = *bake(asset);
    std::map<std::string, Polygon> outlines;
    for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k)
        outlines[baked.fragmentId(k)] = baked.fragment(k).solid.extruded()->outline();
    return outlines;
}

SeedId seed(std::uint32_t index) { return {kLayer, index}; }

}  // namespace

/// After each test, cleanup() verifies the project and undoes all edits.
class FragmentEditsTest : public QObject {
    Q_OBJECT

    Document m_document{columns()};
    const std::string m_before = projectText(columns());
    const Asset& wall() const { return *findAsset(m_document.project(), kWall); }
    std::vector<SelectedFragment> pieces(const std::set<SeedId>& seeds) const {
        return selectedOf(m_document.project(), seeds);
    }
    std::vector<FragmentPath> paths() const {
        std::vector<FragmentPath> paths;
        for (const SelectedFragment& piece : pieces({seed(0), seed(1), seed(2), seed(3)})) paths.push_back(piece.path);
        std::ranges::sort(paths);
        return paths;
    }

private slots:
    void cleanup() {
        QCOMPARE(verifyProject(m_document.project()).value_or(""), std::string());
        while (m_document.undoStack().canUndo()) m_document.undoStack().undo();
        QCOMPARE(projectText(m_document.project()), m_before);
    }
    void selectedPiecesHaveAreaAndSplitLine() {
        const std::vector<SelectedFragment> last = pieces({seed(3)});
        QCOMPARE(last.size(), std::size_t{1});
        QCOMPARE(last[0].path, FragmentPath("3.3"));
        QVERIFY(std::abs(last[0].area - 0.4) < 1e-12);
        QVERIFY(std::abs(last[0].splitLine.direction.y) < 1e-9);  // it is taller than wide
    }
    void mergeKeepsTheLargestName() {
        m_document.push(mergeFragments(m_document.project(), kWall, pieces({seed(2), seed(3)})));
        QVERIFY(std::get<FragmentMerge>(wall().edits[0]) == (FragmentMerge{"3.3", {"3.2"}}));
        QCOMPARE(paths(), (std::vector<FragmentPath>{"3.0", "3.1", "3.3"}));
    }
    void splitGivesTwoFragments() {
        m_document.push(splitFragments(m_document.project(), kWall, pieces({seed(1)})));
        QCOMPARE(paths(), (std::vector<FragmentPath>{"3.0", "3.1.0", "3.1.1", "3.2", "3.3"}));
        const std::vector<SelectedFragment> halves = pieces({seed(1)});
        QVERIFY(std::abs(halves[0].area - halves[1].area) < 1e-9);
    }
    void fractureAndKeepWhole() {
        m_document.push(fractureFragments(m_document.project(), kWall, pieces({seed(1), seed(2)})));
        QCOMPARE(wall().fragmentLevels.size(), std::size_t{2});
        QVERIFY(wall().fragmentLevels[0].level && wall().fragmentLevels[0].level->pattern.layers.size() == 1);
        const Pattern first = wall().fragmentLevels[0].level->pattern;
        m_document.push(fractureFragments(m_document.project(), kWall, pieces({seed(1)})));
        QVERIFY(wall().fragmentLevels[0].level->pattern == first);  // it had one already
        QCOMPARE(patternCount(wall()), std::size_t{3});
        QCOMPARE(patternName(wall(), 2), QString("Fragment 3.2"));
        QCOMPARE(depthAt(wall(), 2), std::size_t{1});
        m_document.push(addLayer(m_document.project(), kWall, BlueNoise{}, 2).edit);
        QCOMPARE(patternAt(wall(), 2)->layers.size(), std::size_t{2});

        m_document.push(keepFragmentsWhole(m_document.project(), kWall, pieces({seed(1)})));
        QVERIFY(!wall().fragmentLevels[0].level);
        QVERIFY(patternAt(wall(), 1) == nullptr);
        QCOMPARE(patternName(wall(), 1), QString("Fragment 3.1, kept intact"));
    }
    void restoreRemovesEditsOfTheseSeeds() {
        m_document.push(mergeFragments(m_document.project(), kWall, pieces({seed(2), seed(3)})));
        m_document.push(splitFragments(m_document.project(), kWall, pieces({seed(0)})));
        m_document.push(keepFragmentsWhole(m_document.project(), kWall, pieces({seed(1)})));
        QVERIFY(canRestoreFragments(wall(), {seed(2)}));
        m_document.push(restoreFragments(m_document.project(), kWall, {seed(3), seed(1)}));
        QCOMPARE(wall().edits.size(), std::size_t{1});
        QVERIFY(wall().fragmentLevels.empty());
        QVERIFY(!canRestoreFragments(wall(), {seed(3)}));
        QVERIFY(canRestoreFragments(wall(), {seed(0)}));
    }
    void fragmentsThatNeverBreakAreKeptInOrderAndRestored() {
        Asset asset = wall();
        for (const char* path : {"3.1", "3.0", "3.1"}) setNeverBreaks(asset, path, true);
        setNeverBreaks(asset, "3.2", false);
        QCOMPARE(asset.bonding.neverBreaks, (std::vector<FragmentPath>{"3.0", "3.1"}));
        m_document.push(modify("Never Break", asset));
        QVERIFY(canRestoreFragments(wall(), {seed(1)}) && !canRestoreFragments(wall(), {seed(2)}));
        m_document.push(restoreFragments(m_document.project(), kWall, {seed(1)}));
        QCOMPARE(wall().bonding.neverBreaks, (std::vector<FragmentPath>{"3.0"}));
        setNeverBreaks(asset, "3.0", false);
        QCOMPARE(asset.bonding.neverBreaks, (std::vector<FragmentPath>{"3.1"}));
    }
    void restoreRemovesFragmentsOfTheseSeedsFromClusters() {
        Asset asset = wall();
        asset.bonding.clusters = {{0, {"3.0", "3.1", "3.2"}}};
        m_document.push(modify("Make Cluster", asset));
        QVERIFY(canRestoreFragments(wall(), {seed(1)}) && !canRestoreFragments(wall(), {seed(3)}));
        m_document.push(restoreFragments(m_document.project(), kWall, {seed(1)}));
        QCOMPARE(wall().bonding.clusters, (std::vector<FragmentCluster>{{0, {"3.0", "3.2"}}}));
    }
    void restoreRemovesThresholdsOfTheseSeeds() {
        Asset asset = wall();
        for (const char* path : {"3.1", "3.0", "3.1"}) setFragmentThreshold(asset, path, 2.5);
        QCOMPARE(asset.fragmentThresholds, (std::vector<FragmentThreshold>{{"3.0", 2.5}, {"3.1", 2.5}}));
        m_document.push(modify("Set Threshold", asset));
        QVERIFY(canRestoreFragments(wall(), {seed(1)}) && !canRestoreFragments(wall(), {seed(2)}));
        m_document.push(restoreFragments(m_document.project(), kWall, {seed(1)}));
        QCOMPARE(wall().fragmentThresholds, (std::vector<FragmentThreshold>{{"3.0", 2.5}}));
        setFragmentThreshold(asset, "3.0", std::nullopt);
        QCOMPARE(asset.fragmentThresholds, (std::vector<FragmentThreshold>{{"3.1", 2.5}}));
    }
    void ownPatternKeepsTheFragmentsOfTheLevel() {
        m_document.push(addLevel(m_document.project(), kWall));
        m_document.push(addLevel(m_document.project(), kWall));
        Asset asset = wall();
        asset.levels[0].minimumVolume = 0.001;
        const auto before = outlinesOf(asset);
        QCOMPARE(patternIndexFor(asset, "3.1"), std::size_t{1});
        QVERIFY(!hasOwnPattern(asset, "3.1"));

        Pattern& own = ownPattern(asset, "3.1");
        QVERIFY(hasOwnPattern(asset, "3.1"));
        QCOMPARE(patternIndexFor(asset, "3.1"), std::size_t{3});
        QVERIFY(own == asset.levels[0].pattern);
        QCOMPARE(asset.fragmentLevels[0].level->minimumVolume, 0.001);
        QVERIFY(&ownPattern(asset, "3.1") == &own);  // it has one already
        QVERIFY(outlinesOf(asset) == before);        // also those of deeper levels

        moveSeed(own, {own.layers[0].id, 0}, {0.01, 0.02});
        const auto after = outlinesOf(asset);
        for (const auto& [id, outline] : before) {
            if (!isWithin(pathOfId(id), "3.1")) QVERIFY2(after.contains(id) && after.at(id) == outline, id.c_str());
        }
        QVERIFY(after != before);
        m_document.push(modify("Move Seed", std::move(asset)));  // cleanup() verifies it
    }
    void deeperFragmentGetsItsOwnPattern() {
        Asset asset = wall();
        asset.levels = {Level{}};
        QVERIFY(&ownPattern(asset, {}) == &asset.pattern);
        ownPattern(asset, "3.1/9.0");
        ownPattern(asset, "3.0");
        ownPattern(asset, "3.1");
        QVERIFY(std::ranges::is_sorted(asset.fragmentLevels, {}, &FragmentLevel::fragment));
        QVERIFY(ownPattern(asset, "3.1/9.0").layers.empty());  // there is no second level
        QCOMPARE(patternIndexFor(asset, "3.3/9.0"), std::size_t{0});
    }
    void piecesInAFragmentHavePathAndOffset() {
        m_document.push(addLevel(m_document.project(), kWall));
        const SeedId inner{wall().levels[0].pattern.layers[0].id, 0};
        const std::vector<SelectedFragment> one = selectedInside(m_document.project(), "3.3", {inner});
        QCOMPARE(one.size(), std::size_t{1});
        QCOMPARE(one[0].path, FragmentPath("3.3/" + inner.text()));
        const Bake before = *bake(wall());
        const Vec2 centre{before.fragment(*fragmentAt(before, one[0].path)).solid.offset()};
        QVERIFY(glm::distance(centre, one[0].splitLine.point) < 1e-12);
        m_document.push(splitFragments(m_document.project(), kWall, one));
        const Bake baked = *bake(wall());
        QVERIFY(fragmentAt(baked, one[0].path + ".0") && fragmentAt(baked, one[0].path + ".1"));
        QVERIFY(canRestoreFragments(wall(), {inner}, "3.3"));
        QVERIFY(!canRestoreFragments(wall(), {inner}, "3.2"));
        QVERIFY(!canRestoreFragments(wall(), {{inner.layer, 1}}, "3.3"));
        QVERIFY(canRestoreFragments(wall(), {seed(3)}));
        m_document.push(restoreFragments(m_document.project(), kWall, {inner}, "3.3"));
        QVERIFY(wall().edits.empty());
    }
    void duplicatedPatternsKeepCommonLayers() {
        m_document.push(addLevel(m_document.project(), kWall));
        Asset asset = wall();
        moveSeed(ownPattern(asset, "3.1"), {asset.levels[0].pattern.layers[0].id, 0}, {0.0, 0.1});
        m_document.push(modify("Move Seed", std::move(asset)));
        Addition copy = duplicateAsset(m_document.project(), kWall);
        const Id id = copy.id;
        m_document.push(std::move(copy.edit));
        const Asset& copied = *findAsset(m_document.project(), id);
        QVERIFY(copied.levels[0].pattern.layers[0].id != wall().levels[0].pattern.layers[0].id);
        QCOMPARE(copied.fragmentLevels[0].level->pattern.layers[0].id, copied.levels[0].pattern.layers[0].id);
    }
    void duplicateRenamesItsFragments() {
        m_document.push(fractureFragments(m_document.project(), kWall, pieces({seed(1)})));
        m_document.push(mergeFragments(m_document.project(), kWall, pieces({seed(2), seed(3)})));
        Asset asset = wall();
        setFragmentThreshold(asset, "3.1", 2.5);
        setNeverBreaks(asset, "3.0", true);
        m_document.push(modify("Set Threshold", std::move(asset)));
        Addition copy = duplicateAsset(m_document.project(), kWall);
        const Id id = copy.id;
        m_document.push(std::move(copy.edit));
        const Asset& copied = *findAsset(m_document.project(), id);
        const std::string layer = std::to_string(copied.pattern.layers[0].id);
        QVERIFY(layer != "3");
        QCOMPARE(copied.fragmentThresholds, (std::vector<FragmentThreshold>{{layer + ".1", 2.5}}));
        QCOMPARE(copied.bonding.neverBreaks, std::vector<FragmentPath>{layer + ".0"});
        QCOMPARE(copied.fragmentLevels[0].fragment, layer + ".1");
        QCOMPARE(std::get<FragmentMerge>(copied.edits[0]).into, layer + ".3");
        QCOMPARE(bake(copied)->fragmentCount(), bake(wall())->fragmentCount());
    }
};

RUBBLE_TEST_WITH(FragmentEditsTest, QCoreApplication)
#include "FragmentEditsTest.moc"
