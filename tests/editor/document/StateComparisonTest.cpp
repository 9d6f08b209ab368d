#include "editor/document/StateComparison.h"

#include "core/fracture/SeedEdits.h"
#include "editor/commands/ProjectEdits.h"
#include "tests/support/Projects.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

constexpr int kPatience = 60000;  // ms, for baking on a busy machine

/// Two boxes of scattered seeds.
Project boxes() {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, UniformScatter{8}), boxAsset(4, 5, UniformScatter{12})};
    project.assets[1].name = "pillar";
    return project;
}

/// A document whose first asset is at hand, as a window has it.
struct Desk {
    Document document{boxes()};
    Selection selection;
    Bakes bakes;
    StateComparison comparison{document, selection, bakes};

    Desk() {
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
    /// Moves the first seed of the asset at hand, and does not bake it.
    void moveASeed() {
        Asset asset = *findAsset(document.project(), selection.asset());
        moveSeed(asset.pattern, {asset.pattern.layers[0].id, 0}, {0.1, 0.2});
        document.push(altered("Move seed", std::move(asset)));
    }
    void begin(Project earlier) {
        comparison.begin(std::make_shared<const Project>(std::move(earlier)), "an earlier state");
    }
    const ComparedAsset* compared() const { return comparison.asset().get(); }
};

}  // namespace

/// An asset at hand against an earlier state of its project, in the background.
class StateComparisonTest : public QObject {
    Q_OBJECT
private slots:
    void nothingIsComparedBeforeItIsBegun() {
        Desk desk;
        desk.bakeAll();
        QTest::qWait(50);  // it would have begun
        QVERIFY(!desk.comparison.isOn() && !desk.compared());
    }
    void theSameStateHasNoDifference() {
        Desk desk;
        desk.begin(boxes());
        QVERIFY(desk.comparison.isOn());
        QCOMPARE(desk.comparison.name(), QString("an earlier state"));
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        QVERIFY(desk.compared()->isNone() && desk.compared()->wasThere);
        QVERIFY(desk.compared()->before->input == desk.compared()->after->input);
    }
    void itFollowsEditsOnceTheyAreBaked() {
        Desk desk;
        desk.begin(boxes());
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        const auto before = desk.compared()->before;
        desk.moveASeed();
        QVERIFY(desk.compared()->isNone());  // as long as it is not baked
        desk.bakeAll();
        QTRY_VERIFY_WITH_TIMEOUT(!desk.compared()->isNone(), kPatience);
        QCOMPARE(desk.compared()->recipe.size(), std::size_t{1});
        QVERIFY(!desk.compared()->pieces.pieces.empty());
        QVERIFY(desk.compared()->before == before);  // the earlier state is baked once
        desk.document.undoStack().undo();
        desk.bakeAll();
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared()->isNone(), kPatience);
    }
    void aPieceThatIsGoneIsTold() {
        Desk desk;
        Project earlier = boxes();
        earlier.assets[0].pattern.layers[0].parameters = UniformScatter{9};
        desk.begin(std::move(earlier));
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        const auto& pieces = desk.compared()->pieces.pieces;
        QCOMPARE(std::ranges::count(pieces, kNone, &PieceDifference::after), std::ptrdiff_t{1});
        QCOMPARE(desk.compared()->before->fragmentCount(), 9u);
        QCOMPARE(desk.compared()->after->fragmentCount(), 8u);
    }
    void anotherAssetAtHandIsComparedInItsPlace() {
        Desk desk;
        desk.begin(boxes());
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        QSignalSpy changed(&desk.comparison, &StateComparison::changed);
        desk.selection.setAsset(4);
        QVERIFY(!desk.compared());  // what is shown is never of another asset
        QCOMPARE(changed.count(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        QCOMPARE(desk.compared()->after->asset, Id{4});
        QCOMPARE(desk.compared()->before->asset, Id{4});
    }
    void anAssetThatWasNotThereHasNothingToCompare() {
        Desk desk;
        Project earlier = boxes();
        earlier.assets.erase(earlier.assets.begin());
        desk.begin(std::move(earlier));
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        QVERIFY(!desk.compared()->wasThere && !desk.compared()->before && !desk.compared()->isNone());
        QVERIFY(desk.compared()->recipe.empty() && desk.compared()->pieces.pieces.empty());
    }
    void aRenamedAssetIsFoundByItsId() {
        Desk desk;
        Project earlier = boxes();
        earlier.assets[0].name = "wall of old";
        desk.begin(std::move(earlier));
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        QVERIFY(desk.compared()->wasThere && desk.compared()->pieces.isNone());
    }
    void anEarlierStateThatCannotBeBrokenIsTold() {
        Desk desk;
        Project earlier = boxes();
        earlier.assets[0].prism.depth = -1.0;
        QSignalSpy said(&desk.comparison, &StateComparison::said);
        desk.begin(std::move(earlier));
        QTRY_COMPARE_WITH_TIMEOUT(said.count(), 1, kPatience);
        QVERIFY(said[0][0].toString().contains("depth is -1"));
        QVERIFY(!desk.compared());
    }
    void endingForgetsIt() {
        Desk desk;
        desk.begin(boxes());
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        QSignalSpy changed(&desk.comparison, &StateComparison::changed);
        desk.comparison.end();
        desk.comparison.end();
        QCOMPARE(changed.count(), 1);
        QVERIFY(!desk.comparison.isOn() && !desk.compared());
        desk.moveASeed();
        desk.bakeAll();
        QTest::qWait(50);  // it would have followed
        QVERIFY(!desk.compared());
    }
    void whatWasBegunLaterIsWhatIsShown() {
        Desk desk;
        QSignalSpy said(&desk.comparison, &StateComparison::said);
        Project first = boxes();
        first.assets[0].pattern.layers[0].parameters = UniformScatter{2000};
        desk.begin(std::move(first));
        desk.begin(boxes());  // while the other is being baked
        QTRY_VERIFY_WITH_TIMEOUT(desk.compared(), kPatience);
        QVERIFY(desk.compared()->isNone());
        QVERIFY(said.isEmpty());  // that the other was given up is nobody's business
    }
    void itCanGoWhileItBakes() {
        Desk desk;
        Project earlier = boxes();
        earlier.assets[0].pattern.layers[0].parameters = UniformScatter{20000};
        desk.begin(std::move(earlier));
    }
};

QTEST_GUILESS_MAIN(StateComparisonTest)
#include "StateComparisonTest.moc"
