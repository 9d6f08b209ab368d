#include "editor/commands/FragmentEdits.h"

#include "core/asset/Bake.h"
#include "core/asset/Breaking.h"
#include "core/asset/FragmentPlace.h"
#include "core/fracture/SeedEdits.h"
#include "core/io/ProjectFile.h"
#include "editor/commands/PatternPlaces.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/Document.h"
#include "tests/support/ProjectParts.h"
#include "tests/support/Projects.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <map>

using namespace rubble;

namespace {

/// A square of a metre in four columns, 5.0 to 5.3, of which the last is the broadest.
Project columns() {
    Project project;
    const Id stone = test::addMaterial(project, {.name = "stone"});
    test::addAsset(project, {.name = "wall", .material = stone, .prism = {unitSquare(), 0.5}},
                   {PlacedSeeds{{{0, {0.1, 0.5}}, {1, {0.3, 0.5}}, {2, {0.5, 0.5}}, {3, {0.7, 0.5}}}}});
    return project;
}

constexpr Id kWall = 2;
constexpr Id kLayer = 3;

/// The pieces of some seeds as the pattern has them now.
std::vector<ChosenPiece> chosen(const Project& project, const std::set<SeedId>& seeds) {
    const Asset& asset = *findAsset(project, kWall);
    const PlaneBreaking cut = *cutBy(recipeOf(asset), asset.prism, {});
    return chosenPieces(cut.partition, cut.seeds, seeds);
}

/// The same inside a fragment.
std::vector<ChosenPiece> chosenInside(const Project& project, const FragmentPath& fragment,
                                      const std::set<SeedId>& seeds) {
    const Bake baked = *bake(*findAsset(project, kWall));
    const std::uint32_t number = *fragmentAt(baked, fragment);
    const BakedBreaking& breaking = *baked.breakingOf(number);
    return chosenPieces(breaking.fragments.partition, breaking.seeds, seeds, fragment,
                        Vec2{baked.fragment(number).solid.offset()});
}

/// The ids of all fragments, and their outlines.
std::map<std::string, Polygon> outlinesOf(const Asset& asset) {
    const Bake baked = *bake(asset);
    std::map<std::string, Polygon> outlines;
    for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k)
        outlines[baked.fragmentId(k)] = baked.fragment(k).solid.outline();
    return outlines;
}

SeedId seed(std::uint32_t index) { return {kLayer, index}; }

}  // namespace

/// Each edit does what it says, leaves a project without fault, and is undone to the last byte.
class FragmentEditsTest : public QObject {
    Q_OBJECT

