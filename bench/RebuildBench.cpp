// Measures how long an artist waits for a pattern: the time to compute the cells and the fragments of a wall of 500
// pieces, against painting the cells once; and how soon a bake of 50,000 pieces ends after it is cancelled at a random
// moment. Runs without a display.
#include "bench/PatternAssets.h"
#include "bench/Timing.h"
#include "core/asset/bake/Bake.h"
#include "core/asset/bake/FractureResult.h"
#include "core/base/Percentile.h"
#include "core/base/Random.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/document/Bakes.h"

#include <QApplication>

#include <algorithm>
#include <cstdio>
#include <thread>

using namespace rubble;
using namespace rubble::bench;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kFew = 500, kMany = 50'000;
constexpr int kRuns = 40;
constexpr int kCancels = 25;
constexpr QSize kCanvas(1280, 800);  // pixels

template <class Work>
double medianOf(const Work& work) {
    std::vector<double> times;
    for (int run = 0; run < kRuns; ++run) times.push_back(millisecondsOf(work));
    return percentile(times, 0.5);
}

/// The time of a full repaint of an asset's cells, ms.
double repaintTime(const Asset& asset) {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = asset.material, .name = "stone"}};
    project.assets = {asset};
    Document document(project);
    Selection selection;
    Bakes bakes;
    BondPainter painter(document, selection);
    PatternCanvas canvas(document, selection, bakes, painter);
    selection.prune(document.project());
    PlanarFracture cut = planarFracture(recipeOf(asset), asset.prism(), {}).value();
    bakes.setPattern(asset.id,
                     std::make_shared<BakedPattern>(BakedPattern{.asset = std::make_shared<const Asset>(asset),
                                                                 .seeds = std::move(cut.seeds),
                                                                 .triangulation = std::move(cut.delaunay),
                                                                 .partition = std::move(cut.partition),
                                                                 .fault = {}}));
    canvas.resize(kCanvas);
    canvas.show();
    QCoreApplication::processEvents();  // paints the canvas
    canvas.fit();
    CanvasView view = canvas.view();
    int run = 0;
    return medianOf([&] {
        view.scale *= ++run % 2 == 0 ? 1.0 + 1e-9 : 1.0 - 1e-9;
        canvas.setView(view);
        canvas.repaint();
    });
}

void measureRebuild() {
    std::printf(
        "| 500 pieces | cells, ms | fragments, ms | painting, ms | cells : painting | fragments : painting |\n");
    std::printf("| --- | --- | --- | --- | --- | --- |\n");
    for (const auto& [name, asset] : patternAssets(kFew)) {
        const double cells = medianOf([&] { planarFracture(recipeOf(asset), asset.prism(), {}).value(); });
        const double fragments = medianOf([&] { bake(asset).value(); });
        const double painting = repaintTime(asset);
        std::printf("| %s | %.3f | %.3f | %.3f | %.2f | %.2f |\n", name.c_str(), cells, fragments, painting,
                    cells / painting, fragments / painting);
    }
}

/// The time from the cancellation of a bake to its end, ms.
double cancelLatency(const Asset& asset, double milliseconds) {
    const TaskContext task;
    Clock::time_point ended;
    std::thread worker([&] {
        (void)bake(asset, task);
        ended = Clock::now();
    });
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(milliseconds));
    const Clock::time_point cancelled = Clock::now();
    task.cancel.cancel();
    worker.join();
    return std::max(0.0, std::chrono::duration<double, std::milli>(ended - cancelled).count());
}

void measureCancel() {
    std::printf(
        "\n| 50,000 pieces | whole bake, ms | cancelled: median, ms | longest, ms |\n| --- | --- | --- | --- |\n");
    Random random(1);
    for (const auto& [name, asset] : patternAssets(kMany)) {
        const double whole = millisecondsOf([&] { bake(asset).value(); });
        std::vector<double> times;
        for (int k = 0; k < kCancels; ++k) times.push_back(cancelLatency(asset, whole * random.unit()));
        std::printf("| %s | %.0f | %.2f | %.2f |\n", name.c_str(), whole, percentile(times, 0.5),
                    *std::ranges::max_element(times));
    }
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication program(argc, argv);
    measureRebuild();
    measureCancel();
    return 0;
}
