// Tests viewport/scene/play/SessionSceneBuilder.cpp: pictures of a moment are the same, however it was reached.
#include "tests/support/TestProgram.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include "tests/support/play/RandomShots.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr int kBreaks = 1000, kRewoundPictures = 40;
constexpr std::uint64_t kSteps = 40;
const std::vector<Material> kBlockMaterials{
    {.name = "concrete", .density = 2400.0, .fractureToughness = 4e5},
    {.name = "glass", .density = 2500.0, .fractureToughness = 7.5e5, .opacity = 0.3},
    {.name = "wood", .density = 420.0, .fractureToughness = 5e6},
    {.name = "steel", .density = 7850.0, .fractureToughness = 6e7}};

/// All that a scene shows at the end of its step, whatever bodies of other moments it has hidden.
struct Shown {
    std::vector<std::tuple<PickId, RenderPose, BodyAppearance>> bodies;
    std::vector<std::tuple<PickId, glm::vec4, glm::vec4>> marks;
    std::vector<Particle> particles;
    std::vector<Chip> chips;
    std::vector<Decal> decals;
    bool operator==(const Shown&) const = default;
};

Shown shownIn(const RenderScene& scene) {
    Shown shown{.particles = scene.particles, .chips = scene.chips, .decals = scene.decals};
    for (std::size_t k = 0; k < scene.poses.size(); ++k) {
        if ((scene.appearances[k].marks & kHidden) != 0) continue;
        shown.bodies.emplace_back(scene.picks[k], scene.poses[k], scene.appearances[k]);
    }
    for (const SurfaceMark& mark : scene.surfaceMarks) {
        shown.marks.emplace_back(scene.picks[mark.body], mark.centre, mark.normal);
    }
    return shown;
}

/// A block over the ground, of a material, with shots at random.
struct Play {
    explicit Play(std::shared_ptr<const PlayScene> scene, std::uint64_t randomSeed)
        : session(Session::start(scene, {}).value()), builder(scene) {
        Random random(randomSeed);
        const std::uint64_t count = 1 + random.below(3);
        for (std::uint64_t k = 0; k < count; ++k) {
            const std::uint64_t step = random.below(kSteps / 2);
            const Status added = random.below(4) == 0
                                     ? session.add(TimedInput{step, BreakInput{1}})
                                     : session.add(TimedInput{step, test::randomShot(scene->project, random)});
            if (!added) qFatal("%s", added.error().message.c_str());
        }
    }
    std::shared_ptr<const RenderScene> next() {
        session.step();
        builder.record(session);
        breaks += static_cast<int>(session.events().breaks.size() + session.events().splits.size());
        return builder.sceneOf(session);
    }

    Session session;
    SessionSceneBuilder builder;
    int breaks = 0;
};

std::shared_ptr<const PlayScene> blockOf(const Material& material) {
    Project project = test::floatingBlock(8);
    const Id id = test::addMaterial(project, material);
    for (Asset& asset : project.assets) asset.material = id;
    project.gravity = {0.0, -9.81, 0.0};
    project.ground.isOn = true;
    project.instances[0].pose.position.y = 0.8;
    return test::playSceneOf(project);
}

RenderView smallView(const RenderScene& scene) {
    RenderView view{.size = {64, 64}};
    Box3 around = boundsOf(scene);
    around.include(around.min - Vec3(1.0));
    around.include(around.max + Vec3(1.0));
    view.camera = framing(view.camera, around, view.size);
    view.settings.hasAxes = view.settings.hasScaleBar = false;
    return view;
}

std::string labelOf(std::uint64_t seed) { return "random seed " + std::to_string(seed); }

}  // namespace

class RewoundPictureTest : public QObject {
    Q_OBJECT
private slots:
    void thousandBreaksLookTheSamePlayedSoughtAndReplayed() {
        std::vector<std::shared_ptr<const PlayScene>> blocks;
        for (const Material& material : kBlockMaterials) blocks.push_back(blockOf(material));
        int breaks = 0;
        std::size_t chips = 0, dust = 0, marks = 0, decals = 0;
        for (std::uint64_t seed = 1; breaks < kBreaks; ++seed) {
            QVERIFY(seed < 3 * kBreaks);
            const std::shared_ptr<const PlayScene>& block = blocks[seed % blocks.size()];
            Play played(block, seed), replayed(block, seed);
            std::vector<Shown> moments;
            std::vector<std::shared_ptr<const SessionSnapshot>> snapshots;
            for (std::uint64_t step = 0; step < kSteps; ++step) {
                moments.push_back(shownIn(*played.next()));
                snapshots.push_back(played.session.snapshot());
                QVERIFY2(shownIn(*replayed.next()) == moments.back(), labelOf(seed).c_str());
            }
            breaks += played.breaks;
            const Shown& last = moments.back();
            chips += last.chips.size(), dust += last.particles.size();
            marks += last.marks.size();
            for (const Shown& moment : moments) decals += moment.decals.size();
            Random random(mixSeeds(seed, 7));
            for (int k = 0; k < 3; ++k) {  // back and forth
                const std::uint64_t from = random.below(kSteps), to = from + random.below(kSteps - from);
                played.session.restore(*snapshots[from]);
                QVERIFY2(shownIn(*played.builder.sceneOf(played.session)) == moments[from], labelOf(seed).c_str());
                for (std::uint64_t step = from; step < to; ++step) {
                    played.session.step();
                    played.builder.record(played.session);
                }
                QVERIFY2(shownIn(*played.builder.sceneOf(played.session)) == moments[to], labelOf(seed).c_str());
            }
        }
        QVERIFY2(chips > 10'000 && dust > 1000 && marks > 100 && decals > 10,
                 qPrintable(QString("%1 %2 %3 %4").arg(chips).arg(dust).arg(marks).arg(decals)));
    }
    void picturesHaveTheSameBytes() {
        Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
        QVERIFY(renderer.hasValue());
        std::vector<std::shared_ptr<const PlayScene>> blocks;
        for (const Material& material : kBlockMaterials) blocks.push_back(blockOf(material));
        for (std::uint64_t seed = 1; seed <= kRewoundPictures; ++seed) {
            Play played(blocks[seed % blocks.size()], seed), replayed(blocks[seed % blocks.size()], seed);
            const std::uint64_t shown = 5 + seed % (kSteps - 10);
            std::shared_ptr<const RenderScene> scene, again;
            std::shared_ptr<const SessionSnapshot> before;
            for (std::uint64_t step = 0; step < shown; ++step) {
                if (step == shown / 2) before = played.session.snapshot();
                scene = played.next();
                again = replayed.next();
            }
            const RenderView view = smallView(*scene);
            const Image picture = renderer->renderImage(scene, view, 0).value();
            QVERIFY2(renderer->renderImage(again, view, 0).value().pixels == picture.pixels, labelOf(seed).c_str());
            for (int k = 0; k < 5; ++k) played.next();
            played.session.restore(*before);
            for (std::uint64_t step = shown / 2; step < shown; ++step) {
                played.session.step();
                played.builder.record(played.session);
            }
            const std::shared_ptr<const RenderScene> sought = played.builder.sceneOf(played.session);
            QVERIFY2(renderer->renderImage(sought, view, 0).value().pixels == picture.pixels, labelOf(seed).c_str());
        }
    }
};

RUBBLE_TEST_WITH(RewoundPictureTest, QCoreApplication)
#include "RewoundPictureTest.moc"
