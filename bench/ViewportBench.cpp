// Measures the stages from an edited seed to its image: building the scene of a new bake, rebuilding it when only the
// explode factor changed, uploading it, drawing it, and picking. In play, with moving fragments: building a scene (on
// the physics thread), preparing its first frame (in the window, besides drawing), and preparing another frame of the
// same step. Wall-clock times; images of 1280 x 720 with any driver that EGL finds, in software without a GPU.
#include "bench/MovingFragments.h"
#include "bench/RatioReporter.h"
#include "viewport/render/Renderer.h"
#include "viewport/render/gl/RenderTarget.h"
#include "viewport/render/gl/SurfacelessContext.h"
#include "viewport/scene/SurfacePicking.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <epoxy/gl.h>

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr ImageSize kSize{1280, 720};

/// A project with one box, and bakes of it with different seeds.
struct Boxes {
    Project project;
    std::vector<AssetBakes> bakes;
};

Boxes boxes(std::size_t solids) {
    Boxes made;
    made.project.nextId = 10;
    made.project.materials = {{.id = 2, .name = "stone"}};
    for (const Asset& asset : boxAssets(solids)) {
        AssetBakes bakes{{{asset.id}, std::make_shared<const Bake>(bake(asset).value())}};
        made.bakes.push_back(std::move(bakes));
        made.project.assets = {asset};
        if (made.bakes.size() == 2) break;
    }
    made.project.assets[0].material = 2;
    made.project.instances = {{.id = 3, .name = "box", .asset = made.project.assets[0].id}};
    return made;
}

/// A renderer with its context and a target.
struct Stage {
    std::unique_ptr<SurfacelessContext> context = SurfacelessContext::create().value();
    std::unique_ptr<Renderer> renderer = Renderer::create().value();
    RenderTarget target{kSize, PixelFormat::Colour, 1};
};

RenderView viewOf(const RenderScene& scene, int msaa) {
    RenderView view{.camera = orbited({}, 0.6, 0.4), .size = kSize};
    view.settings.msaa = msaa;
    view.camera = framing(view.camera, boundsOf(scene), kSize);
    return view;
}

void buildScene(benchmark::State& state) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    SceneBuilder builder;
    std::size_t index = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(builder.sceneOf(made.project, made.bakes[index++ % made.bakes.size()], {}));
    }
}

void explodeScene(benchmark::State& state) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    SceneBuilder builder;
    double exploded = 0.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(builder.sceneOf(made.project, made.bakes[0], {.explodeFactor = exploded += 1e-3}));
    }
}

void uploadScene(benchmark::State& state) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    const auto first = std::make_shared<const RenderScene>(sceneOf(made.project, made.bakes[0]));
    const auto second = std::make_shared<const RenderScene>(sceneOf(made.project, made.bakes[1]));
    Stage stage;
    bool isFirst = false;
    for (auto _ : state) {
        stage.renderer->setScene((isFirst = !isFirst) ? first : second);
        glFinish();
    }
}

/// Draws while the camera orbits.
void drawOrbiting(benchmark::State& state, int msaa) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    const auto scene =
        std::make_shared<const RenderScene>(sceneOf(made.project, made.bakes[0], {.explodeFactor = 0.2}));
    Stage stage;
    stage.renderer->setScene(scene);
    RenderView view = viewOf(*scene, msaa);
    const auto drawOnce = [&] {
        view.camera = orbited(view.camera, 0.01, 0.0);
        stage.renderer->draw(view, stage.target.framebuffer());
        glFinish();
    };
    drawOnce();  // warms up: shadows, and what drivers defer to the first frame
    for (auto _ : state) drawOnce();
}
void drawPlain(benchmark::State& state) { drawOrbiting(state, 1); }
void drawMsaa(benchmark::State& state) { drawOrbiting(state, 4); }

void pick(benchmark::State& state) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    const auto scene = std::make_shared<const RenderScene>(sceneOf(made.project, made.bakes[0]));
    RenderView view = viewOf(*scene, 1);
    const Vec2 middle(kSize.width / 2, kSize.height / 2);
    for (auto _ : state) {
        view.camera = orbited(view.camera, 0.01, 0.0);
        benchmark::DoNotOptimize(surfaceHit(*scene, rayThrough(view.camera, middle, kSize)));
    }
}

/// Without the step itself.
void buildPlayScene(benchmark::State& state) {
    const auto scene = boxesInTheAir(static_cast<std::size_t>(state.range(0)));
    Session session = brokenBoxes(scene);
    SessionSceneBuilder builder(scene);
    for (auto _ : state) {
        state.PauseTiming();
        session.step();
        state.ResumeTiming();
        benchmark::DoNotOptimize(builder.sceneOf(session));
    }
}

/// The scenes of a whole and, step by step, of its fragments.
std::vector<std::shared_ptr<const RenderScene>> scenesOfAFall(std::size_t solids) {
    const auto scene = boxesInTheAir(solids);
    SessionSceneBuilder builder(scene);
    std::vector<std::shared_ptr<const RenderScene>> scenes{builder.sceneOf(Session::start(scene, {}).value())};
    Session session = brokenBoxes(scene);
    for (int k = 0; k < 6; ++k) {
        scenes.push_back(builder.sceneOf(session));
        session.step();
    }
    return scenes;
}

/// Uploads a new scene.
void prepareFrame(benchmark::State& state) {
    const auto scenes = scenesOfAFall(static_cast<std::size_t>(state.range(0)));
    Stage stage;
    RenderView view = viewOf(*scenes[0], 1);
    const auto drawNext = [&](const std::shared_ptr<const RenderScene>& next) {
        stage.renderer->setScene(next);
        stage.renderer->draw(view, stage.target.framebuffer());
        glFinish();
    };
    drawNext(scenes[0]);
    RenderCounts before = stage.renderer->counts();
    drawNext(scenes[1]);
    const RenderCounts& now = stage.renderer->counts();
    state.counters["geometry bytes at a swap"] = static_cast<double>(now.geometryBytes - before.geometryBytes);
    state.counters["body bytes"] = static_cast<double>(now.bodyBytes - before.bodyBytes);
    state.counters["draw calls"] = static_cast<double>(now.drawCalls - before.drawCalls);
    std::size_t index = 2;
    for (auto _ : state) {
        stage.renderer->setScene(scenes[index]);
        state.PauseTiming();
        view.stepFraction = 0.5;
        stage.renderer->draw(view, stage.target.framebuffer());
        glFinish();
        index = index + 1 < scenes.size() ? index + 1 : 2;
        state.ResumeTiming();
    }
}

void add(const char* name, void (*measure)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, measure)
        ->Arg(1'000)
        ->Arg(10'000)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

/// In play, with 20,000 moving fragments; each iteration also steps or draws outside the measurement, so there are few.
void addPlay(const char* name, void (*measure)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, measure)
        ->Arg(20'000)
        ->Iterations(60)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

}  // namespace

int main(int argc, char** argv) {
    add("new scene", buildScene);
    add("exploded", explodeScene);
    add("upload", uploadScene);
    add("picture", drawPlain);
    add("picture, 4x MSAA", drawMsaa);
    add("first pick", pick);
    addPlay("moment", buildPlayScene);
    addPlay("frame prepared", prepareFrame);
    RatioReporter reporter(
        "solids",
        {"new scene", "exploded", "upload", "picture", "picture, 4x MSAA", "first pick", "moment", "frame prepared"},
        {});
    return runBenchmarks(argc, argv, reporter);
}
