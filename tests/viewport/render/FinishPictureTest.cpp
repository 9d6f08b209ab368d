// Tests viewport/render/finish/FinishTexture.cpp, the shader of finishes and how scenes describe them.
#include "core/asset/finish/FinishedSurface.h"
#include "core/asset/library/StarterProject.h"
#include "core/asset/project/FragmentColours.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/SceneBuilder.h"
#include "viewport/scene/SurfacePicking.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

constexpr ImageSize kFinishPicture{320, 320};

Project finishedProject(Finish finish) {
    Project project = starterProject();
    project.materials[0].finish = finish;
    project.materials[0].outside = {0.35, 0.35, 0.35};
    return project;
}

/// From the front, in parallel projection, a square of a width in m in the middle of the wall.
RenderView closeView(const RenderScene& scene, double width) {
    RenderView view{.size = kFinishPicture};
    view.camera.projection = Projection::Orthographic;
    const Vec3 middle = boundsOf(scene).centre();
    view.camera = framing(view.camera, Box3{middle - 0.5 * width, middle + 0.5 * width}, kFinishPicture);
    view.settings.hasEdges = view.settings.hasShadows = view.settings.hasOverlays = false;
    view.settings.msaa = 1;
    return view;
}

Image finishPicture(const RenderScene& scene, const RenderView& view) {
    return renderImage(std::make_shared<RenderScene>(scene), view, 0).value();
}

int channel(const Image& image, int x, int y, int which) {
    return image.pixels[static_cast<std::size_t>(3 * (y * image.width + x) + which)];
}

}  // namespace

class FinishPictureTest : public QObject {
    Q_OBJECT
private slots:
    void everyFinishIsSeen_data() {
        QTest::addColumn<int>("finish");
        for (std::size_t k = 1; k < kFinishNames.size(); ++k)
            QTest::newRow(std::string(kFinishNames[k]).c_str()) << static_cast<int>(k);
    }
    void everyFinishIsSeen() {
        QFETCH(int, finish);
        const Project project = finishedProject(static_cast<Finish>(finish)), plain = finishedProject(Finish::Plain);
        const SceneOptions apart{.asset = project.assets[0].id, .explodeFactor = 0.3};
        const RenderScene with = sceneOf(project, bakesOf(project).value(), apart);
        const RenderScene without = sceneOf(plain, bakesOf(plain).value(), apart);
        RenderView view = closeView(with, 1.5);
        view.camera = orbited(view.camera, 0.6, 0.4);
        QVERIFY(finishPicture(with, view).pixels != finishPicture(without, view).pixels);
    }
    void otherColouringsHaveNoFinish() {
        const Project project = finishedProject(Finish::Brick);
        const SceneOptions options{.asset = project.assets[0].id, .colouring = SceneColouring::Volume};
        for (const SceneBatch& batch : sceneOf(project, bakesOf(project).value(), options).batches)
            QVERIFY(batch.finish == AssetFinish{});
    }
    /// Nothing moves when it breaks: away from cracks, fragments have the colours of the whole.
    void fragmentsHaveThePatternOfTheWhole() {
        for (const Finish finish : {Finish::Brick, Finish::Wood, Finish::Stone}) {
            const Project project = finishedProject(finish);
            const AssetBakes bakes = bakesOf(project).value();
            SceneOptions options{.asset = project.assets[0].id};
            const RenderScene fragments = sceneOf(project, bakes, options);
            options.isWhole = true;
            const RenderScene whole = sceneOf(project, bakes, options);
            RenderView view = closeView(fragments, 1.2);
            view.minFragmentPixels = 0.0;
            const Image broken = finishPicture(fragments, view), intact = finishPicture(whole, view);
            Random random(static_cast<std::uint64_t>(finish));
            const auto bodyAt = [&](double x, double y) {
                const auto hit = surfaceHit(fragments, rayThrough(view.camera, {x, y}, kFinishPicture));
                return hit ? hit->body : kNone;
            };
            int points = 0;
            while (points < 1000) {
                const int x = static_cast<int>(random.between(8.0, 312.0)),
                          y = static_cast<int>(random.between(8.0, 312.0));
                const std::uint32_t body = bodyAt(x + 0.5, y + 0.5);
                bool isInside = body != kNone;
                for (int k = 0; k < 8 && isInside; ++k)
                    isInside = bodyAt(x + 0.5 + 7.0 * std::cos(0.785 * k), y + 0.5 + 7.0 * std::sin(0.785 * k)) == body;
                if (!isInside) continue;
                ++points;
                for (int c = 0; c < 3; ++c)
                    QVERIFY2(std::abs(channel(broken, x, y, c) - channel(intact, x, y, c)) <= 2,
                             qPrintable(QString("%1 at %2, %3").arg(static_cast<int>(finish)).arg(x).arg(y)));
            }
        }
    }
    /// Baked textures look as pictures do: brightness follows the formula of core/asset/finish, besides the relief.
    void pictureFollowsTheFormula() {
        for (const Finish finish : {Finish::Brick, Finish::Wood, Finish::Concrete, Finish::Tiles}) {
            const Project project = finishedProject(finish);
            SceneOptions options{.asset = project.assets[0].id};
            options.isWhole = true;
            const RenderScene scene = sceneOf(project, bakesOf(project).value(), options);
            const RenderView view = closeView(scene, 0.5);
            const Image image = finishPicture(scene, view);
            Random random(7);
            double x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
            constexpr int kPoints = 2000;
            for (int k = 0; k < kPoints; ++k) {
                const int column = static_cast<int>(random.between(4.0, 316.0)),
                          row = static_cast<int>(random.between(4.0, 316.0));
                const auto hit = surfaceHit(scene, rayThrough(view.camera, {column + 0.5, row + 0.5}, kFinishPicture));
                QVERIFY(hit);
                Vec3 point = hit->point - scene.origin - Vec3(scene.poses[0].position) + Vec3((*scene.restOffsets)[0]);
                const FinishParameters& parameters = finishParameters(finish, FinishSide::Outside);
                const FinishedSurface surface =
                    finishedSurface(parameters, point, Vec3(0.0, 0.0, 1.0), Vec3(0.1), scene.batches[0].finish.frame);
                const double shown = channel(image, column, row, 1), expected = std::sqrt(surface.albedo.y);
                x += shown, y += expected, xx += shown * shown, yy += expected * expected, xy += shown * expected;
            }
            const double correlation =
                (kPoints * xy - x * y) / std::sqrt((kPoints * xx - x * x) * (kPoints * yy - y * y));
            QVERIFY2(correlation > 0.65, qPrintable(QString("%1: %2").arg(static_cast<int>(finish)).arg(correlation)));
        }
    }
};

RUBBLE_TEST(FinishPictureTest)
#include "FinishPictureTest.moc"
