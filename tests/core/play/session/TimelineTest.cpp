#include "core/play/session/Timeline.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <map>
#include <random>

using namespace rubble;

namespace {

Timeline timelineOf(const Project& project) { return Timeline(test::sessionOf(project)); }

void play(Timeline& timeline, int steps) {
    for (int k = 0; k < steps; ++k) {
        if (const Status played = timeline.step(); !played) qFatal("%s", played.error().message.c_str());
    }
}

void seek(Timeline& timeline, std::uint64_t step) {
    if (const Status gone = timeline.seek(step); !gone) qFatal("%s", gone.error().message.c_str());
}

ShotInput throwIt(double speed) { return {"throw", test::throwAtBlock(3.0, speed)}; }

}  // namespace

class TimelineTest : public QObject {
    Q_OBJECT
private slots:
    void seeksBackToEveryStep() {
        Timeline timeline = timelineOf(test::floatingBlock());
        std::vector<ContentHash> hashes{timeline.session().hash()};
        for (int step = 0; step < 200; ++step) {
            if (step % 50 == 10) QVERIFY(timeline.add(throwIt(20.0 + step)).hasValue());
            play(timeline, 1);
            hashes.push_back(timeline.session().hash());
        }
        std::mt19937 random(7);
        qInfo("seed 7");
        for (int k = 0; k < 60; ++k) {
            const std::uint64_t step = random() % 201;
            seek(timeline, step);
            QCOMPARE(timeline.session().stepsDone(), step);
            QCOMPARE(timeline.session().hash(), hashes[step]);
            QCOMPARE(timeline.length(), 200u);
        }
    }
    void startingOverKeepsTheCourse() {
        Timeline timeline = timelineOf(test::floatingBlock());
        const ContentHash start = timeline.session().hash();
        play(timeline, 20);
        timeline.startOver();  // nothing was thrown: it will be the same again
        QVERIFY(timeline.branches().empty());
        play(timeline, 10);
        QVERIFY(timeline.add(throwIt(30.0)).hasValue());
        play(timeline, 40);
        const ContentHash thrown = timeline.session().hash();
        timeline.startOver();
        QCOMPARE(timeline.session().stepsDone(), 0u);
        QCOMPARE(timeline.session().hash(), start);
        QVERIFY(timeline.inputs().empty() && timeline.isAtEnd());
        QCOMPARE(timeline.branches().size(), std::size_t{1});
        play(timeline, 50);
        QVERIFY(timeline.session().hash() != thrown);
        QVERIFY(timeline.switchTo(timeline.branches()[0].id).hasValue());
        seek(timeline, 50);
        QCOMPARE(timeline.session().hash(), thrown);
    }
    void playsRecordedAndNewSteps() {
        Timeline straight = timelineOf(test::floatingBlock()), scrubbed = timelineOf(test::floatingBlock());
        for (Timeline* timeline : {&straight, &scrubbed}) {
            play(*timeline, 30);
            QVERIFY(timeline->add(throwIt(30.0)).hasValue());
        }
        seek(scrubbed, 5);  // the throw was reported, and never came to pass
        QVERIFY(!scrubbed.isAtEnd());
        QCOMPARE(scrubbed.length(), 30u);
        play(straight, 60);
        play(scrubbed, 85);
        QCOMPARE(scrubbed.session().hash(), straight.session().hash());
        QCOMPARE(scrubbed.inputs(), straight.inputs());
        QVERIFY(scrubbed.isAtEnd());
    }
    void inputInThePastStartsAnotherCourse() {
        Timeline timeline = timelineOf(test::floatingBlock());
        play(timeline, 100);
        QVERIFY(timeline.add(throwIt(30.0)).hasValue());
        play(timeline, 50);
        seek(timeline, 80);
        QVERIFY(timeline.add(throwIt(40.0)).hasValue());
        QCOMPARE(timeline.length(), 80u);
        QVERIFY(timeline.isAtEnd());
        QCOMPARE(timeline.inputs(), (std::vector<TimedInput>{{80, throwIt(40.0)}}));
        play(timeline, 40);
        Timeline other = timelineOf(test::floatingBlock());
        play(other, 80);
        QVERIFY(other.add(throwIt(40.0)).hasValue());
        play(other, 40);
        QCOMPARE(timeline.session().hash(), other.session().hash());
    }
    void switchingToABranchRestoresItsFuture() {
        Timeline timeline = timelineOf(test::floatingBlock());
        play(timeline, 50);
        QVERIFY(timeline.add(throwIt(30.0)).hasValue());
        play(timeline, 100);
        const ContentHash first = timeline.session().hash();
        seek(timeline, 70);
        QVERIFY(timeline.add(throwIt(40.0)).hasValue());
        play(timeline, 60);
        const ContentHash second = timeline.session().hash();
        seek(timeline, 20);
        QVERIFY(timeline.add(throwIt(50.0)).hasValue());
        QCOMPARE(timeline.branches().size(), std::size_t{2});
        QCOMPARE(timeline.branches()[0].length, 150u);
        QCOMPARE(timeline.forkOf(timeline.branches()[0]), 20u);
        const std::uint32_t third = timeline.currentId();

        QVERIFY(timeline.switchTo(timeline.branches()[0].id).hasValue());
        QCOMPARE(timeline.session().stepsDone(), 20u);
        QCOMPARE(timeline.length(), 150u);
        seek(timeline, 150);
        QCOMPARE(timeline.session().hash(), first);
        QCOMPARE(timeline.forkOf(timeline.branches()[0]), 70u);  // of the second

        QVERIFY(timeline.switchTo(timeline.branches()[0].id).hasValue());
        QCOMPARE(timeline.session().stepsDone(), 70u);
        seek(timeline, 130);
        QCOMPARE(timeline.session().hash(), second);
        QCOMPARE(timeline.branches().front().id, third);
        QCOMPARE(timeline.switchTo(99).error().code, ErrorCode::BadInput);
        QCOMPARE(timeline.length(), 130u);
    }
    void switchingDropsAPendingInput() {
        Timeline timeline = timelineOf(test::floatingBlock());
        play(timeline, 40);
        const ContentHash hash = timeline.session().hash();
        seek(timeline, 10);
        QVERIFY(timeline.add(throwIt(80.0)).hasValue());  // not applied yet
        QVERIFY(timeline.switchTo(timeline.branches().front().id).hasValue());
        seek(timeline, 40);
        QCOMPARE(timeline.session().hash(), hash);
    }
    void numberOfBranchesIsBounded() {
        Timeline timeline = timelineOf(test::floatingBlock());
        for (int k = 0; k < 20; ++k) {
            play(timeline, 2);
            seek(timeline, timeline.session().stepsDone() - 1);
            QVERIFY(timeline.add(throwIt(20.0 + k)).hasValue());
        }
        QCOMPARE(timeline.branches().size(), kMaxBranches);
        QCOMPARE(timeline.branches().front().id, 8u);  // the oldest are dropped
    }
    /// Long ago, where the snapshots are some 500 steps apart.
    void steppingBackReplaysFewSteps() {
        Timeline timeline = timelineOf(test::floatingBlock());
        play(timeline, 12000);
        int played = 0;
        const auto count = [&] { ++played; };
        QVERIFY(timeline.seek(3000, {}, count).hasValue());
        played = 0;
        for (std::uint64_t step = 2999; step >= 2950; --step) QVERIFY(timeline.seek(step, {}, count).hasValue());
        QVERIFY2(played <= 50 * 10, qPrintable(QString::number(played)));
        for (int k = 0; k < 20; ++k) {  // around a break, again and again
            QVERIFY(timeline.seek(2950, {}, count).hasValue());
            played = 0;
            QVERIFY(timeline.seek(3000, {}, count).hasValue());
            QVERIFY(timeline.seek(2950, {}, count).hasValue());
            QVERIFY2(played <= 50 + 10, qPrintable(QString::number(played)));
        }
    }
    void rejectedInputDiscardsNothing() {
        Timeline timeline = timelineOf(test::floatingBlock());
        play(timeline, 20);
        seek(timeline, 10);
        const Status added = timeline.add(ThresholdInput{.asset = 1, .threshold = -1.0});
        QVERIFY(added.error().message.starts_with("Cannot set a threshold: "));
        QCOMPARE(timeline.length(), 20u);
        QVERIFY(timeline.inputs().empty());
    }
    void futureInputsAreApplied() {
        Timeline timeline(test::sessionOf(test::floatingBlock()), {{12, throwIt(60.0)}}, 40);
        QCOMPARE(timeline.length(), 40u);
        seek(timeline, 1000);
        QCOMPARE(timeline.session().stepsDone(), 40u);
        QVERIFY(test::countOf(timeline.session(), PlayRole::Debris) > 0);
        Timeline wrong(test::sessionOf(test::floatingBlock()), {{12, ThresholdInput{.threshold = -1.0}}}, 40);
        QVERIFY(wrong.seek(40).error().message.starts_with("Cannot set a threshold: "));
        QCOMPARE(wrong.session().stepsDone(), 12u);
    }
    void cancellationStops() {
        Timeline timeline(test::sessionOf(test::floatingBlock()), {}, 40);
        CancelToken cancel;
        cancel.cancel();
        QCOMPARE(timeline.seek(40, {.cancel = cancel}).error().code, ErrorCode::Cancelled);
        QCOMPARE(timeline.session().stepsDone(), 0u);
    }
    void numberOfSnapshotsIsBounded() {
        Timeline timeline = timelineOf(test::floatingBlock());
        play(timeline, 20000);
        int played = 0;
        const auto count = [&] { ++played; };
        QVERIFY(timeline.seek(19900, {}, count).hasValue());  // the last seconds are dense
        QVERIFY2(played < 60, qPrintable(QString::number(played)));
        for (const std::uint64_t step : {9999, 4999, 14999, 1}) {
            played = 0;
            QVERIFY(timeline.seek(step, {}, count).hasValue());
            QVERIFY2(played <= 1500, qPrintable(QString::number(played)));
            QCOMPARE(timeline.session().stepsDone(), step);
        }
    }
    void memoryOfSnapshotsIsBounded() {
        Timeline reference(test::sessionOf(test::floatingBlock()), {{100, throwIt(60.0)}}, 6000);
        std::map<std::uint64_t, ContentHash> hashes;
        while (!reference.isAtEnd()) {
            QVERIFY(reference.step().hasValue());
            hashes[reference.session().stepsDone()] = reference.session().hash();
        }
        const std::size_t limit = reference.snapshotBytes() / 8;  // a few snapshots of the fragments
        Timeline timeline(test::sessionOf(test::floatingBlock()), {{100, throwIt(60.0)}}, 6000, limit);
        seek(timeline, 6000);
        QVERIFY(timeline.snapshotBytes() <= limit);
        for (const std::uint64_t step : {5999, 1, 4000, 119, 5999, 2001}) {
            seek(timeline, step);
            QVERIFY(timeline.session().hash() == hashes[step]);
            QVERIFY(timeline.snapshotBytes() <= limit);
        }
    }
};

RUBBLE_TEST_WITH(TimelineTest, QCoreApplication)
#include "TimelineTest.moc"
