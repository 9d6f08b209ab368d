// Tests viewport/scene/play/SceneRecording.cpp, viewport/scene/play/EventEffects.cpp and what moments have.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/SceneRecording.h"

#include "core/play/session/Timeline.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/RandomShots.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <tuple>

using namespace rubble;

namespace {

/// A visible body with all that is drawn of it.
struct ShownSolid {
    PickId pick;
    const SceneGeometry* geometry = nullptr;
    std::uint32_t solid = 0;
    RenderPose pose;
    BodyAppearance appearance;
    glm::vec4 restOffset{0.0f};
    bool operator==(const ShownSolid& other) const {
        return pick == other.pick && solid == other.solid && pose == other.pose && appearance == other.appearance &&
               restOffset == other.restOffset && isSame(*geometry, *other.geometry);
    }

private:
    /// What is cut at the point of impact is cut anew after a seek.
    static bool isSame(const SceneGeometry& a, const SceneGeometry& b) {
        const auto isAt = [](const SceneVertex& one, const SceneVertex& other) {
            return one.position == other.position && one.normal == other.normal && one.solid == other.solid;
        };
        return &a == &b || (a.indices == b.indices && std::ranges::equal(a.vertices, b.vertices, isAt));
    }
};

std::vector<ShownSolid> shownIn(const RenderScene& scene) {
    std::vector<ShownSolid> shown;
    for (const SceneBatch& batch : scene.batches) {
        for (const std::uint32_t first : batch.firstBodies) {
            for (std::uint32_t solid = 0; solid < batch.geometry->solidCount(); ++solid) {
                const std::uint32_t body = first + solid;
                if (scene.appearances[body].marks == kHidden) continue;
                shown.push_back({scene.picks[body], batch.geometry.get(), solid, scene.poses[body],
                                 scene.appearances[body], scene.restOffsets->at(body)});
            }
        }
    }
    std::ranges::sort(shown, {}, [](const ShownSolid& one) { return std::tuple(one.pick, one.solid); });
    return shown;
}

/// The marks with what they are on in place of its index, which depends on the order in which bodies were laid out.
std::vector<std::pair<PickId, SurfaceMark>> marksIn(const RenderScene& scene) {
    std::vector<std::pair<PickId, SurfaceMark>> marks;
    for (SurfaceMark mark : scene.surfaceMarks) {
        const PickId pick = scene.picks[std::exchange(mark.body, 0)];
        marks.emplace_back(pick, mark);
    }
    std::ranges::stable_sort(marks, {}, [](const auto& mark) { return mark.first; });
    return marks;
}

/// Describes what is drawn differently, in any bit; empty if nothing is.
QString differenceOf(const RenderScene& recorded, const RenderScene& expected) {
    if (shownIn(recorded) != shownIn(expected)) return "other bodies";
    if (recorded.lines != expected.lines) return "other lines";
    if (recorded.particles != expected.particles) return "other particles";
    if (recorded.chips != expected.chips) return "other chips";
    if (recorded.decals != expected.decals) return "other decals";
    if (marksIn(recorded) != marksIn(expected)) return "other marks";
    if (recorded.summary != expected.summary) return "another summary";
    if (!recorded.previousPoses.empty()) return "it moves";
    const auto same = [](const RenderScene& scene) {
        return std::tuple(scene.origin, scene.isOutdoors, scene.hasGround, scene.groundHeight, scene.boxes,
                          scene.colourRange, scene.explodeOffsets);
    };
    return same(recorded) == same(expected) ? QString() : QString("another surrounding");
}

/// A session that is recorded while it is played.
struct Recorded {
    explicit Recorded(const Project& project, std::vector<TimedInput> inputs = {}, std::uint64_t steps = 0,
                      std::size_t maxBytes = kMaxRecordingBytes)
        : scene(test::playSceneOf(project)),
          timeline(Session::start(scene).value(), std::move(inputs), steps),
          builder(scene),
          recording(scene, timeline.session().stepLength(), maxBytes),
          unlimited(scene, timeline.session().stepLength()) {
        record();
    }
    const Session& session() const { return timeline.session(); }
    void record() {
        builder.record(session());
        for (SceneRecording* one : {&recording, &unlimited})
            one->add(session().stepsDone(), builder.momentOf(session()), session().events());
    }
    void play(int steps) {
        for (int k = 0; k < steps; ++k) {
            if (!timeline.step()) qFatal("it does not play");
            record();
        }
    }
    /// The scene of a step without motion.
    std::shared_ptr<const RenderScene> soughtScene(std::uint64_t step) {
        if (!timeline.seek(step, {}, [this] { builder.record(session()); })) qFatal("it does not seek");
        RenderScene sought = *builder.sceneOf(session());
        sought.previousPoses.clear();
        const Box3 bounds = boundsAt(sought, sought.poses);
        sought.summary = SceneSummary{bounds, bounds, {}, hasTransparentSurface(sought)};
        return std::make_shared<const RenderScene>(std::move(sought));
    }
    QString differenceAt(std::uint64_t step) { return differenceOf(*recording.sceneAt(step), *soughtScene(step)); }

