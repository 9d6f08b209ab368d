// How long meshes of a million triangles take to be judged, cut and given hulls, the memory of it, and how soon each of
// them returns when it is cancelled.
//
//   LargeMeshBench
#include "bench/Timing.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/solid/SolidHulls.h"
#include "core/geometry/mesh/MeshVerdict.h"
#include "tests/support/geometry/SolidShapes.h"

#include <sys/resource.h>

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <thread>

using namespace rubble;
using namespace rubble::bench;
using namespace rubble::test;

namespace {

constexpr int kRings = 708;  // of the bumpy sphere: 1,001,112 triangles
constexpr int kCancellations = 40;

using Work = std::function<void(const TaskContext&)>;

/// The mesh with some points pulled through their neighbours' triangles.
TriangleMesh withSpikes(TriangleMesh mesh, std::size_t count) {
    const std::size_t apart = mesh.points.size() / (count + 2);
    for (std::size_t k = 1; k <= count; ++k) {
        Vec3& point = mesh.points[k * apart];
        point += 1.5 * (mesh.points[k * apart + 3] - point);
    }
    return mesh;
}

double processorMillisecondsOfThread(pthread_t thread) {
    clockid_t clock{};
    pthread_getcpuclockid(thread, &clock);
    timespec time{};
    clock_gettime(clock, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

struct Latency {
    double clock = 0.0, processor = 0.0;  // ms
    double at = 0.0;                      // of the work, where the processor took longest
};

/// From the cancellation of work on one thread, at a time of its processor, to its return.
Latency latencyAt(const Work& work, double milliseconds) {
    TaskContext task;
    double end = 0.0;
    std::chrono::steady_clock::time_point ended;
    std::thread thread([&] {
        work(task);
        ended = std::chrono::steady_clock::now();
        end = processorMillisecondsOfThread(pthread_self());
    });
    while (processorMillisecondsOfThread(thread.native_handle()) < milliseconds)
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    const double start = processorMillisecondsOfThread(thread.native_handle());
    const auto cancelled = std::chrono::steady_clock::now();
    task.cancel.cancel();
    thread.join();
    return {std::chrono::duration<double, std::milli>(ended - cancelled).count(), end - start, milliseconds};
}

void measure(const char* name, const Work& work) {
    rusage usage{};
    const double processor = processorMillisecondsOf([&] { work({}); });
    const double clock = millisecondsOf([&] { work({}); });
    getrusage(RUSAGE_SELF, &usage);
    Latency worst;
    for (int k = 0; k < kCancellations; ++k) {
        const Latency one = latencyAt(work, 0.97 * processor * (k + 0.5) / kCancellations);
        worst.clock = std::max(worst.clock, one.clock);
        if (one.processor > worst.processor) worst.processor = one.processor, worst.at = one.at / processor;
    }
    std::printf("| %s | %.0f | %.0f | %ld | %.1f | %.1f | %.2f |\n", name, processor, clock, usage.ru_maxrss / 1024,
                worst.processor, worst.clock, worst.at);
    std::fflush(stdout);
}

void judge(const TriangleMesh& mesh, const TaskContext& task) {
    const Result<MeshVerdict> verdict = judgeMesh(mesh, task);
    if (verdict && !verdict->isFit()) std::fprintf(stderr, "%s\n", verdict->findings[0].message.c_str());
}

}  // namespace

int main() {
    const TriangleMesh mesh = bumpySphere(kRings);
    const TriangleMesh crossed = withSpikes(mesh, 1000);
    const std::vector<Vec3> seeds = seedsInBox(mesh, 1000, 7);
    std::printf(
        "%zu triangles, one thread; cancelled at %d times.\n\n"
        "| work | processor, ms | clock, ms | peak so far, MiB | latency, processor, ms (at most 50) | clock, ms | at "
        "|\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n",
        mesh.triangles.size(), kCancellations);
    measure("verdict", [&](const TaskContext& task) { judge(mesh, task); });
    measure("verdict, 1000 spikes through their neighbours", [&](const TaskContext& task) { judge(crossed, task); });
    measure("cut into 1000 cells", [&](const TaskContext& task) { static_cast<void>(cutSolid(mesh, seeds, task)); });
    const Result<SolidPartition> partition = cutSolid(mesh, seeds);
    measure("hulls of 1000 cells",
            [&](const TaskContext& task) { static_cast<void>(fragmentHulls(*partition, {}, task)); });
    measure("hulls of the whole", [&](const TaskContext& task) { static_cast<void>(coarseHulls(mesh, 32, task)); });
    return 0;
}
