// Measures the 3D view of a project: the images a second while the camera orbits and while the simulation runs, and the
// time from the last change to the refined picture at rest. Needs a display.
#include "core/io/project/ProjectFile.h"
#include "viewport/scene/SceneBuilder.h"
#include "viewport/scene/play/SessionSceneBuilder.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include <cstdio>
#include <functional>

using namespace rubble;

namespace {

constexpr QSize kView{1280, 720};
constexpr int kMotionMilliseconds = 4'000;
constexpr int kWarmUpMilliseconds = 1'000;  // until the resolution fits
constexpr double kOrbit = 0.02;             // rad for an image

/// Runs the event loop for some time.
void runFor(int milliseconds) {
    QTimer::singleShot(milliseconds, qApp, [] { QCoreApplication::exit(); });
    QApplication::exec();
}

/// Images a second while something is changed after each one.
double imagesASecond(ViewportWidget& viewport, const std::function<void()>& change) {
    int images = 0;
    const auto next = QObject::connect(&viewport, &ViewportWidget::drawn, qApp, [&] {
        ++images;
        QTimer::singleShot(0, qApp, change);
    });
    change();
    runFor(kWarmUpMilliseconds);
    images = 0;
    runFor(kMotionMilliseconds);
    QObject::disconnect(next);
    return 1000.0 * images / kMotionMilliseconds;
}

/// From now until the picture is refined, s.
double secondsToRest(ViewportWidget& viewport) {
    QElapsedTimer timer;
    timer.start();
    auto* refining = viewport.findChild<QOpenGLWidget*>()->findChild<QTimer*>();
    qint64 last = 0;  // ms, when it was still active
    while (timer.elapsed() - last < 500) {
        runFor(5);
        if (refining->isActive()) last = timer.elapsed();
    }
    return 1e-3 * static_cast<double>(last);
}

int measure(const char* path) {
    const Result<Project> project = loadProject(path);
    if (!project) return std::puts(project.error().message.c_str()), 1;
    AssetBakes bakes;
    for (const Asset& asset : project->assets) bakes[{asset.id}] = std::make_shared<const Bake>(bake(asset).value());
    ViewportWidget viewport;
    viewport.resize(kView);
    viewport.setProgressiveRendering(ProgressiveRendering::Always);
    viewport.setScene(std::make_shared<const RenderScene>(sceneOf(*project, bakes, {})));
    viewport.show();
    runFor(kWarmUpMilliseconds);
    const double orbiting =
        imagesASecond(viewport, [&] { viewport.setCamera(orbited(viewport.camera(), kOrbit, 0.0)); });
    const double rest = secondsToRest(viewport);
    const auto scene = playScene(*project).value();
    Session session = Session::start(scene).value();
    SessionSceneBuilder builder(scene);
    const double playing = imagesASecond(viewport, [&] {
        session.step();
        viewport.setScene(builder.sceneOf(session));
    });
    std::printf("| orbiting, images/s | playing, images/s | refined at rest after, s |\n| --- | --- | --- |\n");
    std::printf("| %.1f | %.1f | %.2f |\n", orbiting, playing, rest);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::puts("usage: MotionBench PROJECT"), 2;
    QApplication application(argc, argv);
    return measure(argv[1]);
}
