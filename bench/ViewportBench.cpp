// What stands between a changed seed and its picture, and what a picture takes: making the scene of a new bake, making it
// again where nothing but its explosion changed, taking it to the card, drawing it, and finding the piece under the
// pointer. And in play, by moving fragments: making a moment, which is the physics thread's, preparing a frame of it, which
// is the window's beside drawing, and preparing one more frame within the same step. Wall-clock times; pictures of 1280 x 720 by whatever EGL finds, which is the processor where there is no card.
#include "bench/MovingFragments.h"
#include "bench/RatioReporter.h"
#include "viewport/render/RenderTarget.h"
#include "viewport/render/Renderer.h"
#include "viewport/render/SurfacelessContext.h"
#include "viewport/scene/MomentBuilder.h"

#include <epoxy/gl.h>

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr PictureSize kSize{1280, 720};

/// A project with one box, and some bakes of it that differ in their seeds.
struct Boxes {
    Project project;
    std::vector<AssetBakes> bakes;
};

Boxes boxes(std::size_t pieces) {
    Boxes made;
    made.project.nextId = 10;
    made.project.materials = {{.id = 2, .name = "stone"}};
    for (const Asset& asset : boxAssets(pieces)) {
        AssetBakes bakes{{{asset.id}, std::make_shared<const Bake>(bake(asset).value())}};
        made.bakes.push_back(std::move(bakes));
        made.project.assets = {asset};
        if (made.bakes.size() == 2) break;
    }
    made.project.assets[0].material = 2;
    made.project.instances = {{.id = 3, .name = "box", .asset = made.project.assets[0].id}};
    return made;
}

/// A renderer with its context and something to draw to.
struct Stage {
    std::unique_ptr<SurfacelessContext> context = SurfacelessContext::made().value();
    std::unique_ptr<Renderer> renderer = Renderer::made().value();
    RenderTarget target{kSize, PixelFormat::Colour, 1};
};

PictureView viewOf(const RenderScene& scene, int msaa) {
    PictureView view{.camera = orbited({}, 0.6, 0.4), .size = kSize};
    view.settings.msaa = msaa;
    view.camera = framing(view.camera, boundsOf(scene), kSize);
    return view;
}

void buildScene(benchmark::State& state) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    SceneBuilder builder;
    std::size_t turn = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(builder.sceneOf(made.project, made.bakes[turn++ % made.bakes.size()], {}));
    }
}

void explodeScene(benchmark::State& state) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    SceneBuilder builder;
    double exploded = 0.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(builder.sceneOf(made.project, made.bakes[0], {.exploded = exploded += 1e-3}));
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

/// Draws while the camera turns.
void drawTurning(benchmark::State& state, int msaa) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    const auto scene = std::make_shared<const RenderScene>(sceneOf(made.project, made.bakes[0], {.exploded = 0.2}));
    Stage stage;
    stage.renderer->setScene(scene);
    PictureView view = viewOf(*scene, msaa);
    const auto drawOnce = [&] {
        view.camera = orbited(view.camera, 0.01, 0.0);
        stage.renderer->draw(view, stage.target.framebuffer());
        glFinish();
    };
    drawOnce();  // shadows, and what drivers put off until the first picture
    for (auto _ : state) drawOnce();
}
void drawPlain(benchmark::State& state) { drawTurning(state, 1); }
void drawMsaa(benchmark::State& state) { drawTurning(state, 4); }

/// The first question after the camera moved; those that follow only read a pixel.
void pick(benchmark::State& state) {
    const Boxes made = boxes(static_cast<std::size_t>(state.range(0)));
    const auto scene = std::make_shared<const RenderScene>(sceneOf(made.project, made.bakes[0]));
    Stage stage;
    stage.renderer->setScene(scene);
    PictureView view = viewOf(*scene, 1);
    for (auto _ : state) {
        view.camera = orbited(view.camera, 0.01, 0.0);
        benchmark::DoNotOptimize(stage.renderer->bodyAt(view, kSize.width / 2, kSize.height / 2));
    }
}

/// What it takes beside the step itself.
void makeMoment(benchmark::State& state) {
    const auto scene = boxesInTheAir(static_cast<std::size_t>(state.range(0)));
    Session session = brokenBoxes(scene);
    MomentBuilder builder(scene);
    for (auto _ : state) {
        state.PauseTiming();
        session.step();
        state.ResumeTiming();
        benchmark::DoNotOptimize(builder.momentOf(session));
    }
}

/// A whole's moment, and those of its pieces after it, step by step.
std::vector<std::shared_ptr<const RenderScene>> momentsOfAFall(std::size_t pieces) {
    const auto scene = boxesInTheAir(pieces);
    MomentBuilder builder(scene);
    std::vector<std::shared_ptr<const RenderScene>> moments{builder.momentOf(Session::start(scene, {}).value())};
    Session session = brokenBoxes(scene);
    for (int k = 0; k < 6; ++k) {
        moments.push_back(builder.momentOf(session));
        session.step();
    }
    return moments;
}

/// Takes a new moment to the card.
void prepareFrame(benchmark::State& state) {
    const auto moments = momentsOfAFall(static_cast<std::size_t>(state.range(0)));
    Stage stage;
    PictureView view = viewOf(*moments[0], 1);
    const auto drawNext = [&](const std::shared_ptr<const RenderScene>& moment) {
        stage.renderer->setScene(moment);
        stage.renderer->draw(view, stage.target.framebuffer());
        glFinish();
    };
    drawNext(moments[0]);
    RenderCounts before = stage.renderer->counts();
    drawNext(moments[1]);
    const RenderCounts& now = stage.renderer->counts();
    state.counters["geometry bytes at a swap"] = static_cast<double>(now.geometryBytes - before.geometryBytes);
    state.counters["body bytes"] = static_cast<double>(now.bodyBytes - before.bodyBytes);
    state.counters["draw calls"] = static_cast<double>(now.drawCalls - before.drawCalls);
    std::size_t turn = 2;
    for (auto _ : state) {
        stage.renderer->setScene(moments[turn]);
        state.PauseTiming();
        view.moment = 0.5;
        stage.renderer->draw(view, stage.target.framebuffer());
        glFinish();
        turn = turn + 1 < moments.size() ? turn + 1 : 2;
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

/// In play, by 20,000 moving pieces; each turn steps or draws beside what is measured, so few turns are taken.
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
    addPlay("moment", makeMoment);
    addPlay("frame prepared", prepareFrame);
    RatioReporter reporter(
        "pieces",
        {"new scene", "exploded", "upload", "picture", "picture, 4x MSAA", "first pick", "moment", "frame prepared"},
        {});
    return runBenchmarks(argc, argv, reporter);
}