    std::shared_ptr<const PlayScene> scene;
    Timeline timeline;
    SessionSceneBuilder builder;
    SceneRecording recording, unlimited;
};

/// Blocks that are cut where they are hit, and a bonded wall beside them, with debris that fades out.
Project mixedProject() {
    Project project = test::bondedWall(40);
    const Id stone = project.materials[0].id;
    const Id block = test::addAsset(
        project, {.name = "block", .material = stone, .shape = Prism{{rectangle({-0.5, -0.5}, {0.5, 0.5}), {}}, 0.5}},
        {UniformScatter{.count = 5}});
    project.assets.back().cutAtImpact = CutAtImpact{.fragments = 8};
    test::addInstance(project, block, "left", {.position = {-4.0, 0.5, 0.0}});
    test::addInstance(project, block, "right", {.position = {4.0, 0.5, 0.0}});
    project.debris = {.lifetime = 0.5, .fade = 0.4};
    return project;
}

std::vector<TimedInput> randomInputs(const Project& project, Random& random, std::uint64_t steps) {
    std::vector<TimedInput> inputs;
    for (std::uint64_t step = random.below(10); step < steps; step += 5 + random.below(20)) {
        inputs.push_back({step, test::randomShot(project, random)});
    }
    return inputs;
}

}  // namespace

