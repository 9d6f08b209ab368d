// Tests viewport/scene/play/ImpactMarks.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/ImpactMarks.h"

#include "tests/support/play/Sessions.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

using namespace rubble;

namespace {

/// A session with the marks that its steps left.
struct Marked {
    explicit Marked(const Project& project) : session(test::sessionOf(project)) {}

    void play(int steps) {
        for (int k = 0; k < steps; ++k) {
            session.step();
            marks.record(session);
        }
    }
    /// The marks at the session's step; bodies of the scene are numbered by fragment, from 1 on.
    std::vector<SurfaceMark> shown() const {
        RenderScene scene;
        marks.addTo(
            scene, session,
            [](const PlayBody&, std::uint32_t fragment) { return fragment == kNone ? 0 : fragment + 1; },
            [](const PlayBody&) { return false; });
        return scene.surfaceMarks;
    }

    Session session;
    ImpactMarks marks;
};

/// The block, opaque and too strong to break.
Project strongBlock() {
    Project project = test::floatingBlock();
    const Id id = test::addMaterial(project, {.name = "concrete", .density = 2000.0});
    for (Asset& asset : project.assets) asset.material = id;
    return project;
}
ShotInput ballAtBlock(double speed = 12.0) { return {"ball", test::throwAtBlock(20.0, speed)}; }

/// The place of a mark in the world, by the body that has it.
Vec3 placeOf(const Marked& marked, const SurfaceMark& mark) {
    for (const PlayBody& body : marked.session.bodies()) {
        if (body.asset == nullptr) continue;
        if ((body.fragment == kNone ? 0 : body.fragment + 1) != mark.body) continue;
        const Pose pose = marked.session.world().state(body.body).pose;
        return pose.position + pose.orientation * Vec3(glm::vec3(mark.centre));
    }
    return Vec3(1e9);
}

}  // namespace

class ImpactMarksTest : public QObject {
    Q_OBJECT
private slots:
    void nothingIsMarkedWhereNothingHits() {
        Marked marked(strongBlock());
        marked.play(30);
        QVERIFY(marked.shown().empty());
    }
    /// Also of a body that broke: the mark is where it was hit, on the fragments there.
    void breakMarksTheFragmentsWhereItWasHit() {
        Marked marked(strongBlock());
        test::addInput(marked.session, ballAtBlock(40.0));
        Vec3 point(0.0);
        for (int k = 0; k < 60 && marked.session.events().breaks.empty(); ++k) marked.play(1);
        QVERIFY(!marked.session.events().breaks.empty());
        point = marked.session.events().breaks.front().point;
        const std::vector<SurfaceMark> marks = marked.shown();
        QVERIFY(!marks.empty());
        for (const SurfaceMark& mark : marks) {
            QVERIFY(mark.body > 0);
            QVERIFY(glm::distance(placeOf(marked, mark), point) < 0.6);
        }
    }
    /// It moves with them: its place in their frames stays.
    void marksStayOnTheirBodies() {
        Marked marked(strongBlock());
        test::addInput(marked.session, ballAtBlock(40.0));
        marked.play(12);
        const std::vector<SurfaceMark> early = marked.shown();
        const std::vector<Vec3> places = [&] {
            std::vector<Vec3> all;
            for (const SurfaceMark& mark : early) all.push_back(placeOf(marked, mark));
            return all;
        }();
        QVERIFY(!early.empty());
        marked.play(30);
        const std::vector<SurfaceMark> late = marked.shown();
        double moved = 0.0;
        for (std::size_t k = 0; k < early.size(); ++k) {
            QVERIFY(std::ranges::find(late, early[k]) != late.end());
            moved = std::max(moved, glm::distance(placeOf(marked, early[k]), places[k]));
        }
        QVERIFY(moved > 0.1);
    }
    void marksAreThoseOfTheStepAfterASeek() {
        Marked marked(strongBlock());
        test::addInput(marked.session, ballAtBlock(40.0));
        const auto start = marked.session.snapshot();
        marked.play(40);
        const std::vector<SurfaceMark> played = marked.shown();
        QVERIFY(!played.empty());
        marked.session.restore(*start);
        QVERIFY(marked.shown().empty());
        marked.play(40);
        QVERIFY(marked.shown() == played);
        marked.session.restore(*start);
        test::addInput(marked.session, DestructionInput{false});
        test::addInput(marked.session, RemoveInput{{.instance = marked.session.scene().project.instances[0].id}});
        marked.play(40);  // another course
        QVERIFY(marked.shown().empty());
    }
    void transparentBodiesShatterAndHaveNoMarks() {
        Project project = strongBlock();
        project.materials.back().opacity = 0.3;
        Marked marked(project);
        test::addInput(marked.session, ballAtBlock(40.0));
        marked.play(40);
        QVERIFY(marked.shown().empty());
    }
    void blastLeavesSootWithinItsRadius() {
        for (const double distance : {0.8, 6.0}) {
            Marked marked(strongBlock());
            const Box3 box = marked.session.world().box(marked.session.bodies().back().body);
            const Vec3 at = box.centre() + Vec3(0.0, 0.0, 0.5 * (box.max - box.min).z + distance);
            test::addInput(marked.session, ShotInput{"blast", Blast{.at = at, .impulse = 1.0, .radius = 2.0}});
            marked.play(1);
            const std::vector<SurfaceMark> marks = marked.shown();
            QCOMPARE(marks.size(), std::size_t{distance < 1.0 ? 1u : 0u});
            if (marks.empty()) continue;
            QCOMPARE(glm::vec3(marks[0].normal), glm::vec3(0.0f));
            QVERIFY(glm::distance(placeOf(marked, marks[0]), at) < 0.02);
            QCOMPARE(marks[0].centre.w, 1.5f);
        }
    }
    void marksAreBounded() {
        Marked marked(strongBlock());
        const Box3 box = marked.session.world().box(marked.session.bodies().back().body);
        for (int k = 0; k < 80; ++k) {
            test::addInput(marked.session,
                           ShotInput{"blast", Blast{.at = box.centre(), .impulse = 1e-3, .radius = 2.0}});
            marked.play(1);
        }
        QCOMPARE(marked.shown().size(), kMaxMarks);
    }
};

RUBBLE_TEST(ImpactMarksTest)
#include "ImpactMarksTest.moc"
