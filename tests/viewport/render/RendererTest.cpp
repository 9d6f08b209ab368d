// Tests viewport/render/Renderer.cpp and viewport/render/SceneBuffers.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/render/Renderer.h"
#include "viewport/render/gl/RenderTarget.h"
#include "viewport/render/gl/SurfacelessContext.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <epoxy/gl.h>

using namespace rubble;

namespace {

constexpr ImageSize kViewSize{200, 200};
/// Of an image of moving bodies of one asset: shadow maps of the key light and the sky, the light buffer, the picture.
constexpr std::uint64_t kDrawCalls = 1 + kSkyDirections + 1 + 1;

/// The wall from the front.
RenderView frontView(const RenderScene& scene) {
    RenderView view{.size = kViewSize};
    view.camera = framing(view.camera, boundsOf(scene), kViewSize);
    return view;
}

}  // namespace

class RendererTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_context = SurfacelessContext::create().value();
        m_renderer = Renderer::create().value();
    }
    void cleanupTestCase() { m_renderer.reset(); }

    void picksTheVisibleBody() {
        const auto scene = test::starterScene();
        m_renderer->setScene(scene);
        const RenderView view = frontView(*scene);
        const double scale = 1.0 / metresPerPixel(view.camera, kViewSize);
        for (std::uint32_t body = 0; body < scene->poses.size(); ++body) {
            const Vec3 centre = scene->origin + Vec3(scene->poses[body].position) - view.camera.target;
            // The front face is nearer than the target, and so a little larger.
            const double nearer = view.camera.distance / (view.camera.distance - 0.25);
            const int x = static_cast<int>(100.0 + nearer * scale * centre.x);
            const int y = static_cast<int>(100.0 - nearer * scale * centre.y);
            QCOMPARE(m_renderer->bodyAt(view, x, y).value(), body);
        }
        QVERIFY(!m_renderer->bodyAt(view, 0, 0));
        QVERIFY(!m_renderer->bodyAt(view, -1, 500));
    }
    void picksMovingBodiesAtInterpolatedPoses() {
        RenderScene moved = *test::starterScene();
        const std::uint32_t body = pickedAt(moved, 1.0).value();
        moved.previousPoses = moved.poses;
        moved.previousPoses[body].position += glm::vec4(4.0f, 0.0f, 0.0f, 0.0f);  // out of view
        QCOMPARE(pickedAt(moved, 1.0), std::optional(body));
        QVERIFY(pickedAt(moved, 0.5) != body);
        moved.previousPoses[body].position -= glm::vec4(8.0f, 0.0f, 0.0f, 0.0f);
        for (RenderPose& now : moved.poses)
            now.position.x += 4.0f;  // at half the step they are at their original poses
        for (std::uint32_t k = 0; k < moved.previousPoses.size(); ++k) {
            if (k != body) moved.previousPoses[k].position.x -= 4.0f;
        }
        QCOMPARE(pickedAt(moved, 0.5), std::optional(body));
        QVERIFY(pickedAt(moved, 1.0) != body);
    }
    void breakUploadsNoGeometryAndAddsNoDrawCalls() {
        const auto play = test::playSceneOf(test::floatingBlock(40));
        Session session = Session::start(play, {}).value();
        SessionSceneBuilder builder(play);
        drawn(builder.sceneOf(session));
        session.step();
        const RenderCounts whole = drawn(builder.sceneOf(session));
        test::addInput(session, BreakInput{1});
        session.step();
        QCOMPARE(session.bodies().size(), std::size_t{41});
        const RenderCounts swap = drawn(builder.sceneOf(session));
        session.step();
        const RenderCounts solids = drawn(builder.sceneOf(session));
        QCOMPARE(whole.geometryBytes, std::uint64_t{0});
        QVERIFY(swap.geometryBytes == 0 && solids.geometryBytes == 0);
        for (const RenderCounts& image : {whole, swap, solids}) QCOMPARE(image.drawCalls, kDrawCalls);
        QVERIFY(whole.bodyBytes > 0 && swap.bodyBytes == whole.bodyBytes && solids.bodyBytes == whole.bodyBytes);
    }
    /// Of what is not broken only the whole is drawn, of what is broken all; either looks as if all were drawn.
    void whatIsWholeIsDrawnWhole() {
        Project project = test::floatingBlock(40);
        Instance other = project.instances[0];
        other.id = project.nextId++;
        other.name = "other";
        other.pose.position.x += 3.0;
        project.instances.push_back(other);
        const auto play = test::playSceneOf(project);
        Session session = Session::start(play, {}).value();
        SessionSceneBuilder builder(play);
        const auto trianglesOf = [&] {
            const std::uint64_t before = m_renderer->counts().triangles;
            drawn(builder.sceneOf(session));
            return m_renderer->counts().triangles - before;
        };
        session.step();
        const std::uint64_t whole = trianglesOf();
        test::addInput(session, BreakInput{1});
        session.step();
        const std::uint64_t half = trianglesOf();
        const auto scene = builder.sceneOf(session);
        const std::size_t all = scene->batches[0].geometry->indices.size(),
                          one = scene->batches[0].geometry->wholeIndices;
        QVERIFY(one > 0 && 20 * one < all);
        QCOMPARE(half * 2 * one, whole * (one + all));
        RenderScene plain = *scene;
        SceneGeometry geometry = *plain.batches[0].geometry;
        geometry.wholeIndices = 0;
        plain.batches[0].geometry = std::make_shared<SceneGeometry>(geometry);
        QCOMPARE(pictureOf(scene), pictureOf(std::make_shared<RenderScene>(plain)));
    }
    void secondImageOfAStepUploadsNothing() {
        RenderScene moved = *test::starterScene();
        moved.previousPoses = moved.poses;
        const auto scene = std::make_shared<RenderScene>(moved);
        QVERIFY(drawn(scene, 0.2).bodyBytes > 0);
        const RenderCounts again = drawn(scene, 0.6);
        QVERIFY(again.bodyBytes == 0 && again.geometryBytes == 0);
        QCOMPARE(again.drawCalls, kDrawCalls);
    }
    void hiddenBodiesAreNotPicked() {
        const auto all = test::starterScene();
        m_renderer->setScene(all);
        const RenderView view = frontView(*all);
        const std::uint32_t body = m_renderer->bodyAt(view, 100, 100).value();
        m_renderer->setScene(test::starterScene({.hidden = {all->picks[body]}}));
        QVERIFY(m_renderer->bodyAt(view, 100, 100) != body);
    }

