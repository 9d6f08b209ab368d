#include "viewport/scene/MomentBuilder.h"

#include "core/asset/PieceColours.h"
#include "tests/support/Sessions.h"

using namespace rubble;
using test::floatingBlock;
using test::give;

namespace {

/// A project that is played, and drawn.
struct Drawn {
    explicit Drawn(const Project& project, const SceneOptions& options = {})
        : scene(test::playSceneOf(project)), session(Session::start(scene, {}).value()), builder(scene, options) {}

    std::shared_ptr<const RenderScene> moment() { return builder.momentOf(session); }
    std::shared_ptr<const RenderScene> momentAfter(int steps) {
        for (int k = 0; k < steps; ++k) session.step();
        return moment();
    }
    /// Breaks the body with a number.
    std::shared_ptr<const RenderScene> momentAfterBreaking(std::uint32_t body) {
        give(session, BreakInput{body});
        return momentAfter(1);
    }

    std::shared_ptr<const PlayScene> scene;
    Session session;
    MomentBuilder builder;
};

std::vector<std::uint32_t> shownBodies(const RenderScene& scene) {
    std::vector<std::uint32_t> shown;
    for (std::uint32_t k = 0; k < scene.looks.size(); ++k) {
        if ((scene.looks[k].marks & kHidden) == 0) shown.push_back(k);
    }
    return shown;
}

/// Says what of a moment is not as the session is, or nothing.
QString faultOf(const RenderScene& scene, const Session& session) {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t k : shownBodies(scene)) {
        const PlayBody* body = bodyOf(session, scene.picks[k]);
        if (body == nullptr) return QString("scene body %1 is none of the session's").arg(k);
        found.push_back(body->number);
        const DrawnPose expected = drawnPose(session.world().state(body->body).pose, scene.origin);
        if (scene.motions[k].position != expected.position) return QString("body %1 is elsewhere").arg(body->number);
        if (scene.motions[k].orientation != expected.orientation) return QString("body %1 turned").arg(body->number);
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

constexpr std::uint32_t kBlock = 1;  // the number of floatingBlock()'s one body: 0 is the ground

}  // namespace

class MomentBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void allThatAnInstanceCanBecomeIsThereAndHidden() {
        Drawn drawn(floatingBlock(5));
        const auto moment = drawn.moment();
        QCOMPARE(moment->motions.size(), std::size_t{6});
        QCOMPARE(shownBodies(*moment), std::vector<std::uint32_t>{0});
        QCOMPARE(moment->picks[0].fragment, kNone);
        QCOMPARE(moment->picks[3].fragment, 2u);
        QCOMPARE(faultOf(*moment, drawn.session), QString());
    }
    void theWholeIsDrawnWhereItStands() {
        Drawn drawn(floatingBlock(5));
        const Box3 bounds = boundsOf(*drawn.moment());
        QVERIFY(glm::distance(bounds.min, Vec3(-0.5, 4.5, -0.25)) < 1e-6);
        QVERIFY(glm::distance(bounds.max, Vec3(0.5, 5.5, 0.25)) < 1e-6);
    }
    void aBreakMovesMarksAndNoGeometry() {
        Drawn drawn(floatingBlock(5));
        const auto before = drawn.moment();
        const auto after = drawn.momentAfterBreaking(kBlock);
        QCOMPARE(drawn.session.events().breaks.size(), 1u);
        QCOMPARE(shownBodies(*after), (std::vector<std::uint32_t>{1, 2, 3, 4, 5}));
        QCOMPARE(geometriesOf(*after), geometriesOf(*before));
        QCOMPARE(after->batches[0].firstBodies, before->batches[0].firstBodies);
        QCOMPARE(faultOf(*after, drawn.session), QString());
        const Box3 pieces = boundsOf(*after), whole = boundsOf(*before);
        QVERIFY(glm::distance(pieces.min, whole.min) < 1e-5 && glm::distance(pieces.max, whole.max) < 1e-5);
    }
    void piecesOfPiecesHaveTheirPlaces() {
        Project project = floatingBlock(4);
        project.assets[0].levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 3}})}};
        Drawn drawn(project);
        const auto before = drawn.moment();
        drawn.momentAfterBreaking(kBlock);
        const auto after = drawn.momentAfterBreaking(kBlock + 2);
        QVERIFY(drawn.session.bodies().back().fragment >= 4);
        QCOMPARE(faultOf(*after, drawn.session), QString());
        QCOMPARE(geometriesOf(*after), geometriesOf(*before));
    }
    void whatIsThrownComesToIt() {
        Project project = floatingBlock(5);
        Drawn drawn(project);
        drawn.moment();
        Throw box = test::throwAtBlock(1.0, 1.0), asset = box;
        asset.kind = ProjectileKind::Asset;
        asset.asset = project.assets[0].id;
        for (const double height : {10.0, 12.0, 14.0}) {
            box.from.y = box.to.y = height;
            give(drawn.session, ShotInput{"box", box});
        }
        asset.from.y = asset.to.y = 20.0;
        give(drawn.session, ShotInput{"block", asset});
        const auto moment = drawn.momentAfter(2);
        QCOMPARE(faultOf(*moment, drawn.session), QString());
        QCOMPARE(moment->batches.size(), std::size_t{2});  // boxes that are alike share one geometry
        QCOMPARE(moment->batches[0].firstBodies.size(), std::size_t{2});
        QCOMPARE(moment->batches[1].firstBodies.size(), std::size_t{3});
        const auto next = drawn.momentAfterBreaking(drawn.session.bodies().back().number);
        QCOMPARE(faultOf(*next, drawn.session), QString());
        QCOMPARE(geometriesOf(*next), geometriesOf(*moment));
    }
    void whatIsCutWhereItIsHitComesToItOnce() {
        Project project = floatingBlock(5);
        project.assets[0].cutAtImpact = CutAtImpact{.pieces = 12};
        Drawn drawn(project);
        const auto before = drawn.moment();
        const auto after = drawn.momentAfterBreaking(kBlock);
        QCOMPARE(shownBodies(*after).size(), std::size_t{12});
        QCOMPARE(faultOf(*after, drawn.session), QString());
        QCOMPARE(after->batches.size(), before->batches.size() + 1);
        QCOMPARE(geometriesOf(*drawn.momentAfter(1)), geometriesOf(*after));
    }
    void whatFadesShrinksAboutItsCentre() {
        Project project = floatingBlock(5);
        project.debris = {.lifetime = 1.0, .fade = 0.5};
        project.assets[0].prism.outline = {rectangle({0.0, 0.0}, {1.0, 1.0}), {}};  // its centre is not its frame's
        Drawn drawn(project);
        Throw thrown = test::throwAtBlock(1.0, 1.0);
        thrown.kind = ProjectileKind::Asset;
        thrown.asset = project.assets[0].id;
        thrown.from.y = thrown.to.y = 20.0;
        give(drawn.session, ShotInput{"block", thrown});
        const auto moment = drawn.momentAfter(45);
        const PlayBody& body = drawn.session.bodies().back();
        const double fade = drawn.session.fadeOf(body);
        QVERIFY(fade > 0.4 && fade < 0.6);
        const DrawnPose& drawnAt = moment->motions[shownBodies(*moment).back()];
        QCOMPARE(drawnAt.position.w, static_cast<float>(fade));
        const BodyState state = drawn.session.world().state(body.body);
        const Vec3 arm = state.centre - state.pose.position;
        QVERIFY(glm::length(arm) > 0.5);
        const Vec3 centre = moment->origin + Vec3(drawnAt.position) + (1.0 - fade) * arm;
        QVERIFY(glm::distance(centre, state.centre) < 1e-5);
        const auto gone = drawn.momentAfter(20);
        QCOMPARE(shownBodies(*gone).size(), std::size_t{1});  // the block that stood there is no debris
    }
    void whatMovesGoesFromWhereItWasToWhereItIs() {
        Drawn drawn(floatingBlock(5));
        give(drawn.session, ShotInput{"box", test::throwAtBlock(1.0, 6.0)});
        const auto first = drawn.momentAfter(1), second = drawn.momentAfter(1);
        const std::uint32_t box = shownBodies(*second).back();
        QVERIFY(first->earlier.empty() || first->earlier[box] == first->motions[box]);
        QVERIFY(poseAt(*second, box, 0.0).position == first->motions[box].position);
        QVERIFY(poseAt(*second, box, 1.0) == second->motions[box]);
        const glm::vec4 half = poseAt(*second, box, 0.5).position;
        QVERIFY(glm::length(half - 0.5f * (first->motions[box].position + second->motions[box].position)) < 1e-6f);
        QVERIFY(glm::distance(first->motions[box].position, second->motions[box].position) > 0.09f);  // 6 m/s
    }
    void itTurnsTheShorterWay() {
        const DrawnPose from{.orientation = {0.0f, 0.0f, 0.0f, 1.0f}};
        const DrawnPose to{.orientation = {0.0f, -0.6f, 0.0f, -0.8f}};  // as (0, 0.6, 0, 0.8)
        const glm::vec4 half = between(from, to, 0.5).orientation;
        QVERIFY(std::abs(half.y / half.w) < 0.34f && std::abs(half.y / half.w) > 0.33f);  // the tangent of half as much
        QVERIFY(std::abs(glm::length(half) - 1.0f) < 1e-6f);
    }
    void whatIsBornIsAtOnceWhereItIs() {
        Drawn drawn(floatingBlock(5));
        give(drawn.session, ShotInput{"box", test::throwAtBlock(20.0, 12.0)});
        std::size_t bodies = 0;
        for (int k = 0; k < 20; ++k) {
            const auto moment = drawn.momentAfter(1);
            for (const PlayBody& body : drawn.session.events().born) {
                const auto isIt = [&](std::uint32_t shown) {
                    return bodyOf(drawn.session, moment->picks[shown])->number == body.number;
                };
                const std::vector<std::uint32_t> shown = shownBodies(*moment);
                const std::uint32_t at = *std::ranges::find_if(shown, isIt);
                QVERIFY(moment->earlier.empty() || moment->earlier[at] == moment->motions[at]);
                ++bodies;
            }
        }
        QCOMPARE(bodies, std::size_t{6});  // the box and five pieces
    }
    void whatWasThereGoesOnWhenMoreIsThrown() {
        Drawn drawn(floatingBlock(5));
        give(drawn.session, ShotInput{"box", test::throwAtBlock(1.0, 2.0)});
        drawn.momentAfter(2);
        const auto before = drawn.momentAfter(1);
        Throw ball = test::throwAtBlock(1.0, 1.0);
        ball.size *= 2.0;
        ball.from.y = ball.to.y = 20.0;
        give(drawn.session, ShotInput{"another", ball});
        const auto after = drawn.momentAfter(1);
        QVERIFY(after->motions.size() > before->motions.size());
        QVERIFY(poseAt(*after, 6, 0.0).position == before->motions[6].position);
        QVERIFY(after->earlier[7] == after->motions[7]);
    }
    void nothingMovesInAMomentThatDoesNotFollowTheLast() {
        Drawn drawn(floatingBlock(5));
        give(drawn.session, ShotInput{"box", test::throwAtBlock(1.0, 2.0)});
        QVERIFY(drawn.moment()->earlier.empty());
        QVERIFY(drawn.momentAfter(2)->earlier.empty());
        const auto start = drawn.session.snapshot();
        const auto next = drawn.momentAfter(1);
        QCOMPARE(next->earlier.size(), next->motions.size());
        QVERIFY(drawn.moment()->earlier == next->earlier);  // the same moment once more
        drawn.session.restore(*start);
        QVERIFY(drawn.moment()->earlier.empty());
        QVERIFY(!drawn.momentAfter(1)->earlier.empty());
    }
    void itsSummaryIsWhatOneWouldFind() {
        Drawn drawn(floatingBlock(5));
        give(drawn.session, ShotInput{"box", test::throwAtBlock(20.0, 12.0)});
        const auto isFound = [](const RenderScene& moment) {
            RenderScene anew = moment;
            anew.summary.reset();
            const Box3 told = boundsOf(moment), found = boundsOf(anew);
            return moment.summary && glm::distance(told.min, found.min) + glm::distance(told.max, found.max) < 0.05;
        };
        for (int k = 0; k < 20; ++k) {
            QVERIFY(isFound(*drawn.momentAfter(1)));
            QVERIFY(isFound(*drawn.moment()));
        }
    }
    void aSceneThatSomebodyHoldsStaysAsItIs() {
        Drawn drawn(floatingBlock(5));
        const auto held = drawn.moment();
        const RenderScene copy = *held;
        const RenderScene* second = drawn.momentAfterBreaking(kBlock).get();
        QVERIFY(second != held.get());
        QVERIFY(shownBodies(*held) == shownBodies(copy) && held->motions[0].position == copy.motions[0].position);
        QVERIFY(drawn.momentAfter(1).get() != second);  // the last moment is held by who makes the next
        QVERIFY(drawn.momentAfter(1).get() == second);  // that nobody holds
    }
    void aSessionThatGoesBackIsDrawnAsItWas() {
        Drawn drawn(floatingBlock(5));
        give(drawn.session, ShotInput{"box", test::throwAtBlock(20.0, 12.0)});
        const auto start = drawn.session.snapshot();
        const std::size_t bodies = drawn.momentAfter(20)->motions.size();
        QVERIFY(test::countOf(drawn.session, PlayRole::Piece) == 5);
        drawn.session.restore(*start);
        QCOMPARE(faultOf(*drawn.moment(), drawn.session), QString());
        QCOMPARE(shownBodies(*drawn.moment()), std::vector<std::uint32_t>{0});
        const auto again = drawn.momentAfter(20);
        QCOMPARE(faultOf(*again, drawn.session), QString());
        QCOMPARE(again->motions.size(), bodies);  // what is gone for good has no place
    }
    void bodiesHaveTheColoursOfTheirMaterials() {
        Project project = floatingBlock(2);
        project.materials[0].outside = {1.0, 0.0, 0.0};
        project.materials[0].inside = {0.0, 0.0, 1.0};
        const auto moment = Drawn(project).moment();
        QCOMPARE(moment->looks[0].outside, 0xff0000u);
        QCOMPARE(moment->looks[2].inside, 0x0000ffu);
        const auto byPiece = Drawn(project, {.colouring = SceneColouring::Piece}).moment();
        QVERIFY(byPiece->looks[1].outside != byPiece->looks[2].outside);
    }
    void theGroundIsTheProjects() {
        Project project = floatingBlock(2);
        project.ground.height = -2.0;
        QCOMPARE(Drawn(project).moment()->groundHeight, -2.0);
        project.ground.isOn = false;
        QVERIFY(!Drawn(project).moment()->hasGround);
    }
};

QTEST_GUILESS_MAIN(MomentBuilderTest)
#include "MomentBuilderTest.moc"
