// Tests viewport/scene/play/ContactLines.cpp and viewport/scene/play/OverlayColours.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/PlayOverlays.h"

#include "core/asset/project/FragmentColours.h"
#include "tests/support/play/BondedWalls.h"
#include "viewport/scene/play/ContactLines.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <set>

using namespace rubble;
using test::addInput;

namespace {

/// Two stacked blocks of 1 m on the ground, and a separate one.
Project blocks() {
    Project project = test::floatingBlock(5);
    project.gravity = {0.0, -9.81, 0.0};
    project.instances[0].pose.position = {0.0, 0.5, 0.0};
    test::addInstance(project, project.assets[0].id, "upper", {.position = {0.0, 1.5, 0.0}});
    test::addInstance(project, project.assets[0].id, "other", {.position = {5.0, 0.5, 0.0}});
    return project;
}

struct Shown {
    explicit Shown(const Project& project, const PlayOverlays& overlays, int steps = 10)
        : scene(test::playSceneOf(project)), session(Session::start(scene, {}).value()), builder(scene) {
        builder.setOverlays(overlays);
        step(steps);
    }
    void step(int steps) {
        for (int k = 0; k < steps; ++k) session.step();
        moment = builder.sceneOf(session);
    }
    /// `number`: of a whole body; the ground is 0, and each block has six scene bodies.
    const BodyAppearance& lookOf(std::uint32_t number) const { return moment->appearances[6 * (number - 1)]; }

    std::shared_ptr<const PlayScene> scene;
    Session session;
    SessionSceneBuilder builder;
    std::shared_ptr<const RenderScene> moment;
};

Vec3 placeOf(const Shown& shown, const glm::vec4& place) { return shown.moment->origin + Vec3(place); }

}  // namespace

