// Repeats the measurements of chapter 5 of the thesis, with its method and ours where both exist. Writes CSV files into
// a folder, for tools/evaluate to plot.
//
//   Evaluation FOLDER
#include "app/thesis/ThesisMethod.h"
#include "bench/Timing.h"
#include "core/base/Percentile.h"
#include "core/base/Random.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "core/play/session/Session.h"
#include "tests/support/asset/House.h"
#include "viewport/render/Renderer.h"
#include "viewport/render/gl/RenderTarget.h"
#include "viewport/render/gl/SurfacelessContext.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <epoxy/gl.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

using namespace rubble;
using bench::millisecondsOf;

namespace {

constexpr int kRuns = 10;  // as the thesis
constexpr std::uint32_t kMaxSeeds = 100;
const Ring kSquare = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};

std::vector<Vec2> seedsOf(std::uint32_t count, std::uint64_t run) {
    Random random(mixSeeds(count, run));
    std::vector<Vec2> seeds;
    for (std::uint32_t k = 0; k < count; ++k) seeds.push_back({random.unit(), random.unit()});
    return seeds;
}

/// Figure 3: the mean of ten runs with different seeds.
void measureVoronoi(const std::filesystem::path& file) {
    std::ofstream csv(file);
    csv << "seeds,ours,thesis\n";
    for (std::uint32_t count = 1; count <= kMaxSeeds; ++count) {
        double ours = 0.0, thesis = 0.0;
        for (int run = -1; run < kRuns; ++run) {  // the first warms up memory
            const std::vector<Vec2> seeds = seedsOf(count, static_cast<std::uint64_t>(run + 1));
            const double one = millisecondsOf([&] { static_cast<void>(voronoiPartition({kSquare, {}}, seeds)); });
            const double other = millisecondsOf([&] { static_cast<void>(thesisDiagram(kSquare, seeds)); });
            if (run >= 0) ours += one / kRuns, thesis += other / kRuns;
        }
        csv << count << ',' << ours << ',' << thesis << '\n';
    }
}

Session houseOf(std::uint32_t pieces) {
    Project project = test::house();
    for (PatternLayer& layer : project.assets[0].pattern.layers) {
        if (auto* scatter = std::get_if<UniformScatter>(&layer.parameters)) scatter->count = pieces;
    }
    return std::move(*Session::start(*playScene(project)));
}

/// Figure 4: the swap of one wall of the house, and that step as a whole; the median of ten runs.
void measureSwap(const std::filesystem::path& file) {
    std::ofstream csv(file);
    csv << "fragments,swap,step\n";
    for (std::uint32_t pieces = 10; pieces <= kMaxSeeds; pieces += 10) {
        Session session = houseOf(pieces);
        for (int k = 0; k < 10; ++k) session.step();
        const auto standing = session.snapshot();
        std::vector<double> swaps, steps;
        for (int run = 0; run < kRuns; ++run) {
            session.restore(*standing);
            static_cast<void>(session.add(BreakInput{session.bodies()[1].number}));
            steps.push_back(millisecondsOf([&] { session.step(); }));
            swaps.push_back(session.events().breaks[0].milliseconds);
        }
        csv << pieces << ',' << percentile(swaps, 0.5) << ',' << percentile(steps, 0.5) << '\n';
    }
}

/// Renders pictures of a session and measures their time.
class Frames {
public:
    explicit Frames(std::shared_ptr<const PlayScene> scene) : m_moments(std::move(scene)) {
        m_view.camera = framing(orbited({}, 0.6, 0.4), {Vec3(-6.0, 0.0, -6.0), Vec3(6.0, 6.0, 6.0)}, kSize);
    }

    const char* renderer() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }
    /// Time to build and upload the scene, ms.
    double prepare(const Session& session) {
        return millisecondsOf([&] {
            m_renderer->setScene(m_moments.sceneOf(session));
            glFinish();
        });
    }
    double draw() {
        return millisecondsOf([&] {
            m_renderer->draw(m_view, m_target.framebuffer());
            glFinish();
        });
    }

private:
    static constexpr ImageSize kSize{1280, 720};

    std::unique_ptr<SurfacelessContext> m_context = std::move(*SurfacelessContext::create());
    std::unique_ptr<Renderer> m_renderer = std::move(*Renderer::create());
    RenderTarget m_target{kSize, PixelFormat::Colour, 1};
    RenderView m_view{.size = kSize};
    SessionSceneBuilder m_moments;
};

/// Figure 5: walls of the house are thrown onto a pile one after the other and break.
void measureSteps(const std::filesystem::path& folder) {
    constexpr int kBodies = 600, kStepsBetween = 12;
    Project project = test::house();
    const Id wall = project.assets[0].id;
    project.instances.clear();
    project.playTests.clear();  // which refer to the shots
    const std::shared_ptr<const PlayScene> scene = *playScene(project);
    Result<Session> session = Session::start(scene, {.sleeping = false});
    Frames frames(scene);
    std::ofstream(folder / "renderer.txt") << frames.renderer() << '\n';
    std::ofstream csv(folder / "steps.csv");
    csv << "bodies,pairs,points,step,moment,frame\n";
    Random random(1);
    std::vector<double> times;
    for (int body = 0; body < kBodies; ++body) {
        const Vec3 aim{random.between(-2.0, 2.0), 0.0, random.between(-2.0, 2.0)};
        static_cast<void>(session->add(ShotInput{"wall", Throw{.kind = ProjectileKind::Asset,
                                                               .asset = wall,
                                                               .from = aim + Vec3(0.0, 14.0, 0.0),
                                                               .to = aim,
                                                               .speed = 10.0}}));
        for (int k = 0; k < kStepsBetween; ++k) times.push_back(millisecondsOf([&] { session->step(); }));
        if ((body + 1) % 5 != 0) continue;
        const StepCounts counts = session->world().counts();
        csv << counts.bodies << ',' << counts.candidatePairs << ',' << counts.contactPoints << ','
            << percentile(times, 0.5);
        const double moment = frames.prepare(*session);
        csv << ',' << moment << ',' << moment + frames.draw() << '\n';
        times.clear();
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "Evaluation FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    measureVoronoi(folder / "voronoi.csv");
    measureSwap(folder / "swap.csv");
    measureSteps(folder);
    return 0;
}