class SceneRecordingTest : public QObject {
    Q_OBJECT
private slots:
    void recordedStepsLookAsWhenTheyAreSought() {
        const Project project = mixedProject();
        bool hasBroken = false, hasLines = false;
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            Random random(seed);
            Recorded played(project, randomInputs(project, random, 120), 120);
            played.play(120);
            QCOMPARE(played.recording.stepCount(), std::size_t{121});
            std::uint64_t step = 120;
            for (int k = 0; k < 25; ++k) {
                step = (step + 2 + random.below(118)) % 121;  // neither the same one nor the next
                const QString difference = played.differenceAt(step);
                QVERIFY2(difference.isEmpty(),
                         qPrintable(QString("seed %1, step %2: %3").arg(seed).arg(step).arg(difference)));
                hasBroken |= shownIn(*played.recording.sceneAt(step)).size() > 20;
                hasLines |= !played.recording.sceneAt(step)->lines.empty();
            }
        }
        QVERIFY(hasBroken && hasLines);
    }
    void dustIsRecorded() {
        Recorded played(test::floatingBlock(5), {{3, BreakInput{1}}}, 40);
        played.play(40);
        QVERIFY(played.recording.sceneAt(3)->particles.empty());
        QVERIFY(played.recording.sceneAt(10)->particles.size() > 10);
        QCOMPARE(played.differenceAt(10), QString());
    }
    void overlaysAreNotRecorded() {
        const Project project = test::floatingBlock(5);
        Recorded plain(project, {{3, BreakInput{1}}}, 20), marked(project, {{3, BreakInput{1}}}, 20);
        marked.builder.setOverlays({.hasContacts = true, .hasBoxes = true, .hasBodies = true, .hasHeat = true});
        for (int k = 0; k < 20; ++k) {
            plain.play(1);
            marked.play(1);
            marked.builder.sceneOf(marked.session());
        }
        const auto lookOf = [](Recorded& recorded) {
            std::vector<std::tuple<PickId, RenderPose, BodyAppearance>> looks;
            const auto scene = recorded.recording.sceneAt(10);
            for (const ShownSolid& one : shownIn(*scene)) looks.emplace_back(one.pick, one.pose, one.appearance);
            return std::pair(looks, scene->boxes.size() + scene->lines.size());
        };
        QVERIFY(lookOf(marked) == lookOf(plain));
    }
    void memoryIsLimited() {
        const Project project = mixedProject();
        Random random(7);
        const std::vector<TimedInput> inputs = randomInputs(project, random, 200);
        Recorded all(project, inputs, 200);
        all.play(200);
        const std::size_t limit = all.recording.bytes() / 4;
        Recorded some(project, inputs, 200, limit);
        for (int k = 0; k < 200; ++k) {
            some.play(1);
            QVERIFY(some.recording.bytes() <= limit);
        }
        QVERIFY(some.recording.stepCount() > 20 && some.recording.stepCount() < 150);
        QCOMPARE(some.recording.lastStepUntil(0), std::uint64_t{0});
        QCOMPARE(some.recording.lastStepUntil(500), std::uint64_t{200});
        std::uint64_t widest = 0;
        for (std::uint64_t step = 0; step <= 200; ++step) {
            const std::uint64_t until = *some.recording.lastStepUntil(step);
            QVERIFY(until <= step);
            widest = std::max(widest, step - until);
            if (until != step) continue;
            QCOMPARE(differenceOf(*some.recording.sceneAt(step), *some.unlimited.sceneAt(step)), QString());
        }
        QVERIFY2(widest > 0 && widest < 64, qPrintable(QString("%1 steps").arg(widest)));
        QCOMPARE(some.recording.lastStepUntil(199), std::uint64_t{199});  // the latest are dense
    }
    void anotherCourseIsRecorded() {
        Recorded played(test::floatingBlock(5), {{3, BreakInput{1}}}, 40);
        played.play(40);
        const std::size_t bytes = played.recording.bytes();
        QVERIFY(played.timeline.seek(2));
        played.recording.discardAfter(2);
        QCOMPARE(played.recording.lastStepUntil(40), std::uint64_t{2});
        QVERIFY(played.recording.bytes() < bytes);
        QVERIFY(played.timeline.add(ShotInput{"box", test::throwAtBlock(1.0, 1.0)}));
        played.play(20);
        QCOMPARE(played.differenceAt(15), QString());
        QCOMPARE(shownIn(*played.recording.sceneAt(15)).size(), std::size_t{2});  // the block and the box
        played.recording.clear();
        QVERIFY(!played.recording.lastStepUntil(40));
        QCOMPARE(played.recording.bytes(), std::size_t{0});
    }
    void knownStepsAreIgnored() {
        Recorded played(test::floatingBlock(5));
        played.play(10);
        const std::size_t bytes = played.recording.bytes();
        QVERIFY(played.timeline.seek(4));
        QVERIFY(played.recording.isKnown(4) && played.recording.isKnown(10) && !played.recording.isKnown(11));
        played.record();
        QCOMPARE(played.recording.stepCount(), std::size_t{11});
        QCOMPARE(played.recording.bytes(), bytes);
    }
    /// Each throw adds a body to all scenes that follow.
    void layoutsThatGrowAreKeptOnce() {
        Recorded played(test::floatingBlock(50));
        played.play(1);
        const std::size_t before = played.recording.bytes();
        for (int k = 0; k < 10; ++k) {
            Throw box = test::throwAtBlock(1.0, 1.0);
            box.from.y = box.to.y = 10.0 + 2.0 * k;
            QVERIFY(played.timeline.add(ShotInput{"box", box}));
            played.play(1);
        }
        QCOMPARE(played.recording.sceneAt(0)->picks.size(), std::size_t{51 + 10});
        QCOMPARE(shownIn(*played.recording.sceneAt(0)).size(), std::size_t{1});
        QVERIFY(played.recording.bytes() < 2 * before + 10 * 1000);
        QCOMPARE(played.differenceAt(5), QString());
    }
    void restCostsLittle() {
        Project project = test::bondedWall(60);
        Recorded played(project);
        played.play(10);
        const std::size_t before = played.recording.bytes();
        played.play(100);
        QVERIFY(played.recording.bytes() - before < 100 * 300);
        QCOMPARE(played.differenceAt(50), QString());
    }
};

RUBBLE_TEST_WITH(SceneRecordingTest, QCoreApplication)
#include "SceneRecordingTest.moc"
