#include "viewport/scene/Take.h"

#include "tests/support/Sessions.h"

using namespace rubble;

namespace {

const ShotInput kThrow{"throw", test::throwAtBlock(3.0, 80.0)};

Take takeOf(std::vector<TimedInput> inputs) {
    const auto scene = test::playSceneOf(test::floatingBlock());
    return Take(scene, Session::start(scene).value(), std::move(inputs));
}

}  // namespace

class TakeTest : public QObject {
    Q_OBJECT
private slots:
    void goesOnToMoments() {
        Take take = takeOf({{3, kThrow}});
        QVERIFY(take.momentAfter(3).hasValue());
        QCOMPARE(test::countOf(take.session(), PlayRole::Missile), 0u);
        QVERIFY(take.momentAfter(4).hasValue());
        QCOMPARE(test::countOf(take.session(), PlayRole::Missile), 1u);
        QVERIFY(take.momentAfter(200).hasValue());
        QCOMPARE(take.session().stepsDone(), 200u);
        QVERIFY(test::countOf(take.session(), PlayRole::Piece) > 1);
    }
    void inputsComeWhenTheyDidInPlay() {
        Take take = takeOf({{0, kThrow}, {7, GravityInput{{0.0, -9.0, 0.0}}}});
        QVERIFY(take.momentAfter(40).hasValue());
        Session session = test::sessionOf(test::floatingBlock());
        test::give(session, kThrow);
        for (int step = 0; step < 40; ++step) {
            if (step == 7) test::give(session, GravityInput{{0.0, -9.0, 0.0}});
            session.step();
        }
        QCOMPARE(take.session().hash(), session.hash());
    }
    void aMomentKnowsWhereThingsWereAStepBefore() {
        Take take = takeOf({{0, kThrow}});
        for (const std::uint64_t step : {5u, 80u}) {
            const auto moment = take.momentAfter(step);
            QCOMPARE((*moment)->earlier.size(), (*moment)->motions.size());
        }
    }
    void theSameMomentMayBeAskedForAgain() {
        Take take = takeOf({});
        const auto first = take.momentAfter(5);
        QCOMPARE((*take.momentAfter(5))->motions, (*first)->motions);
    }
    void whatCannotBeFollowedIsLeftOutAndTold() {
        Take take = takeOf({{2, GrabInput{.body = 77, .force = 1.0}}, {3, kThrow}});
        QVERIFY(take.momentAfter(5).hasValue());
        QCOMPARE(take.takeNotices(), std::vector<std::string>{"There is no body 77 to take hold of."});
        QVERIFY(take.takeNotices().empty());
        QCOMPARE(test::countOf(take.session(), PlayRole::Missile), 1u);
    }
    void itIsCancelled() {
        Take take = takeOf({});
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(take.momentAfter(5, task).error().code, ErrorCode::Cancelled);
        QCOMPARE(take.session().stepsDone(), 0u);
    }
};

QTEST_APPLESS_MAIN(TakeTest)
#include "TakeTest.moc"