    Document m_document{columns()};
    const std::string m_before = projectText(columns());
    const Asset& wall() const { return *findAsset(m_document.project(), kWall); }
    std::vector<ChosenPiece> pieces(const std::set<SeedId>& seeds) const { return chosen(m_document.project(), seeds); }
    std::vector<FragmentPath> paths() const {
        std::vector<FragmentPath> paths;
        for (const ChosenPiece& piece : pieces({seed(0), seed(1), seed(2), seed(3)})) paths.push_back(piece.path);
        std::ranges::sort(paths);
        return paths;
    }

private slots:
    void cleanup() {
        QCOMPARE(verifyProject(m_document.project()).value_or(""), std::string());
        while (m_document.undoStack().canUndo()) m_document.undoStack().undo();
        QCOMPARE(projectText(m_document.project()), m_before);
    }
    void chosenPiecesAreMeasured() {
        const std::vector<ChosenPiece> last = pieces({seed(3)});
        QCOMPARE(last.size(), std::size_t{1});
        QCOMPARE(last[0].path, FragmentPath("3.3"));
        QVERIFY(std::abs(last[0].area - 0.4) < 1e-12);
        QVERIFY(std::abs(last[0].across.direction.y) < 1e-9);  // it is higher than broad
    }
    void mergingNamesTheLargest() {
        m_document.push(mergeFragments(m_document.project(), kWall, pieces({seed(2), seed(3)})));
        QVERIFY(std::get<FragmentMerge>(wall().edits[0]) == (FragmentMerge{"3.3", {"3.2"}}));
        QCOMPARE(paths(), (std::vector<FragmentPath>{"3.0", "3.1", "3.3"}));
    }
    void splittingGivesTwo() {
        m_document.push(splitFragments(m_document.project(), kWall, pieces({seed(1)})));
        QCOMPARE(paths(), (std::vector<FragmentPath>{"3.0", "3.1.0", "3.1.1", "3.2", "3.3"}));
        const std::vector<ChosenPiece> halves = pieces({seed(1)});
        QVERIFY(std::abs(halves[0].area - halves[1].area) < 1e-9);
    }
    void fracturingAgainAndKeepingWhole() {
        m_document.push(fractureFragments(m_document.project(), kWall, pieces({seed(1), seed(2)})));
        QCOMPARE(wall().leaves.size(), std::size_t{2});
        QVERIFY(wall().leaves[0].level && wall().leaves[0].level->pattern.layers.size() == 1);
        const Pattern first = wall().leaves[0].level->pattern;
        m_document.push(fractureFragments(m_document.project(), kWall, pieces({seed(1)})));
        QVERIFY(wall().leaves[0].level->pattern == first);  // it had one
        QCOMPARE(patternCount(wall()), std::size_t{3});
        QCOMPARE(placeText(wall(), 2), QString("Fragment 3.2"));
        QCOMPARE(depthAt(wall(), 2), std::size_t{1});
        m_document.push(addLayer(m_document.project(), kWall, BlueNoise{}, 2).edit);
        QCOMPARE(patternAt(wall(), 2)->layers.size(), std::size_t{2});

        m_document.push(keepFragmentsWhole(m_document.project(), kWall, pieces({seed(1)})));
        QVERIFY(!wall().leaves[0].level);
        QVERIFY(patternAt(wall(), 1) == nullptr);
        QCOMPARE(placeText(wall(), 1), QString("Fragment 3.1, stays whole"));
    }
    void restoringTakesBackWhatIsOfTheseSeeds() {
        m_document.push(mergeFragments(m_document.project(), kWall, pieces({seed(2), seed(3)})));
        m_document.push(splitFragments(m_document.project(), kWall, pieces({seed(0)})));
        m_document.push(keepFragmentsWhole(m_document.project(), kWall, pieces({seed(1)})));
        QVERIFY(areRestorable(wall(), {seed(2)}));
        m_document.push(restoreFragments(m_document.project(), kWall, {seed(3), seed(1)}));
        QCOMPARE(wall().edits.size(), std::size_t{1});
        QVERIFY(wall().leaves.empty());
        QVERIFY(!areRestorable(wall(), {seed(3)}));
        QVERIFY(areRestorable(wall(), {seed(0)}));
    }
    void aPatternOfItsOwnBreaksAFragmentAsItsLevelDid() {
        m_document.push(addLevel(m_document.project(), kWall));
        m_document.push(addLevel(m_document.project(), kWall));
        Asset asset = wall();
        asset.levels[0].minimumVolume = 0.001;
        const auto before = outlinesOf(asset);
        QCOMPARE(placeFor(asset, "3.1"), std::size_t{1});
        QVERIFY(!hasOwnPattern(asset, "3.1"));

        Pattern& own = ownPattern(asset, "3.1");
        QVERIFY(hasOwnPattern(asset, "3.1"));
        QCOMPARE(placeFor(asset, "3.1"), std::size_t{3});
        QVERIFY(own == asset.levels[0].pattern);
        QCOMPARE(asset.leaves[0].level->minimumVolume, 0.001);
        QVERIFY(&ownPattern(asset, "3.1") == &own);  // it has one
        QVERIFY(outlinesOf(asset) == before);        // also those of pieces of its pieces

        moveSeed(own, {own.layers[0].id, 0}, {0.01, 0.02});
        const auto after = outlinesOf(asset);
        for (const auto& [id, outline] : before) {
            if (!isWithin(pathOfId(id), "3.1")) QVERIFY2(after.contains(id) && after.at(id) == outline, id.c_str());
        }
        QVERIFY(after != before);
        m_document.push(altered("Move seed", std::move(asset)));  // cleanup() verifies it
    }
    void aFragmentOfAFragmentGetsAPatternOfItsOwnInPlace() {
        Asset asset = wall();
        asset.levels = {Level{}};
        QVERIFY(&ownPattern(asset, {}) == &asset.pattern);
        ownPattern(asset, "3.1/9.0");
        ownPattern(asset, "3.0");
        ownPattern(asset, "3.1");
        QVERIFY(std::ranges::is_sorted(asset.leaves, {}, &FragmentLevel::fragment));
        QVERIFY(ownPattern(asset, "3.1/9.0").layers.empty());  // there is no second level
        QCOMPARE(placeFor(asset, "3.3/9.0"), std::size_t{0});
    }
    void piecesInsideAFragmentAreNamedAndStandWhereTheyAre() {
        m_document.push(addLevel(m_document.project(), kWall));
        const SeedId inner{wall().levels[0].pattern.layers[0].id, 0};
        const std::vector<ChosenPiece> one = chosenInside(m_document.project(), "3.3", {inner});
        QCOMPARE(one.size(), std::size_t{1});
        QCOMPARE(one[0].path, FragmentPath("3.3/" + inner.text()));
        const Bake before = *bake(wall());
        const Vec2 centre{before.fragment(*fragmentAt(before, one[0].path)).solid.offset()};
        QVERIFY(glm::distance(centre, one[0].across.point) < 1e-12);
        m_document.push(splitFragments(m_document.project(), kWall, one));
        const Bake baked = *bake(wall());
        QVERIFY(fragmentAt(baked, one[0].path + ".0") && fragmentAt(baked, one[0].path + ".1"));
        QVERIFY(areRestorable(wall(), {inner}, "3.3"));
        QVERIFY(!areRestorable(wall(), {inner}, "3.2"));
        QVERIFY(!areRestorable(wall(), {{inner.layer, 1}}, "3.3"));
        QVERIFY(areRestorable(wall(), {seed(3)}));
        m_document.push(restoreFragments(m_document.project(), kWall, {inner}, "3.3"));
        QVERIFY(wall().edits.empty());
    }
    void whatACopysPatternsHaveInCommonStaysSo() {
        m_document.push(addLevel(m_document.project(), kWall));
        Asset asset = wall();
        moveSeed(ownPattern(asset, "3.1"), {asset.levels[0].pattern.layers[0].id, 0}, {0.0, 0.1});
        m_document.push(altered("Move seed", std::move(asset)));
        Addition copy = duplicateAsset(m_document.project(), kWall);
        const Id id = copy.id;
        m_document.push(std::move(copy.edit));
        const Asset& copied = *findAsset(m_document.project(), id);
        QVERIFY(copied.levels[0].pattern.layers[0].id != wall().levels[0].pattern.layers[0].id);
        QCOMPARE(copied.leaves[0].level->pattern.layers[0].id, copied.levels[0].pattern.layers[0].id);
    }
    void aCopyKnowsItsFragmentsByItsOwnLayers() {
        m_document.push(fractureFragments(m_document.project(), kWall, pieces({seed(1)})));
        m_document.push(mergeFragments(m_document.project(), kWall, pieces({seed(2), seed(3)})));
        Addition copy = duplicateAsset(m_document.project(), kWall);
        const Id id = copy.id;
        m_document.push(std::move(copy.edit));
        const Asset& copied = *findAsset(m_document.project(), id);
        const std::string layer = std::to_string(copied.pattern.layers[0].id);
        QVERIFY(layer != "3");
        QCOMPARE(copied.leaves[0].fragment, layer + ".1");
        QCOMPARE(std::get<FragmentMerge>(copied.edits[0]).into, layer + ".3");
        QCOMPARE(bake(copied)->fragmentCount(), bake(wall())->fragmentCount());
    }
};

QTEST_GUILESS_MAIN(FragmentEditsTest)
#include "FragmentEditsTest.moc"
