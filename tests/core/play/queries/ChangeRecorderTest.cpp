#include "core/play/queries/ChangeRecorder.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

/// A session and what its changes are recorded by.
struct RecordedSession {
    Session session;
    ChangeRecorder recorder{session};

    void play(int steps) {
        for (int k = 0; k < steps; ++k) {
            session.step();
            recorder.add(session);
        }
    }
};

bool contains(const std::vector<Box3>& boxes, Vec3 point) {
    return std::ranges::any_of(boxes, [&](const Box3& box) {
        return box.min.x <= point.x && point.x <= box.max.x && box.min.y <= point.y && point.y <= box.max.y &&
               box.min.z <= point.z && point.z <= box.max.z;
    });
}

bool contains(const std::vector<Box3>& boxes, const Box3& inner) {
    return std::ranges::any_of(boxes, [&](const Box3& box) {
        Box3 both = box;
        both.include(inner);
        return both == box;
    });
}

}  // namespace

class ChangeRecorderTest : public QObject {
    Q_OBJECT
private slots:
    void floatingBlockChangesNothingUntilItBreaks() {
        RecordedSession played{test::sessionOf(test::floatingBlock())};
        played.play(10);
        QVERIFY(played.recorder.changedBoxes(0).empty());
        test::addInput(played.session, BreakInput{played.session.bodies().back().number});
        played.play(1);
        const std::vector<Box3> boxes = played.recorder.changedBoxes(10);
        QCOMPARE(boxes.size(), 1u);
        // The block of 1 x 1 x 0.5 m at (0, 5, 0); its fragments, which do not move, are in it.
        QVERIFY(glm::distance(boxes[0].min, Vec3(-0.5, 4.5, -0.25)) < 1e-6);
        QVERIFY(glm::distance(boxes[0].max, Vec3(0.5, 5.5, 0.25)) < 1e-6);
        QVERIFY(played.recorder.changedBoxes(11).empty());
        QVERIFY(played.recorder.changedBoxes(1000).empty());
    }

    void movingBodyHasItsOldAndItsNewPlace() {
        RecordedSession played{test::sessionOf(test::floatingBlock())};
        Throw ball = test::throwAtBlock(1.0, 10.0);
        ball.to.y = 60.0;  // upwards, past the block
        test::addInput(played.session, ShotInput{"box", ball});
        played.play(1);
        const std::uint32_t number = played.session.bodies().back().number;
        const auto centre = [&] { return played.session.world().state(played.session.body(number)->body).centre; };
        const Vec3 first = centre();
        played.play(59);  // 10 m
        const std::vector<Box3> boxes = played.recorder.changedBoxes(1);
        QCOMPARE(boxes.size(), 2u);
        QVERIFY(contains(boxes, first) && contains(boxes, centre()));
        QVERIFY(!contains(boxes, (first + centre()) / 2.0));
        // Since before it was thrown, it has no old place; since the last step its places overlap.
        QCOMPARE(played.recorder.changedBoxes(0).size(), 1u);
        QCOMPARE(played.recorder.changedBoxes(59).size(), 1u);
    }

    void removedBodyLeavesItsOldPlace() {
        Project project = test::floatingBlock(4);
        project.debris = {.lifetime = 0.5, .fade = 0.0};
        RecordedSession played{test::sessionOf(project)};
        test::addInput(played.session, BreakInput{played.session.bodies().back().number});
        played.play(40);
        QCOMPARE(test::countOf(played.session, PlayRole::Debris), 0u);
        QCOMPARE(played.recorder.changedBoxes(20).size(), 1u);
        QVERIFY(contains(played.recorder.changedBoxes(20), Vec3(0.0, 5.0, 0.0)));
        QVERIFY(played.recorder.changedBoxes(39).empty());
    }

    void placesOfBodiesThatSettleAreTheirLast() {
        RecordedSession played{test::sessionOf(test::house())};
        const Shot& shot = played.session.scene().project.shots[1];
        if (!played.session.add(shot)) qFatal("the shot cannot be fired");
        played.play(300);
        const std::vector<Box3> boxes = played.recorder.changedBoxes(0);
        for (const PlayBody& body : played.session.bodies()) {
            if (body.role != PlayRole::Debris) continue;
            for (const Polytope& hull : hullsOf(body)) {
                const Pose pose = played.session.world().state(body.body).pose;
                for (const Vec3& vertex : hull.vertices) {
                    QVERIFY(contains(boxes, pose.position + pose.orientation * vertex));
                }
            }
        }
    }

    void fewerChangesThanThereAreCoverMore() {
        RecordedSession played{test::sessionOf(test::house())};
        ChangeRecorder small(played.session, 2000);
        if (!played.session.add(played.session.scene().project.shots[1])) qFatal("the shot cannot be fired");
        for (int step = 0; step < 200; ++step) {
            played.play(1);
            small.add(played.session);
        }
        for (const std::uint64_t since : {0u, 1u, 20u, 50u, 120u, 199u, 200u}) {
            const std::vector<Box3> boxes = small.changedBoxes(since);
            for (const Box3& box : played.recorder.changedBoxes(since)) QVERIFY(contains(boxes, box));
        }
        QVERIFY(small.changedBoxes(199) == played.recorder.changedBoxes(199));
        QVERIFY(small.changedBoxes(200).empty());
    }

    void recordingChangesNothing() {
        Session alone = test::sessionOf(test::house());
        RecordedSession played{test::sessionOf(test::house())};
        played.play(30);
        for (int step = 0; step < 30; ++step) alone.step();
        QVERIFY(alone.hash() == played.session.hash());
    }
};

RUBBLE_TEST(ChangeRecorderTest)
#include "ChangeRecorderTest.moc"
