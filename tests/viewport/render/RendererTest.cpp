// Tests viewport/render/Renderer.cpp, viewport/render/SceneBuffers.cpp and viewport/render/SceneMemory.cpp.
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
/// Of an image of moving bodies of one asset: shadow maps of the key light and the sky, the light buffer,
/// depths, the picture.
constexpr std::uint64_t kDrawCalls = 1 + kSkyDirections + 1 + 1 + 1;

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
                          one = scene->batches[0].geometry->wholeIndices.size();
        QVERIFY(one > 0 && 20 * one < all);
        QCOMPARE(half * 2 * one, whole * all);
        RenderScene plain = *scene;
        SceneGeometry geometry = *plain.batches[0].geometry;
        geometry.whole = SceneGeometry::Whole::None;
        geometry.wholeIndices = geometry.silhouetteIndices = {};
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
    /// Intact instances whose fragments are too small to be told apart look as if all were drawn, in fewer triangles.
    void smallFragmentsAreNotDrawnApart() {
        const auto scene = test::starterScene();
        const auto triangles = [&](double minFragmentPixels) {
            pictureOf(scene, minFragmentPixels);  // with it, shadow maps are rendered
            const std::uint64_t before = m_renderer->counts().triangles;
            const auto picture = pictureOf(scene, minFragmentPixels);
            return std::pair(m_renderer->counts().triangles - before, picture);
        };
        const auto [few, whole] = triangles(1000.0);
        const auto [many, apart] = triangles(0.0);
        QVERIFY2(5 * few < many, qPrintable(QString("%1 of %2").arg(few).arg(many)));
        int different = 0;
        for (std::size_t k = 0; k < whole.size(); ++k) different += std::abs(whole[k] - apart[k]) > 24 ? 1 : 0;
        QVERIFY2(different > 0, "no crack is seen where all fragments are drawn");
        QVERIFY2(different < 3 * 200 * 200 / 12, qPrintable(QString::number(different)));  // the cracks
        const RenderScene selected = *test::starterScene({.selected = {scene->picks[3]}});
        QCOMPARE(pictureOf(std::make_shared<RenderScene>(selected), 1000.0),
                 pictureOf(std::make_shared<RenderScene>(selected), 0.0));
    }
    void instancesOutOfViewAreNotDrawn() {
        const auto scene = test::starterScene();
        RenderView view = frontView(*scene);
        const auto trianglesOf = [&](const RenderView& seen) {
            m_renderer->setScene(scene);
            const RenderTarget target(kViewSize, PixelFormat::Colour, 1);
            m_renderer->draw(seen, target.framebuffer());  // shadow maps
            const std::uint64_t before = m_renderer->counts().triangles;
            m_renderer->draw(seen, target.framebuffer());
            return m_renderer->counts().triangles - before;
        };
        const std::uint64_t seen = trianglesOf(view);
        view.camera.target.x += 100.0;
        const std::uint64_t unseen = trianglesOf(view);
        QVERIFY2(4 * unseen < seen, qPrintable(QString("%1 of %2").arg(unseen).arg(seen)));
    }
    /// At whatever draw call: nothing is drawn to the framebuffer, and the next picture is as always.
    void interruptedPicturesLeaveNoTrace() {
        const auto scene = test::starterScene();
        const auto expected = pictureOf(scene);
        const RenderTarget target(kViewSize, PixelFormat::Colour, 1);
        for (int allowed = 0; allowed < static_cast<int>(kDrawCalls); allowed += 5) {
            m_renderer->setScene(std::make_shared<RenderScene>(*scene));  // shadows are outdated
            m_scene.reset();
            int calls = 0;
            m_renderer->setInterruption([&] { return ++calls > allowed; });
            QVERIFY(!m_renderer->draw(frontView(*scene), target.framebuffer()));
            QCOMPARE(calls, allowed + 1);  // none after it
            QVERIFY(!m_renderer->addSample(frontView(*scene), 0) || allowed > 10);
            m_renderer->setInterruption({});
            QVERIFY(m_renderer->draw(frontView(*scene), target.framebuffer()));
            QCOMPARE(pixelsOf(target), expected);
        }
    }

private:
    /// The statistics of drawing a scene after the previous one.
    RenderCounts drawn(const std::shared_ptr<const RenderScene>& scene, double moment = 1.0) {
        const RenderCounts before = m_renderer->counts();
        m_renderer->setScene(scene);
        m_scene.reset();
        RenderView view = frontView(*scene);
        view.stepFraction = moment;
        const RenderTarget target(kViewSize, PixelFormat::Colour, 1);
        m_renderer->draw(view, target.framebuffer());
        const RenderCounts& now = m_renderer->counts();
        return {now.drawCalls - before.drawCalls, now.geometryBytes - before.geometryBytes,
                now.bodyBytes - before.bodyBytes};
    }

    static std::vector<std::uint8_t> pixelsOf(const RenderTarget& target) {
        std::vector<std::uint8_t> pixels(std::size_t{3} * kViewSize.width * kViewSize.height);
        target.bind();
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, kViewSize.width, kViewSize.height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    std::vector<std::uint8_t> pictureOf(const std::shared_ptr<const RenderScene>& scene,
                                        double minFragmentPixels = kMinFragmentPixels) {
        if (scene != m_scene) m_renderer->setScene(scene);
        m_scene = scene;
        const RenderTarget target(kViewSize, PixelFormat::Colour, 1);
        RenderView view = frontView(*scene);
        view.minFragmentPixels = minFragmentPixels;
        m_renderer->draw(view, target.framebuffer());
        return pixelsOf(target);
    }

    std::unique_ptr<SurfacelessContext> m_context;
    std::unique_ptr<Renderer> m_renderer;
    std::shared_ptr<const RenderScene> m_scene;  // of the last picture
};

RUBBLE_TEST_WITH(RendererTest, QCoreApplication)
#include "RendererTest.moc"
