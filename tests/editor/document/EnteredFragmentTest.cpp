#include "editor/document/EnteredFragment.h"

#include "core/asset/bake/FragmentLookup.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

namespace {

/// Two halves, fractured into two columns each by a level, and these by another one.
Asset halves() {
    Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
    const Slices once{.cuts = 1, .offsetVariation = 0.0, .angleVariation = 0.0};
    asset.levels = {{.pattern = {{{.id = 6, .parameters = once}}}}, {.pattern = {{{.id = 7, .parameters = once}}}}};
    return asset;
}

struct Desk {
    explicit Desk(const Asset& asset) {
        project.assets = {asset};
        selection.setAsset(asset.id);
        bakeAsset();
    }
    Asset& asset() { return project.assets[0]; }
    void bakeAsset() {
        auto baked = std::make_shared<BakedAsset>();
        baked->asset = std::make_shared<const Asset>(asset());
        Result<Bake> made = bake(asset());
        if (made) baked->bake = std::make_shared<const Bake>(std::move(*made));
        if (!made) baked->fault = made.error();
        bakes.set(asset().id, baked);
    }
    const Bake& bakeNow() const { return *bakes.find(3)->bake; }
    void exitRemoved() { exitRemovedFragments(selection, project, bakes); }

    Project project;
    Selection selection;
    Bakes bakes;
};

}  // namespace

class EnteredFragmentTest : public QObject {
    Q_OBJECT
private slots:
    void fragmentSolidHasItsOwnFrame() {
        Desk desk(halves());
        const std::optional<FragmentSolid> half = fragmentSolid(desk.bakes, 3, "5.1");
        QVERIFY(half);
        QCOMPARE(half->prism.depth, 0.5);
        QVERIFY(std::abs(half->offset.x - 0.75) < 1e-12 && std::abs(half->offset.y - 0.5) < 1e-12);
        const Box2 box = boundsOf(half->prism.outline.outer);
        QVERIFY(std::abs(box.min.x + 0.25) < 1e-12 && std::abs(box.max.y - 0.5) < 1e-12);
        QVERIFY(!fragmentSolid(desk.bakes, 3, "5.2"));
        QVERIFY(!fragmentSolid(desk.bakes, 3, {}));
        QVERIFY(!fragmentSolid(desk.bakes, 4, "5.1"));

        const Asset whole = fragmentAsAsset(desk.asset(), "5.1", half->prism);
        QVERIFY(whole.pattern == desk.asset().levels[0].pattern);
        QVERIFY(whole.prism() == half->prism);
    }
    void failedBakeKeepsTheLastSolid() {
        Desk desk(halves());
        const FragmentSolid half = *fragmentSolid(desk.bakes, 3, "5.1");
        auto seen = std::make_shared<BakedPattern>();
        seen->asset = std::make_shared<const Asset>(fragmentAsAsset(desk.asset(), "5.1", half.prism));
        seen->parent = "5.1";
        seen->offset = half.offset;
        desk.bakes.setPattern(3, seen);
        QVERIFY(!desk.bakes.findPattern(3));  // it is not the whole asset's
        QCOMPARE(desk.bakes.findPattern(3, "5.1"), seen);
        QVERIFY(!desk.bakes.findPattern(3, "5.0"));

        desk.asset().prism().depth = -1.0;
        desk.bakeAsset();
        QVERIFY(!desk.bakes.find(3)->bake);
        const std::optional<FragmentSolid> kept = fragmentSolid(desk.bakes, 3, "5.1");
        QVERIFY(kept && kept->prism == half.prism && kept->offset == half.offset);
        desk.selection.setEnteredFragment("5.1");
        desk.exitRemoved();
        QCOMPARE(desk.selection.enteredFragment(), FragmentPath("5.1"));
        desk.bakes.remove(3);
        QVERIFY(!fragmentSolid(desk.bakes, 3, "5.1"));
    }
    void nearestFracturedIsAnExistingAncestor() {
        Desk desk(halves());
        const auto nearest = [&](const char* path) { return nearestFractured(desk.asset(), &desk.bakeNow(), path); };
        const FragmentPath inner = desk.bakeNow().fragmentPath(desk.bakeNow().fractureOf(0)->first);
        QCOMPARE(nearest("5.1"), FragmentPath("5.1"));
        QCOMPARE(nearest(inner.c_str()), inner);
        QCOMPARE(nearest((inner + "/7.0").c_str()), inner);  // there is no third level
        QCOMPARE(nearest("5.7/6.0"), FragmentPath());
        desk.asset().fragmentLevels = {{"5.1", std::nullopt}};  // kept whole
        QCOMPARE(nearest("5.1"), FragmentPath());
        desk.asset().fragmentLevels.clear();
        desk.asset().levels[0].minimumVolume = 0.3;
        QCOMPARE(nearest("5.1"), FragmentPath());
    }
    void exitSelectsTheFragmentThatWasLeft() {
        Desk desk(halves());
        desk.selection.setSeeds({{5, 1}});
        enterFragment(desk.selection, "5.1/6.0");
        QVERIFY(desk.selection.fragments().isEmpty());
        exitToFragment(desk.selection, "5.1");
        QCOMPARE(desk.selection.enteredFragment(), FragmentPath("5.1"));
        QVERIFY((desk.selection.fragments() == FragmentSelection{{{6, 0}}, std::nullopt, "5.1"}));
        enterFragment(desk.selection, "5.1/6.0");
        exitToFragment(desk.selection, {});
        QVERIFY((desk.selection.fragments() == FragmentSelection{{{5, 1}}, std::nullopt}));
        exitToFragment(desk.selection, {});  // already exited
        QVERIFY((desk.selection.fragments() == FragmentSelection{{{5, 1}}, std::nullopt}));
        enterFragment(desk.selection, "5.1.2");
        exitToFragment(desk.selection, {});
        QVERIFY((desk.selection.fragments() == FragmentSelection{{{5, 1}}, FragmentSelection::Ids{"3/5.1.2"}}));
    }
    void removedFragmentIsExited() {
        Desk desk(halves());
        enterFragment(desk.selection, "5.1/6.0");
        desk.exitRemoved();
        QCOMPARE(desk.selection.enteredFragment(), FragmentPath("5.1/6.0"));
        desk.asset().levels.pop_back();  // not baked yet
        desk.exitRemoved();
        QCOMPARE(desk.selection.enteredFragment(), FragmentPath("5.1"));
        std::get<PlacedSeeds>(desk.asset().pattern.layers[0].parameters).seeds.pop_back();
        desk.exitRemoved();  // it exists until the next bake
        QCOMPARE(desk.selection.enteredFragment(), FragmentPath("5.1"));
        desk.selection.setSeeds({{6, 0}});
        desk.bakeAsset();
        desk.exitRemoved();
        QCOMPARE(desk.selection.enteredFragment(), FragmentPath());
        QVERIFY(desk.selection.fragments().isEmpty());
    }
};

RUBBLE_TEST_WITH(EnteredFragmentTest, QCoreApplication)
#include "EnteredFragmentTest.moc"
