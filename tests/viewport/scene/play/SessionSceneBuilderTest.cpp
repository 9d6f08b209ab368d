// Tests viewport/scene/play/SessionSceneBuilder.cpp and viewport/scene/RenderScene.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include "core/asset/project/FragmentColours.h"
#include "tests/support/files/TestImages.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;
using test::addInput;
using test::floatingBlock;

namespace {

/// A session and its scene builder.
struct Drawn {
    explicit Drawn(const Project& project, const SceneOptions& options = {})
        : played(test::playSceneOf(project)), session(Session::start(played, {}).value()), builder(played, options) {}

    std::shared_ptr<const RenderScene> scene() { return builder.sceneOf(session); }
    std::shared_ptr<const RenderScene> sceneAtStep(int steps) {
        for (int k = 0; k < steps; ++k) session.step();
        return scene();
    }
    /// Breaks a body by its number.
    std::shared_ptr<const RenderScene> sceneAfterBreaking(std::uint32_t body) {
        addInput(session, BreakInput{body});
        return sceneAtStep(1);
    }

    std::shared_ptr<const PlayScene> played;
    Session session;
    SessionSceneBuilder builder;
};

std::vector<std::uint32_t> shownBodies(const RenderScene& scene) {
    std::vector<std::uint32_t> shown;
    for (std::uint32_t k = 0; k < scene.appearances.size(); ++k) {
        if ((scene.appearances[k].marks & kHidden) == 0) shown.push_back(k);
    }
    return shown;
}

/// Describes the first difference between a scene and its session; empty if they agree.
QString faultOf(const RenderScene& scene, const Session& session) {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t k : shownBodies(scene)) {
        const PlayBody* body = bodyOf(session, scene.picks[k]);
        if (body == nullptr) return QString("scene body %1 is none of the session's").arg(k);
        found.push_back(body->number);
        const RenderPose expected = renderPose(session.world().state(body->body).pose, scene.origin);
        if (scene.poses[k].position != expected.position) return QString("body %1 is elsewhere").arg(body->number);
        if (scene.poses[k].orientation != expected.orientation) return QString("body %1 turned").arg(body->number);
    }
    std::ranges::sort(found);
    std::vector<std::uint32_t> living;
    for (const PlayBody& body : session.bodies()) {
        if (body.role != PlayRole::Ground) living.push_back(body.number);
    }
    return found == living ? QString() : QString("%1 bodies shown of %2").arg(found.size()).arg(living.size());
}

std::vector<const SceneGeometry*> geometriesOf(const RenderScene& scene) {
    std::vector<const SceneGeometry*> geometries;
    for (const SceneBatch& batch : scene.batches) geometries.push_back(batch.geometry.get());
    return geometries;
}

constexpr std::uint32_t kBlock = 1;  // body number in floatingBlock(); 0 is the ground

}  // namespace

class SessionSceneBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void sceneContainsAllFragmentsHidden() {
        Drawn drawn(floatingBlock(5));
        const auto moment = drawn.scene();
        QCOMPARE(moment->poses.size(), std::size_t{6});
        QCOMPARE(shownBodies(*moment), std::vector<std::uint32_t>{0});
        QCOMPARE(moment->picks[0].fragment, kNone);
        QCOMPARE(moment->picks[3].fragment, 2u);
        QCOMPARE(faultOf(*moment, drawn.session), QString());
    }
    void wholeHasItsPose() {
        Drawn drawn(floatingBlock(5));
        const Box3 bounds = boundsOf(*drawn.scene());
        QVERIFY(glm::distance(bounds.min, Vec3(-0.5, 4.5, -0.25)) < 1e-6);
        QVERIFY(glm::distance(bounds.max, Vec3(0.5, 5.5, 0.25)) < 1e-6);
    }
    void wholesAndFragmentsHaveTheTexture() {
        Project project = floatingBlock(5);
        const auto image = std::make_shared<const EncodedImage>(imageOf(checkerPng()));
        project.assets[0].texture = Texture{.name = "checker.png", .image = image, .materials = {0}};
        Drawn drawn(project);
        QVERIFY(drawn.scene()->batches[0].texture == image);
        QVERIFY(drawn.sceneAfterBreaking(kBlock)->batches[0].texture == image);
    }
    void breakChangesMarksOnly() {
        Drawn drawn(floatingBlock(5));
        const auto before = drawn.scene();
        const auto after = drawn.sceneAfterBreaking(kBlock);
        QCOMPARE(drawn.session.events().breaks.size(), 1u);
        QCOMPARE(shownBodies(*after), (std::vector<std::uint32_t>{1, 2, 3, 4, 5}));
        QCOMPARE(geometriesOf(*after), geometriesOf(*before));
        QCOMPARE(after->batches[0].firstBodies, before->batches[0].firstBodies);
        QCOMPARE(faultOf(*after, drawn.session), QString());
        const Box3 solids = boundsOf(*after), whole = boundsOf(*before);
        QVERIFY(glm::distance(solids.min, whole.min) < 1e-5 && glm::distance(solids.max, whole.max) < 1e-5);
    }
    void deeperLevelsHaveTheirPoses() {
        Project project = floatingBlock(4);
        project.assets[0].levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 3}})}};
        Drawn drawn(project);
        const auto before = drawn.scene();
        drawn.sceneAfterBreaking(kBlock);
        const auto after = drawn.sceneAfterBreaking(kBlock + 2);
        QVERIFY(drawn.session.bodies().back().fragment >= 4);
        QCOMPARE(faultOf(*after, drawn.session), QString());
        QCOMPARE(geometriesOf(*after), geometriesOf(*before));
    }
    void bondedBodiesShowTheirFragments() {
        Drawn drawn(test::bondedWall(60));
        const auto before = drawn.scene();
        QCOMPARE(shownBodies(*before), std::vector<std::uint32_t>{0});  // the whole
        addInput(drawn.session, ShotInput{"ball", test::ballAtWall()});
        const auto after = drawn.sceneAtStep(60);
        const PlayAsset& asset = test::onlyAsset(*drawn.played);
        const PlayBody& wall = test::wallOf(drawn.session);
        QVERIFY(wall.nodes.size() > 30 && wall.nodes.size() < 60);
        std::size_t ofWall = 0, fragments = 0;
        for (const std::uint32_t k : shownBodies(*after)) {
            const PlayBody* const body = bodyOf(drawn.session, after->picks[k]);
            QVERIFY(body != nullptr);
            if (body->asset == nullptr) continue;
            ++fragments;
            if (body != &wall) continue;
            ++ofWall;
            const Vec3 place = Vec3(0.0, 1.5, 0.0) + asset.fragments[after->picks[k].fragment].offset;
            QVERIFY(glm::distance(Vec3(after->poses[k].position), place - after->origin) < 1e-5);
        }
        QCOMPARE(ofWall, wall.nodes.size());
        QCOMPARE(fragments, asset.fragments.size());
        QCOMPARE(geometriesOf(*after).front(), geometriesOf(*before).front());
    }
    void projectilesAreAdded() {
        Project project = floatingBlock(5);
        Drawn drawn(project);
        drawn.scene();
        Throw box = test::throwAtBlock(1.0, 1.0), asset = box;
        asset.kind = ProjectileKind::Asset;
        asset.asset = project.assets[0].id;
        for (const double height : {10.0, 12.0, 14.0}) {
            box.from.y = box.to.y = height;
            addInput(drawn.session, ShotInput{"box", box});
        }
        asset.from.y = asset.to.y = 20.0;
        addInput(drawn.session, ShotInput{"block", asset});
        const auto moment = drawn.sceneAtStep(2);
        QCOMPARE(faultOf(*moment, drawn.session), QString());
        QCOMPARE(moment->batches.size(), std::size_t{2});  // equal boxes share one geometry
        QCOMPARE(moment->batches[0].firstBodies.size(), std::size_t{2});
        QCOMPARE(moment->batches[1].firstBodies.size(), std::size_t{3});
        const auto next = drawn.sceneAfterBreaking(drawn.session.bodies().back().number);
        QCOMPARE(faultOf(*next, drawn.session), QString());
        QCOMPARE(geometriesOf(*next), geometriesOf(*moment));
    }
    void cutAtImpactIsAddedOnce() {
        Project project = floatingBlock(5);
        project.assets[0].cutAtImpact = CutAtImpact{.fragments = 12};
        Drawn drawn(project);
        const auto before = drawn.scene();
        const auto after = drawn.sceneAfterBreaking(kBlock);
        QCOMPARE(shownBodies(*after).size(), std::size_t{12});
        QCOMPARE(faultOf(*after, drawn.session), QString());
        QCOMPARE(after->batches.size(), before->batches.size() + 1);
        QCOMPARE(geometriesOf(*drawn.sceneAtStep(1)), geometriesOf(*after));
    }
    void fadingDebrisShrinksAboutItsCentre() {
        Project project = floatingBlock(5);
        project.debris = {.lifetime = 1.0, .fade = 0.5};
        test::addInstance(project, project.assets[0].id, "broken", {.position = {5.0, 5.0, 0.0}});
        Drawn drawn(project);
        addInput(drawn.session, BreakInput{drawn.session.bodies().back().number});
        const auto moment = drawn.sceneAtStep(45);
        const PlayBody& body = drawn.session.bodies().back();
        const double fade = drawn.session.fadeOf(body);
        QVERIFY(fade > 0.4 && fade < 0.6);
        const RenderPose& drawnAt = moment->poses[shownBodies(*moment).back()];
        QCOMPARE(drawnAt.position.w, static_cast<float>(fade));
        const BodyState state = drawn.session.world().state(body.body);
        QVERIFY(glm::distance(state.centre, state.pose.position) < 1e-6);  // the frame of a fragment
        QVERIFY(glm::distance(moment->origin + Vec3(drawnAt.position), state.centre) < 1e-5);
        const auto gone = drawn.sceneAtStep(20);
        QCOMPARE(shownBodies(*gone).size(), std::size_t{1});  // the intact block is not debris
    }
    void previousPosesAreThoseOfTheLastStep() {
        Drawn drawn(floatingBlock(5));
        addInput(drawn.session, ShotInput{"box", test::throwAtBlock(1.0, 6.0)});
        const auto first = drawn.sceneAtStep(1), second = drawn.sceneAtStep(1);
        const std::uint32_t box = shownBodies(*second).back();
        QVERIFY(first->previousPoses.empty() || first->previousPoses[box] == first->poses[box]);
        QVERIFY(poseAt(*second, box, 0.0).position == first->poses[box].position);
        QVERIFY(poseAt(*second, box, 1.0) == second->poses[box]);
        const glm::vec4 half = poseAt(*second, box, 0.5).position;
        QVERIFY(glm::length(half - 0.5f * (first->poses[box].position + second->poses[box].position)) < 1e-6f);
        QVERIFY(glm::distance(first->poses[box].position, second->poses[box].position) > 0.09f);  // 6 m/s
    }
    void interpolationRotatesTheShorterWay() {
        const RenderPose from{.orientation = {0.0f, 0.0f, 0.0f, 1.0f}};
        const RenderPose to{.orientation = {0.0f, -0.6f, 0.0f, -0.8f}};  // as (0, 0.6, 0, 0.8)
        const glm::vec4 half = interpolated(from, to, 0.5).orientation;
        QVERIFY(std::abs(half.y / half.w) < 0.34f && std::abs(half.y / half.w) > 0.33f);  // the tangent of half as much
        QVERIFY(std::abs(glm::length(half) - 1.0f) < 1e-6f);
    }
    void newBodiesHaveNoMotion() {
        Drawn drawn(floatingBlock(5));
        addInput(drawn.session, ShotInput{"box", test::throwAtBlock(20.0, 12.0)});
        std::size_t bodies = 0;
        for (int k = 0; k < 20; ++k) {
            const auto moment = drawn.sceneAtStep(1);
            for (const PlayBody& body : drawn.session.events().born) {
                const auto isIt = [&](std::uint32_t shown) {
                    return bodyOf(drawn.session, moment->picks[shown])->number == body.number;
                };
                const std::vector<std::uint32_t> shown = shownBodies(*moment);
                const std::uint32_t at = *std::ranges::find_if(shown, isIt);
                QVERIFY(moment->previousPoses.empty() || moment->previousPoses[at] == moment->poses[at]);
                ++bodies;
            }
        }
        QCOMPARE(bodies, std::size_t{6});  // the box and five solids
    }
    void motionContinuesWhenTheLayoutChanges() {
        Drawn drawn(floatingBlock(5));
        addInput(drawn.session, ShotInput{"box", test::throwAtBlock(1.0, 2.0)});
        drawn.sceneAtStep(2);
        const auto before = drawn.sceneAtStep(1);
        Throw ball = test::throwAtBlock(1.0, 1.0);
        ball.size *= 2.0;
        ball.from.y = ball.to.y = 20.0;
        addInput(drawn.session, ShotInput{"another", ball});
        const auto after = drawn.sceneAtStep(1);
        QVERIFY(after->poses.size() > before->poses.size());
        QVERIFY(poseAt(*after, 6, 0.0).position == before->poses[6].position);
        QVERIFY(after->previousPoses[7] == after->poses[7]);
    }
    void nonConsecutiveStepsHaveNoMotion() {
        Drawn drawn(floatingBlock(5));
        addInput(drawn.session, ShotInput{"box", test::throwAtBlock(1.0, 2.0)});
        QVERIFY(drawn.scene()->previousPoses.empty());
        QVERIFY(drawn.sceneAtStep(2)->previousPoses.empty());
        const auto start = drawn.session.snapshot();
        const auto next = drawn.sceneAtStep(1);
        QCOMPARE(next->previousPoses.size(), next->poses.size());
        QVERIFY(drawn.scene()->previousPoses == next->previousPoses);  // the same step again
        drawn.session.restore(*start);
        QVERIFY(drawn.scene()->previousPoses.empty());
        QVERIFY(!drawn.sceneAtStep(1)->previousPoses.empty());
    }
    void summaryMatchesTheScene() {
        Drawn drawn(floatingBlock(5));
        addInput(drawn.session, ShotInput{"box", test::throwAtBlock(20.0, 12.0)});
        const auto isFound = [](const RenderScene& moment) {
            RenderScene anew = moment;
            anew.summary.reset();
            const Box3 reported = boundsOf(moment), found = boundsOf(anew);
            return moment.summary &&
                   glm::distance(reported.min, found.min) + glm::distance(reported.max, found.max) < 0.05;
        };
        for (int k = 0; k < 20; ++k) {
            QVERIFY(isFound(*drawn.sceneAtStep(1)));
            QVERIFY(isFound(*drawn.scene()));
        }
    }
    void heldScenesAreNotRecycled() {
        Drawn drawn(floatingBlock(5));
        const auto held = drawn.scene();
        const RenderScene copy = *held;
        const RenderScene* second = drawn.sceneAfterBreaking(kBlock).get();
        QVERIFY(second != held.get());
        QVERIFY(shownBodies(*held) == shownBodies(copy) && held->poses[0].position == copy.poses[0].position);
        QVERIFY(drawn.sceneAtStep(1).get() != second);  // the builder still holds the previous scene
        QVERIFY(drawn.sceneAtStep(1).get() == second);  // recycled
    }
    /// Also the hidden poses of what broke in motion: else the view would be drawn again and again, and never refined.
    void scenesAtRestAreEqual() {
        Project project = floatingBlock();
        project.gravity = {0.0, -9.81, 0.0};
        Drawn drawn(project);
        for (int k = 0; k < 20; ++k) drawn.sceneAtStep(1);  // every scene of the pool shows the block in its fall
        drawn.sceneAfterBreaking(kBlock);
        drawn.sceneAtStep(600);
        std::shared_ptr<const RenderScene> before = drawn.sceneAtStep(1);
        for (int k = 0; k < 8; ++k) {
            const std::shared_ptr<const RenderScene> now = drawn.sceneAtStep(1);
            QVERIFY(k == 0 || *now == *before);  // the first one has previous poses
            before = now;
        }
    }
    void seekBackRestoresTheScene() {
        Drawn drawn(floatingBlock(5));
        addInput(drawn.session, ShotInput{"box", test::throwAtBlock(20.0, 12.0)});
        const auto start = drawn.session.snapshot();
        const std::size_t bodies = drawn.sceneAtStep(20)->poses.size();
        QVERIFY(test::countOf(drawn.session, PlayRole::Debris) == 5);
        drawn.session.restore(*start);
        QCOMPARE(faultOf(*drawn.scene(), drawn.session), QString());
        QCOMPARE(shownBodies(*drawn.scene()), std::vector<std::uint32_t>{0});
        const auto again = drawn.sceneAtStep(20);
        QCOMPARE(faultOf(*again, drawn.session), QString());
        QCOMPARE(again->poses.size(), bodies);  // removed bodies have no slot
    }
    void dustIsThatOfTheStepAfterASeek() {
        Session session = test::sessionOf(floatingBlock(5));
        SessionSceneBuilder builder(test::sharedScene(session));
        addInput(session, BreakInput{1});
        std::vector<std::vector<Particle>> played;
        std::shared_ptr<const SessionSnapshot> at10;
        for (int step = 1; step <= 20; ++step) {
            session.step();
            builder.record(session);
            played.push_back(builder.sceneOf(session)->particles);
            if (step == 10) at10 = session.snapshot();
        }
        QVERIFY(played[0].size() > 10 && played[19].size() > 10);
        session.restore(*at10);
        QVERIFY(builder.sceneOf(session)->particles == played[9]);
        for (int step = 11; step <= 20; ++step) {
            session.step();
            builder.record(session);  // played on to the step that is sought, without scenes
        }
        QVERIFY(builder.sceneOf(session)->particles == played[19]);
    }
    void historyOfASessionPlayedElsewhereIsShown() {
        Session session = test::sessionOf(floatingBlock(5));
        addInput(session, BreakInput{1});
        EventHistory history;
        for (int step = 0; step < 5; ++step) {
            session.step();
            history.add(session.stepsDone(), session.events().report.records);
        }
        SessionSceneBuilder ignorant(test::sharedScene(session)), reported(test::sharedScene(session));
        reported.setHistory(history);
        QVERIFY(ignorant.sceneOf(session)->particles.empty());
        QVERIFY(reported.sceneOf(session)->particles.size() > 10);
    }
    void bodiesHaveMaterialColours() {
        Project project = floatingBlock(2);
        project.materials[0].outside = {1.0, 0.0, 0.0};
        project.materials[0].inside = {0.0, 0.0, 1.0};
        const auto moment = Drawn(project).scene();
        QCOMPARE(moment->appearances[0].outside, 0xff0000u);
        QCOMPARE(moment->appearances[2].inside, 0x0000ffu);
        const auto byFragment = Drawn(project, {.colouring = SceneColouring::Fragment}).scene();
        QVERIFY(byFragment->appearances[1].outside != byFragment->appearances[2].outside);
    }
    void groundIsThatOfTheProject() {
        Project project = floatingBlock(2);
        project.ground.height = -2.0;
        QCOMPARE(Drawn(project).scene()->groundHeight, -2.0);
        project.ground.isOn = false;
        QVERIFY(!Drawn(project).scene()->hasGround);
    }
};

RUBBLE_TEST_WITH(SessionSceneBuilderTest, QCoreApplication)
#include "SessionSceneBuilderTest.moc"
