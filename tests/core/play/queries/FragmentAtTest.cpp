#include "core/play/queries/FragmentAt.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

using namespace rubble;

namespace {

/// Where a fragment's centre is in the world.
Vec3 centreInWorld(const Session& session, const PlayBody& body, std::uint32_t fragment) {
    const Pose pose = session.world().state(body.body).pose;
    return pose.position + pose.orientation * (centreInAsset(body.asset->fragments[fragment]) - frameOf(body));
}

}  // namespace

class FragmentAtTest : public QObject {
    Q_OBJECT
private slots:
    void eachCentreIsInItsFragment() {
        Project project = test::bondedWall(60);
        const double half = std::sqrt(0.5);
        project.instances[0].pose = {{1.0, 4.0, -2.0}, Quat{0.0, half, 0.0, half}};
        project.instances[0].isAnchored = false;
        project.instances[0].isFixed = true;
        const Session session = test::sessionOf(project);
        for (std::uint32_t fragment = 0; fragment < 60; ++fragment) {
            const Vec3 centre = centreInWorld(session, *session.body(1), fragment);
            QCOMPARE(fragmentAt(session.world(), *session.body(1), centre), std::optional(fragment));
        }
    }
    void whatIsLeftOfABodyIsFound() {
        for (const bool isAnchored : {true, false}) {
            Project project = test::bondedWall();
            project.instances[0].isAnchored = isAnchored;
            Session session = test::sessionOf(project);
            test::addInput(session, ShotInput{"ball", test::ballAtWall({1.7, 2.7})});
            for (int k = 0; k < 60; ++k) session.step();
            const PlayBody& wall = *session.body(1);
            QVERIFY(isPartial(wall) && wall.isHeld == isAnchored);
            for (const std::uint32_t fragment : bondedFragments(wall)) {
                const Vec3 centre = centreInWorld(session, wall, fragment);
                QCOMPARE(fragmentAt(session.world(), wall, centre), std::optional(fragment));
            }
        }
    }
    void pointBesideABodyGivesTheNearest() {
        const Session session = test::sessionOf(test::bondedWall(60));
        const PlayBody& wall = *session.body(1);
        const std::uint32_t nearest = *fragmentAt(session.world(), wall, {-9.0, -9.0, 0.0});
        const Vec3 centre = centreInAsset(wall.asset->fragments[nearest]);
        QVERIFY(centre.x < -1.5 && centre.y < -1.0);
    }
    void solidHasNoFragments() {
        Project project = test::bondedWall(60);
        project.assets[0].breakAs = BreakAs::Whole;
        const Session session = test::sessionOf(project);
        QVERIFY(!fragmentAt(session.world(), *session.body(1), {0.0, 1.5, 0.0}));
    }
};

RUBBLE_TEST(FragmentAtTest)
#include "FragmentAtTest.moc"
