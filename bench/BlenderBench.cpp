// How long a box takes from seeds to files: ours bakes it and writes OBJ and pack.json to memory, Blender's Cell
// Fracture only makes the cells. Then how long a closed mesh takes to be cut into cells with collision hulls.
//
//   BlenderBench BLENDER CELL_FRACTURE.PY [Google Benchmark option]...
#include "bench/BoxAssets.h"
#include "bench/RatioReporter.h"
#include "bench/Timing.h"
#include "core/asset/bake/Bake.h"
#include "core/asset/mesh/FragmentMesh.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/solid/SolidHulls.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "core/io/exchange/ObjFile.h"
#include "core/io/output/ExportFolder.h"
#include "core/io/pack/PackFile.h"
#include "tests/support/geometry/SolidShapes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace rubble;
using namespace rubble::bench;

namespace {

const std::filesystem::path kMemory = "/dev/shm/rubble-bench";
const Material kStone{.id = 1, .name = "stone"};
constexpr double kVolume = 0.5, kVolumeTolerance = 1e-9;

/// What Blender is started with.
struct Peer {
    std::string program;
    std::string script;
};

[[noreturn]] void fail(const std::string& sentence) {
    std::fprintf(stderr, "BlenderBench: %s\n", sentence.c_str());
    std::exit(1);
}

std::string objOf(const Bake& bake, const Asset& asset) {
    const FragmentMesher mesher(asset);
    std::vector<MeshPart> parts;
    parts.reserve(bake.fragmentCount());
    for (std::uint32_t i = 0; i < bake.fragmentCount(); ++i) {
        const BakedFragment fragment = bake.fragment(i);
        parts.push_back({fragmentBodyName(packNames(asset), bake.fragmentId(i)), mesher.fragmentMesh(fragment),
                         fragment.solid.offset()});
    }
    return objFile(parts, meshMaterials(asset, kStone), PartPlacement::Assembled, "box.mtl");
}

/// From seeds to files; gives the volume of all pieces.
double exported(const Asset& asset) {
    const Bake bake = rubble::bake(asset).value();
    const std::vector<PackMeshFile> meshes{{.name = "box.obj"}};
    const PackInput input{bake, asset, kStone, packNames(asset), {}};
    const std::vector<ExportFile> files{{"box.obj", objOf(bake, asset)},
                                        {"box.mtl", mtlFile(meshMaterials(asset, kStone))},
                                        {kPackName, packJson(PackBuilder(input), meshes)}};
    const Status written =
        writeExportFolder(kMemory / "box", packHashes(asset, kStone, input.names, {}, meshes).all, files);
    if (!written) fail(written.error().message);
    double volume = 0.0;
    for (std::uint32_t i = 0; i < bake.fragmentCount(); ++i) volume += bake.fragment(i).solid.volume();
    return volume;
}

void measureOurs(benchmark::State& state) {
    InputRotation<Asset> assets(boxAssets(static_cast<std::size_t>(state.range(0))));
    double volume = exported(assets.next());
    for (auto _ : state) volume = exported(assets.next());
    if (std::abs(volume - kVolume) > kVolumeTolerance) fail("the volumes sum to " + std::to_string(volume) + " m^3.");
}

std::filesystem::path writtenSeeds(const SeedList& seeds) {
    const std::filesystem::path path = kMemory / "seeds.json";
    std::ofstream file(path);
    file.precision(17);
    for (std::size_t i = 0; i < seeds.size(); ++i)
        file << (i == 0 ? "[[" : ",[") << seeds[i].x << ',' << seeds[i].y << ']';
    file << ']';
    return path;
}

/// What Blender made.
struct CellFracture {
    double seconds = 0.0;
    int cells = 0;
    double volume = 0.0;  // m³, of them
};

CellFracture brokenByBlender(const Peer& peer, const std::filesystem::path& input) {
    const std::string command = "'" + peer.program + "' --background --factory-startup --python '" + peer.script +
                                "' -- '" + input.string() + "'";
    std::FILE* output = popen(command.c_str(), "r");
    if (output == nullptr) fail("cannot start " + peer.program + ".");
    CellFracture made;
    char line[512];
    while (std::fgets(line, sizeof line, output) != nullptr)
        std::sscanf(line, "cell_fracture %*d %lf %d %lf", &made.seconds, &made.cells, &made.volume);
    if (pclose(output) != 0 || made.seconds == 0.0) fail("Blender's Cell Fracture did not say how long it took.");
    return made;
}

void measureBlender(benchmark::State& state, const Peer& peer) {
    const auto path = writtenSeeds(seedSets(static_cast<std::size_t>(state.range(0)))[0]);
    for (auto _ : state) state.SetIterationTime(brokenByBlender(peer, path).seconds);
}

std::filesystem::path writtenMesh(const TriangleMesh& mesh, const std::vector<Vec3>& seeds) {
    const std::filesystem::path path = kMemory / "mesh.json";
    std::ofstream file(path);
    file.precision(17);
    const auto list = [&](const char* key, const auto& triples) {
        file << '"' << key << "\":[";
        for (std::size_t k = 0; k < triples.size(); ++k) {
            const auto& triple = triples[k];
            file << (k == 0 ? "[" : ",[") << triple[0] << ',' << triple[1] << ',' << triple[2] << ']';
        }
        file << ']';
    };
    file << '{';
    list("points", mesh.points);
    file << ',';
    list("triangles", mesh.triangles);
    file << ',';
    list("seeds", seeds);
    file << '}';
    return path;
}

/// A closed mesh, whose cells ours cuts exactly and gives collision hulls, on one thread.
void compareMeshes(const Peer& peer) {
    constexpr int kRounds = 5;
    const TriangleMesh mesh = test::bumpySphere(72);
    const std::vector<Vec3> seeds = test::seedsInBox(mesh, 100, 7);
    std::printf(
        "\n| bumpy sphere, %zu triangles, 100 seeds | processor, ms | cells | volume, m^3 of %.6f |\n| --- | --- | --- "
        "| --- |\n",
        mesh.triangles.size(), signedVolume(mesh));
    double fastest = 1e300, volume = 0.0;
    std::uint32_t fragments = 0;
    for (int round = 0; round < kRounds; ++round) {
        fastest = std::min(fastest, processorMillisecondsOf([&] {
                               const SolidPartition partition = *cutSolid(mesh, seeds);
                               if (!fragmentHulls(partition)) fail("ours has no hulls.");
                               fragments = partition.fragmentCount();
                               volume = 0.0;
                               for (const double one : partition.volumes) volume += one;
                           }));
    }
    std::printf("| ours, cut and hulls | %.0f | %u | %.6f |\n", fastest, fragments, volume);
    const CellFracture blender = brokenByBlender(peer, writtenMesh(mesh, seeds));
    std::printf("| Blender, Cell Fracture | %.0f | %d | %.6f |\n| Blender : ours | %.1f | | |\n",
                1000.0 * blender.seconds, blender.cells, blender.volume, 1000.0 * blender.seconds / fastest);
}

template <class Measure>
benchmark::internal::Benchmark* add(const char* name, Measure measure) {
    return benchmark::RegisterBenchmark(name, measure)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) fail("usage: BlenderBench BLENDER CELL_FRACTURE.PY [Google Benchmark option]...");
    const Peer peer{argv[1], argv[2]};
    std::filesystem::create_directories(kMemory);
    add("ours", measureOurs);
    add("Blender", [&peer](benchmark::State& state) { measureBlender(state, peer); })
        ->UseManualTime()
        ->Iterations(1)
        ->Repetitions(1);
    RatioReporter reporter("cells", {"ours", "Blender"}, {{"Blender", "ours"}});
    argv[2] = argv[0];
    const int code = runBenchmarks(argc - 2, argv + 2, reporter);
    compareMeshes(peer);
    std::filesystem::remove_all(kMemory);
    return code;
}