private:
    /// The statistics of drawing a scene after the previous one.
    RenderCounts drawn(const std::shared_ptr<const RenderScene>& scene, double moment = 1.0) {
        const RenderCounts before = m_renderer->counts();
        m_renderer->setScene(scene);
        RenderView view = frontView(*scene);
        view.stepFraction = moment;
        const RenderTarget target(kViewSize, PixelFormat::Colour, 1);
        m_renderer->draw(view, target.framebuffer());
        const RenderCounts& now = m_renderer->counts();
        return {now.drawCalls - before.drawCalls, now.geometryBytes - before.geometryBytes,
                now.bodyBytes - before.bodyBytes};
    }

    std::vector<std::uint8_t> pictureOf(const std::shared_ptr<const RenderScene>& scene) {
        m_renderer->setScene(scene);
        const RenderTarget target(kViewSize, PixelFormat::Colour, 1);
        m_renderer->draw(frontView(*scene), target.framebuffer());
        std::vector<std::uint8_t> pixels(std::size_t{3} * kViewSize.width * kViewSize.height);
        target.bind();
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, kViewSize.width, kViewSize.height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }

    /// The body at the centre of the original wall, at a step fraction.
    std::optional<std::uint32_t> pickedAt(const RenderScene& scene, double moment) {
        RenderView view = frontView(*test::starterScene());
        view.stepFraction = moment;
        m_renderer->setScene(std::make_shared<RenderScene>(scene));
        return m_renderer->bodyAt(view, 100, 100);
    }

    std::unique_ptr<SurfacelessContext> m_context;
    std::unique_ptr<Renderer> m_renderer;
};

RUBBLE_TEST_WITH(RendererTest, QCoreApplication)
#include "RendererTest.moc"
