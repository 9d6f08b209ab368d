// How long a box takes from seeds to files: ours bakes it and writes OBJ and pack.json to memory, Blender's Cell
// Fracture only makes the cells.
//
//   BlenderBench BLENDER CELL_FRACTURE.PY [Google Benchmark option]...
#include "bench/BoxAssets.h"
#include "bench/RatioReporter.h"
#include "core/asset/bake/Bake.h"
#include "core/asset/mesh/FragmentMesh.h"
#include "core/io/exchange/ObjFile.h"
#include "core/io/output/ExportFolder.h"
#include "core/io/pack/PackFile.h"

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

void measureBlender(benchmark::State& state, const Peer& peer) {
    const auto path = writtenSeeds(seedSets(static_cast<std::size_t>(state.range(0)))[0]);
    const std::string command = "'" + peer.program + "' --background --factory-startup --python '" + peer.script +
                                "' -- '" + path.string() + "'";
    for (auto _ : state) {
        std::FILE* output = popen(command.c_str(), "r");
        if (output == nullptr) fail("cannot start " + peer.program + ".");
        double seconds = 0.0;
        char line[512];
        while (std::fgets(line, sizeof line, output) != nullptr) std::sscanf(line, "cell_fracture %*d %lf", &seconds);
        if (pclose(output) != 0 || seconds == 0.0) fail("Blender's Cell Fracture did not say how long it took.");
        state.SetIterationTime(seconds);
    }
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
    std::filesystem::remove_all(kMemory);
    return code;
}