class PlayOverlaysTest : public QObject {
    Q_OBJECT
private slots:
    void overlaysAreOffByDefault() {
        const Shown shown(blocks(), {});
        QVERIFY(shown.moment->lines.empty() && shown.moment->boxes.empty());
    }
    void contactsAreDots() {
        const Shown shown(blocks(), {.hasContacts = true});
        QCOMPARE(shown.moment->lines.size(), std::size_t{12});  // four points each
        for (const SceneLine& dot : shown.moment->lines) {
            const Vec3 place = placeOf(shown, dot.from);
            QVERIFY(glm::vec3(dot.from) == glm::vec3(dot.to));
            QVERIFY(std::abs(place.y) < 0.02 || std::abs(place.y - 1.0) < 0.02);
            QVERIFY(std::abs(std::abs(place.z) - 0.25) < 0.02);
        }
    }
    void sleepingBodiesHaveContacts() {
        const Shown shown(blocks(), {.hasContacts = true}, 200);
        QVERIFY(shown.session.world().state(shown.session.bodies()[1].body).asleep);
        QCOMPARE(shown.moment->lines.size(), std::size_t{12});
    }
    void arrowsPointFromFirstToSecondBody() {
        const Shown shown(blocks(), {.hasNormals = true, .hasImpulses = true});
        QCOMPARE(shown.moment->lines.size(), std::size_t{24});
        for (const SceneLine& arrow : shown.moment->lines) {
            const glm::vec3 way(arrow.to - arrow.from);
            QVERIFY(arrow.to.w == 1.0f && way.y > 0.99f * glm::length(way));  // upwards: lower bodies come first
        }
    }
    void arrowLengthGrowsWithImpulseWithinBounds() {
        QCOMPARE(impulseLength(100.0, 2.0), 2.0);
        QCOMPARE(impulseLength(400.0, 2.0), 4.0);
        QCOMPARE(impulseLength(1e9, 2.0), 8.0);
        QCOMPARE(impulseLength(0.0, 2.0), 0.2);
    }
    void boxesEncloseAndFollowBodies() {
        Project project = blocks();
        project.instances[2].pose.position.y = 8.0;  // it falls
        Shown shown(project, {.hasBoxes = true}, 30);
        shown.step(1);
        QCOMPARE(shown.moment->boxes.size(), std::size_t{3});
        const SceneLine& box = shown.moment->boxes[2];
        const Vec3 position = shown.session.world().state(shown.session.bodies()[3].body).pose.position;
        const Vec3 low = placeOf(shown, box.from), high = placeOf(shown, box.to);
        QVERIFY(low.x < position.x - 0.49 && high.y > position.y + 0.49 && high.y < position.y + 1.5);
        QVERIFY(box.previousOffset.y > 0.05f && box.previousOffset.y < 0.11f);  // 5 m/s for 1/60 s
    }
    void islandsShareOneColour() {
        const Shown shown(blocks(), {.hasIslands = true});
        QCOMPARE(shown.lookOf(1).outside, shown.lookOf(2).outside);
        QVERIFY(shown.lookOf(1).outside != shown.lookOf(3).outside);
        const Shown asleep(blocks(), {.hasIslands = true}, 200);
        QCOMPARE(asleep.lookOf(1).outside, shown.lookOf(1).outside);  // stable
        QCOMPARE(asleep.lookOf(3).outside, shown.lookOf(3).outside);
    }
    void sleepingBodiesAreBlue() {
        Shown shown(blocks(), {.hasSleep = true});
        const std::uint32_t awake = shown.lookOf(1).outside;
        QCOMPARE(awake, Shown(blocks(), {}).lookOf(1).outside);
        shown.step(200);
        const std::uint32_t asleep = shown.lookOf(1).outside;
        QVERIFY(asleep != awake && (asleep & 255) > (asleep >> 16));
        shown.builder.setOverlays({});
        shown.step(0);
        QCOMPARE(shown.lookOf(1).outside, awake);
    }
    void whatWouldFallIsMarked() {
        Shown shown(blocks(), {.hasCollapse = true});
        const std::uint32_t standing = shown.lookOf(3).outside;
        shown.builder.setCollapse(BodyCollapse{.removed = {1}, .falling = {2}});
        shown.step(0);
        const std::set<std::uint32_t> colours{standing, shown.lookOf(1).outside, shown.lookOf(2).outside,
                                              shown.lookOf(3).outside};
        QCOMPARE(colours.size(), std::size_t{4});
        shown.builder.setCollapse(std::nullopt);
        shown.step(0);
        QCOMPARE(shown.lookOf(3).outside, standing);
        shown.builder.setCollapse(BodyCollapse{.removed = {1}, .falling = {2}});
        shown.builder.setOverlays({});
        shown.step(0);
        QCOMPARE(shown.lookOf(1).outside, Shown(blocks(), {}).lookOf(1).outside);
    }
    void fragmentsThatWouldFallAreDrawnAndMarked() {
        Shown shown(test::bondedWall(20), {.hasCollapse = true}, 1);
        const auto isShown = [&](std::uint32_t k) { return (shown.moment->appearances[k].marks & kHidden) == 0; };
        QVERIFY(isShown(0) && !isShown(1));
        const RenderPose whole = shown.moment->poses[0];
        shown.builder.setCollapse(BodyCollapse{.removed = {1, {3}}, .falling = {}, .fallingParts = {{1, {0, 7}}}});
        shown.step(0);
        QVERIFY(!isShown(0));
        for (std::uint32_t fragment = 0; fragment < 20; ++fragment) QVERIFY(isShown(1 + fragment));
        QVERIFY(bodyOf(shown.session, shown.moment->picks[6]) == shown.session.body(1));
        const auto colourOf = [&](std::uint32_t fragment) { return shown.moment->appearances[1 + fragment].outside; };
        QCOMPARE(colourOf(0), colourOf(7));
        QVERIFY(colourOf(3) != colourOf(0) && colourOf(5) != colourOf(0) && colourOf(5) != colourOf(3));
        const Vec3 offset = shown.session.body(1)->asset->fragments[5].offset;
        const glm::vec4 moved = shown.moment->poses[6].position - whole.position;
        QVERIFY(glm::distance(Vec3(moved.x, moved.y, moved.z), offset) < 1e-5);
        shown.builder.setCollapse(std::nullopt);
        shown.step(0);
        QVERIFY(isShown(0) && !isShown(1));
    }
    void heatShowsForecastOrCoolingImpacts() {
        Project project = test::floatingBlock(5);
        Shown shown(project, {.hasHeat = true});
        QCOMPARE(shown.lookOf(1).outside, packed(heatColour(0.0)));
        addInput(shown.session, ShotInput{"box", test::throwAtBlock(2.0, 8.0)});
        double hottest = 0.0;
        for (int k = 0; k < 12; ++k) {
            shown.step(1);
            for (const PlayImpact& hit : shown.session.events().impacts) {
                hottest = std::max(hottest, hit.damage / hit.threshold);
                QCOMPARE(shown.lookOf(hit.body).outside, packed(heatColour(hottest)));
            }
        }
        QVERIFY(hottest > 0.05 && hottest < 1.0);
        for (int k = 0; k < 120; ++k) shown.step(1);
        QCOMPARE(shown.lookOf(1).outside, packed(heatColour(0.0)));
        shown.builder.setForecast(std::vector<BodyForecast>{{.body = 1, .largest = 1.2}});
        shown.step(1);
        QCOMPARE(shown.lookOf(1).outside, packed(heatColour(1.0)));
        shown.builder.setForecast(std::nullopt);
        shown.step(1);
        QCOMPARE(shown.lookOf(1).outside, packed(heatColour(0.0)));
    }
    void bodyThatLostBondsIsRedAndCoolsDown() {
        Shown shown(test::bondedWall(60, 1e4), {.hasHeat = true}, 1);
        addInput(shown.session, ShotInput{"ball", test::ballAtWall()});
        const auto colour = [&] {  // of the wall, or of its fragment 0 if some are missing
            return shown.moment->appearances[isPartial(*shown.session.body(1)) ? 1 : 0].outside;
        };
        for (int k = 0; k < 60 && shown.session.events().splits.empty(); ++k) shown.step(1);
        QVERIFY(!shown.session.events().splits.empty());
        QVERIFY(!shown.session.body(1)->nodes.empty() && shown.session.body(1)->nodes.front() == 0);
        QCOMPARE(colour(), packed(heatColour(1.0)));
        for (int k = 0; k < 120; ++k) shown.step(1);
        QVERIFY(colour() != packed(heatColour(1.0)));
    }
    void heatRampGetsLighterAndEndsInRed() {
        const auto lightness = [](double value) {
            const Colour colour = heatColour(value);
            return 0.3 * colour.red + 0.59 * colour.green + 0.11 * colour.blue;
        };
        for (double value = 0.0; value < 0.9; value += 0.1) QVERIFY(lightness(value + 0.1) > lightness(value));
        QVERIFY(heatColour(0.999).green > 0.8 && heatColour(1.0).green < 0.2);
        QVERIFY(heatColour(1e9) == heatColour(1.0));
    }
    void hullsCanBeToggled() {
        Shown shown(blocks(), {});
        QVERIFY(shown.moment->batches[0].hulls == nullptr);
        shown.builder.setOverlays({.hasHulls = true});
        shown.step(1);
        QVERIFY(shown.moment->batches[0].hulls != nullptr);
        shown.builder.setOverlays({});
        shown.step(1);
        QVERIFY(shown.moment->batches[0].hulls == nullptr);
    }
};

RUBBLE_TEST_WITH(PlayOverlaysTest, QCoreApplication)
#include "PlayOverlaysTest.moc"
