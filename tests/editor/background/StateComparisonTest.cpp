// Tests editor/background/StateComparison.cpp and editor/background/ComparedAsset.cpp.
#include "editor/background/StateComparison.h"

#include "core/fracture/pattern/SeedEdits.h"
#include "editor/commands/ProjectEdits.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// Two boxes of scattered seeds.
Project boxes() {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, UniformScatter{8}), boxAsset(4, 5, UniformScatter{12})};
    project.assets[1].name = "pillar";
    return project;
}

/// A document whose first asset is active.
struct Fixture {
    Document document{boxes()};
    Selection selection;
    Bakes bakes;
    StateComparison comparison{document, selection, bakes};

    Fixture() {
        selection.setAsset(2);
        bakeAll();
    }
    void bakeAll() {
        for (const Asset& asset : document.project().assets) {
            const auto made = std::make_shared<const Bake>(*bake(asset));
            bakes.set(asset.id, std::make_shared<const BakedAsset>(
                                    BakedAsset{.asset = std::make_shared<const Asset>(asset), .bake = made}));
        }
    }
    /// Moves the first seed of the active asset without baking it.
    void moveSeed() {
        Asset asset = *findAsset(document.project(), selection.asset());
        rubble::moveSeed(asset.pattern, {asset.pattern.layers[0].id, 0}, {0.1, 0.2});
        document.push(modify("Move seed", std::move(asset)));
    }
    void begin(Project earlier) {
        comparison.begin(std::make_shared<const Project>(std::move(earlier)), "an earlier state");
    }
    const ComparedAsset* compared() const { return comparison.value().get(); }
};

}  // namespace

class StateComparisonTest : public QObject {
    Q_OBJECT
private slots:
    void isOffAtFirst() {
        Fixture fixture;
        fixture.bakeAll();
        QCoreApplication::processEvents();
        QVERIFY(!fixture.comparison.isOn() && !fixture.compared());
    }
    void equalStatesHaveNoDifference() {
        Fixture fixture;
        fixture.begin(boxes());
        QVERIFY(fixture.comparison.isOn());
        QCOMPARE(fixture.comparison.name(), QString("an earlier state"));
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        QVERIFY(fixture.compared()->isEmpty() && fixture.compared()->existedBefore);
        QVERIFY(fixture.compared()->before->input == fixture.compared()->after->input);
    }
    void updatesAfterEditsAreBaked() {
        Fixture fixture;
        fixture.begin(boxes());
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        const auto before = fixture.compared()->before;
        fixture.moveSeed();
        QVERIFY(fixture.compared()->isEmpty());  // until it is baked
        fixture.bakeAll();
        QTRY_VERIFY_WITH_TIMEOUT(!fixture.compared()->isEmpty(), kPatience);
        QCOMPARE(fixture.compared()->recipe.size(), std::size_t{1});
        QVERIFY(!fixture.compared()->fragments.fragments.empty());
        QVERIFY(fixture.compared()->before == before);  // the earlier state is baked once
        fixture.document.undoStack().undo();
        fixture.bakeAll();
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared()->isEmpty(), kPatience);
    }
    void reportsRemovedFragments() {
        Fixture fixture;
        Project earlier = boxes();
        earlier.assets[0].pattern.layers[0].parameters = UniformScatter{9};
        fixture.begin(std::move(earlier));
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        const auto& pieces = fixture.compared()->fragments.fragments;
        QCOMPARE(std::ranges::count(pieces, kNone, &FragmentDifference::after), std::ptrdiff_t{1});
        QCOMPARE(fixture.compared()->before->fragmentCount(), 9u);
        QCOMPARE(fixture.compared()->after->fragmentCount(), 8u);
    }
    void comparesTheNewActiveAsset() {
        Fixture fixture;
        fixture.begin(boxes());
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        QSignalSpy changed(&fixture.comparison, &StateComparison::changed);
        fixture.selection.setAsset(4);
        QVERIFY(!fixture.compared());  // never the result of another asset
        QCOMPARE(changed.count(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        QCOMPARE(fixture.compared()->after->asset, Id{4});
        QCOMPARE(fixture.compared()->before->asset, Id{4});
    }
    void newAssetHasNoEarlierState() {
        Fixture fixture;
        Project earlier = boxes();
        earlier.assets.erase(earlier.assets.begin());
        fixture.begin(std::move(earlier));
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        QVERIFY(!fixture.compared()->existedBefore && !fixture.compared()->before && !fixture.compared()->isEmpty());
        QVERIFY(fixture.compared()->recipe.empty() && fixture.compared()->fragments.fragments.empty());
    }
    void matchesRenamedAssetsById() {
        Fixture fixture;
        Project earlier = boxes();
        earlier.assets[0].name = "wall of old";
        fixture.begin(std::move(earlier));
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        QVERIFY(fixture.compared()->existedBefore && fixture.compared()->fragments.isEmpty());
    }
    void reportsWhenTheEarlierStateCannotBeBaked() {
        Fixture fixture;
        Project earlier = boxes();
        earlier.assets[0].prism().depth = -1.0;
        QSignalSpy messages(&fixture.comparison, &StateComparison::failed);
        fixture.begin(std::move(earlier));
        QTRY_COMPARE_WITH_TIMEOUT(messages.count(), 1, kPatience);
        QVERIFY(messages[0][0].toString().contains("depth is -1"));
        QVERIFY(!fixture.compared());
    }
    void endDiscardsTheResult() {
        Fixture fixture;
        fixture.begin(boxes());
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        QSignalSpy changed(&fixture.comparison, &StateComparison::changed);
        fixture.comparison.end();
        fixture.comparison.end();
        QCOMPARE(changed.count(), 1);
        QVERIFY(!fixture.comparison.isOn() && !fixture.compared());
        fixture.moveSeed();
        fixture.bakeAll();
        QCoreApplication::processEvents();
        QVERIFY(!fixture.compared());
        fixture.begin(boxes());  // on the same thread, after whatever was begun before
        QTRY_VERIFY(fixture.compared());
        QVERIFY(!fixture.compared()->isEmpty());
    }
    void laterBeginReplacesTheFirst() {
        Fixture fixture;
        QSignalSpy messages(&fixture.comparison, &StateComparison::failed);
        Project first = boxes();
        first.assets[0].pattern.layers[0].parameters = UniformScatter{2000};
        fixture.begin(std::move(first));
        fixture.begin(boxes());  // while the first is being baked
        QTRY_VERIFY_WITH_TIMEOUT(fixture.compared(), kPatience);
        QVERIFY(fixture.compared()->isEmpty());
        QVERIFY(messages.isEmpty());  // the cancelled one reports nothing
    }
    void canBeDestroyedWhileBaking() {
        Fixture fixture;
        Project earlier = boxes();
        earlier.assets[0].pattern.layers[0].parameters = UniformScatter{20000};
        fixture.begin(std::move(earlier));
    }
};

RUBBLE_TEST_WITH(StateComparisonTest, QCoreApplication)
#include "StateComparisonTest.moc"
